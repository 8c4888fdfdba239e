"""The numbers that the semantic scores are made of."""

from __future__ import annotations

from c4s.protocol.rules import OVERVIEW_WEIGHTS
from c4s.records.verdict import Verdict
from c4s.verify.verifier import Components, dotted, shares


def detailed_components(verdict: Verdict) -> Components:
    """Known coverage, and the score and known coverage of each requirement family that the prompt asks for."""
    made = shares(verdict.measurements, ["known_coverage"])
    for name, family in verdict.measurements.get("families", {}).items():
        found = shares(family, ("score", "known_coverage"))
        made |= {f"families.{name}" + ("" if key == "score" else f".{key}"): value for key, value in found.items()}
    return made


def overview_components(verdict: Verdict) -> Components:
    """The four prompt dimensions, what they sum to, and what structural integrity makes of it."""
    dimensions = verdict.measurements.get("dimensions", {})
    made = shares({name: dimensions.get(name, {}).get("score") for name in OVERVIEW_WEIGHTS}, OVERVIEW_WEIGHTS)
    whole = ("prompt_alignment_score", "structural_integrity_score", "structural_multiplier", "score_before_severe_cap")
    return dotted("dimensions", made) | shares(verdict.measurements, whole)
