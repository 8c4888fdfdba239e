"""The benchmark's rules and constants, once each: numbers in, numbers out."""

__all__ = [
    "baselines",
    "bundle",
    "case",
    "content",
    "detailed",
    "families",
    "numbers",
    "overview",
    "physics",
    "repair",
    "requirements",
    "rules",
    "settings",
    "words",
]
