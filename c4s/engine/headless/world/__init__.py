"""The level that is open: actors, assets, documents."""

__all__ = ["documents", "state", "world"]
