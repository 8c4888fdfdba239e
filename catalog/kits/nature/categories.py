"""Categories of what is made here."""

from __future__ import annotations

PLANTS, GROUND, ROCKS, ANIMALS = "plants", "ground", "rocks", "animals"
