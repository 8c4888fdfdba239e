"""Detailed and Overview Alignment from the judge's answers (paper, "Semantic Verifier aggregation")."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, Final

from c4s.protocol.detailed import clauses_of, row_score
from c4s.protocol.numbers import ordered_sum, weighted_mean
from c4s.protocol.rules import (
    DETAILED_DIGITS,
    FAMILY_WEIGHTS,
    OVERVIEW_WEIGHTS,
    SEVERE_CAP,
    STRUCTURE_FLOOR,
    STRUCTURE_SHARE,
    Family,
)
from c4s.verify.semantic.verifier import DETAILED, OVERVIEW
from reports.text import slug
from reports.working.flow import Addend, Step

Row = Mapping[str, Any]
OVERVIEW_DIGITS: Final = 4


def named(name: str) -> str:
    """A field's name as words."""
    return name.replace("_", " ").capitalize()


def detailed_step(document: Row, weights: Mapping[Family, float] = FAMILY_WEIGHTS) -> Step:
    """Requirements to clauses to families to a score, with known coverage beside it.

    Args:
        document: the verdict.
        weights: of the families; the verdict was made with the published ones.
    """
    measured = document["measurements"]
    stored = measured.get("families", {})
    groups: dict[str, list[Row]] = {}
    for row in measured.get("semantic_requirement_aggregation", []):
        if row.get("included", True):
            groups.setdefault(str(row.get("semantic_family")), []).append(row)
    present = [family for family in weights if family in groups]
    total = ordered_sum(weights[family] for family in present)
    steps, parts, known = [], [], []
    for family in present:
        step, coverage = _family(family, groups[family], stored.get(family, {}))
        weight = weights[family] / total
        steps += [step, coverage]
        note = f"configured {weights[family]:.2f}" if total != 1 else ""
        parts.append(Addend(named(family), step.made, weight, note))
        known.append(Addend(named(family), coverage.made, weight, note))
    absent = [named(family).lower() for family in weights if family not in groups]
    decided = round(ordered_sum(part.share or 0.0 for part in known), DETAILED_DIGITS)
    coverage = Step(
        "coverage",
        "Known coverage",
        "the same mean of what was decided; it never enters the score",
        known,
        decided,
        measured.get("known_coverage") if weights == FAMILY_WEIGHTS else decided,
    )
    return Step(
        DETAILED.name,
        "Detailed alignment",
        "weighted mean of the families that the prompt has, 4 decimals",
        parts,
        round(ordered_sum(part.share or 0.0 for part in parts), DETAILED_DIGITS),
        document["score"],
        inner=[*steps, coverage],
        note=f"The prompt asks nothing of {', '.join(absent)}; the other weights grow to 1." if absent else "",
    )


def _family(family: str, rows: list[Row], stored: Row) -> tuple[Step, Step]:
    """A family's score and its known coverage: means over clauses of means over requirements."""
    clauses = clauses_of(list(rows))
    weights = [max(float(row.get("predicate_weight", 1.0)) for row in clause) for clause in clauses]
    scores = [weighted_mean((_weight(row), row_score(row)) for row in clause) for clause in clauses]
    known = [
        weighted_mean((_weight(row), float(bool(row.get("score_known", True)))) for row in clause) for clause in clauses
    ]
    inner = [
        Step(
            f"{family}-{number}",
            f"Clause {number}",
            "mean of its requirements",
            [_requirement(row) for row in clause],
            score,
            score,
        )
        for number, (clause, score) in enumerate(zip(clauses, scores, strict=True), start=1)
    ]
    total = sum(weights)
    made = round(weighted_mean(zip(weights, scores, strict=True)), DETAILED_DIGITS)
    covered = round(weighted_mean(zip(weights, known, strict=True)), DETAILED_DIGITS)
    parts = [Addend(step.title, step.made, weight / total) for step, weight in zip(inner, weights, strict=True)]
    shares = [
        Addend(step.title, share, weight / total) for step, share, weight in zip(inner, known, weights, strict=True)
    ]
    rule = f"mean of {len(clauses)} clauses with {len(rows)} requirements, 4 decimals"
    return (
        Step(f"family-{family}", named(family), rule, parts, made, stored.get("score"), inner=inner),
        Step(
            f"known-{family}",
            f"{named(family)}: known",
            "mean over the clauses of the share that was decided",
            shares,
            covered,
            stored.get("known_coverage"),
        ),
    )


