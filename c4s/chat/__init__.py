"""Chat completions over HTTP with retries by class of error: for the agent loop of our own, and for judges."""

__all__ = ["client", "failures", "receiving", "replicas"]
