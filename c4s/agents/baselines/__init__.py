"""The agents without a model."""

__all__ = []
