"""Transforms."""

__all__ = ["transform"]
