"""The work pools by name."""

from __future__ import annotations

from typing import Final

POOLS: Final = {
    "coordinators": "flows that send work to the other pools, and pages; no engine",
    "engines": "attempts and evidence of trials; one engine a slot",
    "verifiers": "verifiers, scores and rows of trials",
    "judges": "requests of trials to a model judge",
}
"""Every pool, and what its workers do."""
