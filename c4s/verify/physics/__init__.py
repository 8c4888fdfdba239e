"""Support and penetration."""

__all__ = ["batch", "edited", "support", "verdict", "verifier"]
