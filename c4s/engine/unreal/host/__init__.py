"""The trusted side of a real editor: it finds it, makes its project, starts it, watches it and ends it."""

__all__ = ["inspection", "installation", "launch", "session", "warming"]
