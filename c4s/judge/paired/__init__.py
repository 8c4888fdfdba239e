"""Repairs beside their truth from held-out cameras: pairs of views, and what can be measured of two pictures."""

__all__ = ["judging", "measures", "pairs"]
