"""The trusted side: it starts engine processes and talks to them."""

__all__ = ["kernels", "session"]
