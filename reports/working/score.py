"""The case score of a trial from its verdicts' documents, by the published weights (paper, "Score Aggregation")."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from c4s.protocol.case import SEMANTIC
from c4s.protocol.numbers import ordered_sum
from c4s.protocol.rules import GATE, I2S_DIGITS, T2S_DIGITS
from c4s.protocol.settings import Setting, is_construction
from c4s.records.policy import ScorePolicy
from c4s.score.policies import POLICIES, PUBLISHED
from c4s.verify.physics.verifier import PHYSICS
from c4s.verify.registry import weighed_of
from c4s.verify.repair.verifier import REPAIR
from c4s.verify.semantic.verifier import DETAILED, OVERVIEW
from reports.working.alignment import detailed_step, overview_step
from reports.working.flow import Addend, Step, Working
from reports.working.physics import physics_step
from reports.working.repair import repair_step

Documents = Mapping[str, Mapping[str, Any]]
"""A trial's verdicts as they were written, by verifier."""


def worked_score(trial: Mapping[str, Any], documents: Documents, semantic: float | None = None) -> Working:
    """The working of a trial.

    Args:
        trial: its row: ``setting``, ``status``, ``score``, ``reason`` and the headlines.
        documents: its verdicts.
        semantic: the stored semantic score, where it has one.
    """
    gate = documents.get(GATE, {})
    told = str(gate.get("reason") or gate.get("status") or "no verdict is here")
    if not str(trial["status"]).startswith("measured"):
        return Working((), str(trial["reason"] or told), passed=False)
    text, policy = is_construction(trial["setting"]), POLICIES.get(str(trial.get("policy")), PUBLISHED)
    weights = policy.weights(trial["setting"])
    verifiers = {row.weighed_as: row for row in weighed_of(trial["setting"])}
    parts, steps, missing = [], [], []
    for name, weight in weights.items():
        verifier = verifiers[name]
        document = documents.get(verifier.name, {})
        score, note = document.get("score"), ""
        if score is not None:
            step = _step(verifier.name, document, policy, trial["setting"])
            score = step.made if policy is not PUBLISHED else score
            steps.append(step if policy is PUBLISHED else replace(step, stored=trial.get(name)))
        elif "status" in document:
            missing.append(verifier.title)
            note = str(document.get("reason") or "not evaluated: worth zero")
        else:
            score, note = trial.get(name), "its verdict is not in this warehouse"
        parts.append(Addend(_title(name), score or 0.0, weight, note))
    shares = [weights[name] * (part.value or 0.0) for name, part in zip(weights, parts, strict=True)]
    rule = " + ".join(f"{weight:.2f} {_title(name).lower()}" for name, weight in weights.items())
    if text:
        steps.append(_semantic(parts, list(weights), semantic))
        made = round(ordered_sum(shares), T2S_DIGITS)
    else:
        made = round(math.fsum(shares), I2S_DIGITS)
    digits = T2S_DIGITS if text else I2S_DIGITS
    steps.append(Step("case", "Case score", f"{rule}, {digits} decimals", parts, made, trial["score"], digits))
    return Working(steps, told, passed=True, missing=missing)


def _step(name: str, document: Mapping[str, Any], policy: ScorePolicy, setting: Setting) -> Step:
    """A component's step under a policy."""
    if name == DETAILED.name:
        return detailed_step(document, policy.families)
    if name == OVERVIEW.name:
        return overview_step(document, policy.overview)
    if name == PHYSICS.name:
        return physics_step(document, policy.leaves(setting))
    return repair_step(document, policy.repair_tolerances)


def _semantic(parts: list[Addend], names: list[str], stored: float | None) -> Step:
    halves = [
        part for name, part in zip(names, parts, strict=True) if name in (DETAILED.weighed_as, OVERVIEW.weighed_as)
    ]
    weights = [part.weight or 0.0 for part in halves]
    made = (weights[0] * (halves[0].value or 0.0) + weights[1] * (halves[1].value or 0.0)) / (weights[0] + weights[1])
    told = " + ".join(f"{weight:.2f} {half.label.lower()}" for weight, half in zip(weights, halves, strict=True))
    rule = f"({told}) / {sum(weights):.2f}; it stands beside the case score and is not rounded"
    return Step(SEMANTIC, "Semantic", rule, halves, made, stored)


def _title(name: str) -> str:
    return "Repair F1" if name == REPAIR.weighed_as else name.capitalize()