def _weight(row: Row) -> float:
    return float(row.get("predicate_weight", 1.0))


def _requirement(row: Row) -> Addend:
    status = str(row.get("evaluation_status", ""))
    told = "held back by what stands inside it" if row.get("parent_constrained") else ""
    return Addend(
        str(row.get("text", "")),
        row_score(row),
        None,
        told,
        status.lower(),
        f"claim-{slug(str(row.get('node_id', '')))}",
    )


def overview_step(document: Row, weights: Mapping[str, float] = OVERVIEW_WEIGHTS) -> Step:
    """Four dimensions, a multiplier for structure, a cap for a severe defect.

    Args:
        document: the verdict.
        weights: of the dimensions; the verdict was made with the published ones.
    """
    measured, published = document["measurements"], weights == OVERVIEW_WEIGHTS
    dimensions = measured.get("dimensions", {})
    parts = [
        Addend(named(name), dimensions[name]["score"], weight, str(dimensions[name].get("reason", "")))
        for name, weight in weights.items()
    ]
    alignment = math.fsum(part.share or 0.0 for part in parts)
    structure = float(measured["structural_integrity_score"])
    multiplier = STRUCTURE_FLOOR + STRUCTURE_SHARE * structure
    before = alignment * multiplier
    capped = bool(measured.get("severe_structural_cap_eligible"))
    after = min(before, SEVERE_CAP) if capped else before
    aligned = Step(
        "prompt-alignment",
        "Prompt alignment",
        f"{', '.join(f'{weight:.2f}' for weight in weights.values())} of the four dimensions",
        parts,
        round(alignment, OVERVIEW_DIGITS),
        measured.get("prompt_alignment_score") if published else round(alignment, OVERVIEW_DIGITS),
        inner=[step for name in weights if (step := _dimension(name, dimensions[name])) is not None],
    )
    made = Step(
        "structure",
        "Structural multiplier",
        "0.75 + 0.25 structural integrity",
        [Addend("Structural integrity", structure, STRUCTURE_SHARE, str(measured.get("structural_reason", "")))],
        round(multiplier, OVERVIEW_DIGITS),
        measured.get("structural_multiplier"),
    )
    product = Step(
        "before-cap",
        "Before the cap",
        "prompt alignment × structural multiplier",
        [Addend("Prompt alignment", alignment), Addend("Structural multiplier", multiplier)],
        round(before, OVERVIEW_DIGITS),
        measured.get("score_before_severe_cap") if published else round(before, OVERVIEW_DIGITS),
    )
    return Step(
        OVERVIEW.name,
        "Overview alignment",
        f"at most {SEVERE_CAP} where a severe structural defect is proved, 4 decimals",
        [Addend("Before the cap", before), *([Addend("Cap", SEVERE_CAP)] if capped else [])],
        round(after, OVERVIEW_DIGITS),
        document["score"],
        inner=[aligned, made, product],
        note="A severe structural defect caps it." if capped else "No severe structural defect was proved.",
    )


def _dimension(name: str, said: Row) -> Step | None:
    """The parts of a dimension where the judge tells them; its score is the judge's own."""
    if not said.get("parts"):
        return None
    parts = [
        Addend(named(part["name"]), part["value"], None, "" if part.get("known", True) else "unknown: worth zero")
        for part in said["parts"]
    ]
    return Step(f"dimension-{name}", named(name), "as the judge told it", parts, said["score"], said["score"])
