"""The agents without a model that ship, and which of them only validate the evaluator."""

from __future__ import annotations

from typing import Final

ORACLE: Final = "oracle"
"""Reads the truth; the only client that is given the withheld folder."""
BASELINES: Final = ("noop", "random", "planner", "vandal", ORACLE)
VALIDATING: Final = frozenset({ORACLE})
"""Clients that validate the evaluator and are never ranked."""
