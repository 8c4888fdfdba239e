"""What a scene holds in words and measures: pure, for judges."""

__all__ = [
    "binding",
    "boxes",
    "decision",
    "inventory",
    "kinds",
    "looks",
    "quantities",
    "relations",
    "shades",
    "sight",
    "state",
    "substance",
    "views",
]
