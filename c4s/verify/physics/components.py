"""The numbers that a physics score is made of."""

from __future__ import annotations

from c4s.protocol.rules import PHYSICS_LEAVES
from c4s.records.verdict import Verdict
from c4s.verify.verifier import Components, shares


def physics_components(verdict: Verdict) -> Components:
    """The safety of the two leaves: 1 is best."""
    leaves = verdict.measurements.get("leaves", {})
    return shares({name: leaves.get(name, {}).get("safety") for name in PHYSICS_LEAVES}, PHYSICS_LEAVES)
