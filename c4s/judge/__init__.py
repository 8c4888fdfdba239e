"""Judges: they answer the claims of a requirement bundle and write judgements."""

__all__ = ["check", "desk", "model", "names", "registry"]
