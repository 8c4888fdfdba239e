"""Categories of what is made here."""

from __future__ import annotations

DISHES, DECOR, LIGHTS, DESK = "tableware", "decor", "lighting", "desk things"
