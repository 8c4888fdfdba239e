"""The numbers that a repair score is made of."""

from __future__ import annotations

from c4s.protocol.repair import PROFILES
from c4s.records.verdict import Verdict
from c4s.verify.verifier import Components, dotted, shares

_COUNTS, _RATES = ("tp", "fp", "fn"), ("precision", "recall", "f1")


def repair_components(verdict: Verdict) -> Components:
    """Counts and rates, and the rates of each tolerance profile as ``profiles.<name>.<rate>``."""
    profiles = verdict.measurements.get("profiles", {})
    made = shares(verdict.measurements, _RATES)
    made |= {name: float(verdict.measurements[name]) for name in _COUNTS if name in verdict.measurements}
    for name in PROFILES:
        made |= dotted(f"profiles.{name}", shares(profiles.get(name, {}), _RATES))
    return made
