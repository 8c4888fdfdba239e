"""Pictures of the level that is open."""

__all__ = ["keys", "lights", "take"]
