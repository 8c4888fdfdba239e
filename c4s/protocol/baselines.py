"""The agents without a model that ship, and which of them only validate the evaluator."""

from __future__ import annotations

from typing import Final

ORACLE: Final = "oracle"
"""Reads the truth; the only client that is given the withheld folder."""
BLIND: Final = "blind"
"""Repairs without looking at a picture: what it reaches, a suite gives away."""
NOOP: Final = "noop"
BASELINES: Final = (NOOP, "random", "planner", "vandal", BLIND, ORACLE)
CHEATS: Final = (
    *("once", "dust", "pile", "ghost", "copies", "instances", "hidden", "parade", "heap", "buried", "lifted"),
)
"""Nonsense in place of a scene (``c4s.agents.cheats``): what each reaches, a judge gives away. Run when asked for."""
VALIDATING: Final = frozenset({ORACLE, BLIND, *CHEATS})
"""Clients that validate the evaluator or a suite and are never ranked."""
