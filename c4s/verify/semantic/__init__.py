"""Detailed and Overview Alignment, from judgements."""

__all__ = ["verifier"]
