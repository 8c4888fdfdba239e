"""The skill text: how to use the tools, in four parts, the same for all cases (paper, Coding-Agent Interface)."""

from __future__ import annotations

from functools import lru_cache
from importlib.resources import files

PARTS = ("1-retrieval.md", "2-python.md", "3-planning.md", "4-building.md")
"""Asset retrieval, editor Python, scene-graph planning, scene building."""


@lru_cache(maxsize=1)
def skill_text() -> str:
    """The four parts as one text."""
    folder = files("c4s.toolbox.skill")
    return "\n".join((folder / part).read_text(encoding="utf-8") for part in PARTS)


__all__ = ["files", "lru_cache", "skill_text"]
