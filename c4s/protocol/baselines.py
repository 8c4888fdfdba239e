"""The agents without a model that ship, and which of them only validate the evaluator."""

from __future__ import annotations

from typing import Final

ORACLE: Final = "oracle"
"""Reads the truth; the only client that is given the withheld folder."""
BLIND: Final = "blind"
"""Repairs without looking at a picture: what it reaches, a suite gives away."""
BASELINES: Final = ("noop", "random", "planner", "vandal", BLIND, ORACLE)
VALIDATING: Final = frozenset({ORACLE, BLIND})
"""Clients that validate the evaluator or a suite and are never ranked."""
