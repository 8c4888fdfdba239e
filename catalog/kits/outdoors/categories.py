"""Categories of what is made here."""

from __future__ import annotations

STREET, FENCES, MARKET, PLAY, RUINS, ART = "street furniture", "fences", "market", "playground", "ruins", "monuments"
