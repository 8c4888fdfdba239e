"""Categories of what is made here."""

from __future__ import annotations

VEHICLES, BOATS, RAIL = "vehicles", "boats", "railway"
