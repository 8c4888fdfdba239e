"""What a scene holds in words and measures: pure, for judges."""

__all__ = ["boxes", "inventory", "kinds", "looks", "measures", "quantities", "views"]
