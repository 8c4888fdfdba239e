"""The gate: whether a submission is measured at all."""

__all__ = ["verdict", "verifier"]
