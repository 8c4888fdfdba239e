"""Verifiers: evidence in, verdict out. ``registry`` is their one table."""

__all__ = ["actors", "integrity", "physics", "registry", "repair", "semantic"]
