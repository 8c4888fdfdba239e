"""Engines: what opens, changes, looks at and exports a scene."""

from __future__ import annotations

from typing import Final

ENGINES: Final = ("headless",)
"""Names that a plan may give its engine."""

__all__ = ["ENGINES"]
