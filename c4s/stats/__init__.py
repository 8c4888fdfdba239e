"""Statistics of scores: arrays in, numbers out."""

__all__ = [
    "bootstrap",
    "difficulty",
    "drift",
    "human",
    "judges",
    "multiple",
    "navigation",
    "orders",
    "passes",
    "permutation",
    "power",
    "ranks",
    "reliability",
    "repeats",
    "selection",
    "stability",
    "variance",
]
