"""Code that runs inside an engine's Python, written once against the ``unreal`` module."""

__all__ = ["capture", "facts", "host", "identity", "levels", "navigation", "snapshot"]
