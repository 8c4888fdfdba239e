"""Paired views of repairs: a submission beside its truth from held-out cameras. Reported, never scored."""

__all__ = ["verifier"]
