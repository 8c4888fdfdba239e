"""The numbers that a verdict's score is made of, by name. One function a verifier.

A number that was not measured is left out: it is for the case score to say what it is worth. Parts have dotted names.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from c4s.protocol.numbers import unit_number
from c4s.protocol.repair import PROFILES
from c4s.protocol.rules import OVERVIEW_WEIGHTS, PHYSICS_LEAVES
from c4s.records.verdict import Verdict

Components = dict[str, float]
_COUNTS, _RATES = ("tp", "fp", "fn"), ("precision", "recall", "f1")


def components(verdict: Verdict) -> Components:
    """The components of a verdict, its score among them as ``score``; that alone for a verifier that is not known."""
    own = COMPONENTS.get(verdict.verifier)
    return _shares({"score": verdict.score}, ["score"]) | (own(verdict) if own else {})


def integrity(verdict: Verdict) -> Components:
    """``valid``: 1 or 0."""
    return {"valid": float(verdict.status == "valid")} if verdict.status in ("valid", "invalid") else {}


def physics(verdict: Verdict) -> Components:
    """The safety of the two leaves: 1 is best."""
    leaves = verdict.measurements.get("leaves", {})
    return _shares({name: leaves.get(name, {}).get("safety") for name in PHYSICS_LEAVES}, PHYSICS_LEAVES)


def repair(verdict: Verdict) -> Components:
    """Counts and rates, and the rates of each tolerance profile as ``profiles.<name>.<rate>``."""
    profiles = verdict.measurements.get("profiles", {})
    made = _shares(verdict.measurements, _RATES)
    made |= {name: float(verdict.measurements[name]) for name in _COUNTS if name in verdict.measurements}
    for name in PROFILES:
        made |= _dotted(f"profiles.{name}", _shares(profiles.get(name, {}), _RATES))
    return made


def detailed(verdict: Verdict) -> Components:
    """Known coverage, and the score and known coverage of each requirement family that the prompt asks for."""
    made = _shares(verdict.measurements, ["known_coverage"])
    for name, family in verdict.measurements.get("families", {}).items():
        found = _shares(family, ("score", "known_coverage"))
        made |= {f"families.{name}" + ("" if key == "score" else f".{key}"): value for key, value in found.items()}
    return made


def overview(verdict: Verdict) -> Components:
    """The four prompt dimensions, what they sum to, and what structural integrity makes of it."""
    dimensions = verdict.measurements.get("dimensions", {})
    made = _shares({name: dimensions.get(name, {}).get("score") for name in OVERVIEW_WEIGHTS}, OVERVIEW_WEIGHTS)
    whole = ("prompt_alignment_score", "structural_integrity_score", "structural_multiplier", "score_before_severe_cap")
    return _dotted("dimensions", made) | _shares(verdict.measurements, whole)


COMPONENTS: dict[str, Callable[[Verdict], Components]] = {
    "integrity": integrity,
    "physics": physics,
    "repair": repair,
    "detailed": detailed,
    "overview": overview,
}
"""By verifier."""


def _shares(source: Mapping[str, Any], names: Iterable[str]) -> Components:
    """Those of the named values that are numbers in [0, 1]."""
    return {name: value for name in names if (value := unit_number(source.get(name))) is not None}


def _dotted(prefix: str, made: Components) -> Components:
    return {f"{prefix}.{name}": value for name, value in made.items()}
