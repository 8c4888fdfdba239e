"""Agents: what one is, programs of others, one of our own, and those without a model."""

__all__ = [
    "base",
    "baselines",
    "briefing",
    "by_stdio",
    "cheats",
    "clients",
    "connecting",
    "joining",
    "model",
    "outside",
    "replay",
]
