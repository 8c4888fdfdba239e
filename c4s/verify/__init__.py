"""Verifiers: evidence in, verdict out. ``registry`` is their one table."""

__all__ = ["actors", "faults", "integrity", "navigation", "paired", "physics", "registry", "repair", "semantic"]
