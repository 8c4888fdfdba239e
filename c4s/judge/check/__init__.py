"""Scoring of judges on claims of known truth: pure functions over what was said and what is so."""

__all__ = ["outcome", "report", "scoring"]
