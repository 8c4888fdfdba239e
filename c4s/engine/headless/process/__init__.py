"""The process beside agent code."""

__all__ = ["boot"]
