"""The benchmark's rules and constants, once each: numbers in, numbers out."""

__all__ = [
    "baselines",
    "bundle",
    "case",
    "content",
    "criteria",
    "detailed",
    "families",
    "graph",
    "navigation",
    "numbers",
    "overview",
    "paired",
    "physics",
    "repair",
    "requirements",
    "rules",
    "settings",
    "words",
]
