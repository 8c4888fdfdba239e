"""Repair F1 from its targets and the changes beside them (paper, "Ground-Truth-Based Verifier")."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.protocol.repair import NOMINAL
from c4s.verify.repair.verifier import REPAIR
from reports.working.flow import COUNT, Addend, Step


def repair_step(document: Mapping[str, Any], tolerances: str = NOMINAL.name) -> Step:
    """F1 of what was repaired; each target is a true positive or a false negative, each other change a false
    positive.

    Args:
        document: the verdict, whose targets were held to the published tolerances.
        tolerances: the profile that is told; of another one a verdict keeps the counts alone.
    """
    measured = document["measurements"]
    if tolerances != NOMINAL.name:
        return _of_profile(measured["profiles"][tolerances], tolerances)
    targets, wrong = measured.get("targets", []), measured.get("false_positives", [])
    hits = sum(row["outcome"] == "TP" for row in targets)
    missed = len(targets) - hits
    counts = [
        _count("tp", "True positives", "targets that are as they should be", hits, measured),
        _count("fp", "False positives", "changes that no target asks for", len(wrong), measured),
        _count("fn", "False negatives", "targets that are not", missed, measured),
    ]
    tp, fp, fn = (float(step.made or 0.0) for step in counts)
    precision = tp / (tp + fp) if tp + fp else 0.0
    recall = tp / (tp + fn) if tp + fn else 0.0
    f1 = 2 * tp / (2 * tp + fp + fn) if tp + fp + fn else 0.0
    pair = [Addend(name, count, kind=COUNT) for name, count in (("TP", tp), ("FP", fp), ("FN", fn))]
    return Step(
        REPAIR.name,
        "Repair F1",
        "2 TP / (2 TP + FP + FN)",
        pair,
        f1,
        document["score"],
        6,
        [
            *counts,
            Step("precision", "Precision", "TP / (TP + FP)", pair[:2], precision, measured.get("precision"), 6),
            Step("recall", "Recall", "TP / (TP + FN)", [pair[0], pair[2]], recall, measured.get("recall"), 6),
        ],
    )


def _of_profile(counts: Mapping[str, Any], tolerances: str) -> Step:
    """F1 of the counts of another profile."""
    tp, fp, fn = (float(counts[name]) for name in ("tp", "fp", "fn"))
    pair = [Addend(name, count, kind=COUNT) for name, count in (("TP", tp), ("FP", fp), ("FN", fn))]
    f1 = 2 * tp / (2 * tp + fp + fn) if tp + fp + fn else 0.0
    note = f"counted with {tolerances} tolerances"
    return Step(REPAIR.name, "Repair F1", "2 TP / (2 TP + FP + FN)", pair, f1, counts["f1"], 6, note=note)


def _count(name: str, title: str, rule: str, count: int, measured: Mapping[str, Any]) -> Step:
    stored = measured.get(name)
    return Step(name, title, rule, (), float(count), None if stored is None else float(stored), 0)
