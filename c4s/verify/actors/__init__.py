"""Actors of a snapshot as the verifiers read them."""

__all__ = ["collision", "difference", "entries", "kinds", "materials", "measured", "roles", "vectors"]
