"""The agents without a model."""

__all__ = ["blind", "palette", "scripting"]
