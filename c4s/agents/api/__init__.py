"""An agent of our own: a loop over an OpenAI-compatible endpoint."""

__all__ = []
