"""A level as one GLB file."""

__all__ = ["export"]
