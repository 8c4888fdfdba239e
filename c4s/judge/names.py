"""Names of the judges, apart from what they need to judge."""

from __future__ import annotations

from typing import Final

RULE: Final = "rule"
"""The offline rule judge."""
JUDGE_NAMES: Final = (RULE,)
DEFAULT_JUDGE: Final = RULE
"""Needs no network."""
