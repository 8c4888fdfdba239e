"""Agent programs of others, one small file a client."""

__all__ = ["client"]
