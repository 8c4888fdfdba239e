"""The offline rule judge."""

__all__ = ["judging", "version"]
