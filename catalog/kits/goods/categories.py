"""Categories of what is made here."""

from __future__ import annotations

GOODS, MACHINES, TOOLS = "containers", "machines", "tools"
