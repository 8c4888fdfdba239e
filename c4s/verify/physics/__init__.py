"""Support and penetration."""

__all__ = ["batch", "support", "verdict", "verifier"]
