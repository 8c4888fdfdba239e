"""The Embodied Utility Score, reported apart from the benchmark score."""

__all__ = ["verdict", "verifier"]
