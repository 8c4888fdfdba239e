"""A made run folder with stored verdicts and scores, as the stages write them: repairs and texts by turns."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

from c4s.protocol.detailed import detailed_score
from c4s.protocol.overview import overview_score
from c4s.protocol.paired import PAIRED_WEIGHTS, paired_score
from c4s.protocol.physics import physics_from_report
from c4s.protocol.rules import DEFAULT_POLICY, FAMILY_WEIGHTS, GATE, OVERVIEW_WEIGHTS
from c4s.protocol.settings import SETTINGS, Setting, is_construction
from c4s.records.folder import RunFolder, TrialFolder
from c4s.records.plan import Configuration, Plan, PlannedCase
from c4s.records.verdict import Verdict
from c4s.score.case import case_score
from c4s.stats.navigation import utility
from c4s.verify.navigation.verifier import NAVIGATION
from c4s.verify.paired.verifier import PAIRED
from c4s.verify.physics.verifier import PHYSICS
from c4s.verify.repair.verifier import REPAIR
from c4s.verify.semantic.verifier import DETAILED, OVERVIEW

_FAMILIES = list(FAMILY_WEIGHTS)


def _counts(tp: int, fp: int, targets: int) -> dict[str, Any]:
    fn = targets - tp
    return {
        "tp": tp,
        "fp": fp,
        "fn": fn,
        "precision": tp / (tp + fp) if tp + fp else 0.0,
        "recall": tp / targets,
        "f1": 2 * tp / (2 * tp + fp + fn),
    }


def _physics(rng: random.Random) -> Verdict:
    leaves = [
        {"leaf_id": "floating", "status": "measured", "score": round(rng.random() * 0.5, 4)},
        {"leaf_id": "solid_penetration", "status": "measured", "score": round(rng.random(), 4)},
    ]
    metrics = {
        "leaf_results": leaves,
        "leaf_score_directions": {"floating": "lower_is_better", "solid_penetration": "higher_is_better"},
    }
    made = physics_from_report({"status": "measured", "metrics": metrics})
    measurements = metrics | {"leaves": made["leaves"]}
    return Verdict(
        verifier=PHYSICS.name, status="measured", score=made["score"], policy="made", measurements=measurements
    )


def _repair(rng: random.Random) -> Verdict:
    strict, nominal, relaxed = sorted(rng.randrange(7) for _ in range(3))
    profiles = {
        name: _counts(tp, 6 - tp, 6) for name, tp in (("strict", strict), ("nominal", nominal), ("relaxed", relaxed))
    }
    targets = [{"label": f"SM_{n}", "operation": "repair", "outcome": "TP" if n < nominal else "FN"} for n in range(6)]
    return Verdict(
        verifier=REPAIR.name,
        status="measured",
        score=profiles["nominal"]["f1"],
        policy="made",
        measurements=profiles["nominal"] | {"profiles": profiles, "targets": targets},
    )


def _detailed(rng: random.Random) -> Verdict:
    rows = [
        {
            "node_id": f"n{n}",
            "semantic_family": _FAMILIES[n % 4],
            "clause_index": n % 5,
            "included": True,
            "predicate_weight": 1.0,
            "evaluation_status": "MATCH",
            "score_known": rng.random() < 0.9,
            "effective_score": round(rng.random(), 4),
        }
        for n in range(40)
    ]
    made = detailed_score(rows)
    return Verdict(
        verifier=DETAILED.name,
        status="measured",
        score=made["score"],
        policy="made",
        measurements={
            "semantic_requirement_aggregation": rows,
            "families": made["families"],
            "known_coverage": made["known_coverage"],
        },
    )


def _overview(rng: random.Random) -> Verdict:
    dimensions, structure = {name: rng.random() for name in OVERVIEW_WEIGHTS}, rng.random()
    return Verdict(
        verifier=OVERVIEW.name,
        status="measured",
        policy="made",
        score=overview_score(dimensions, structure, False)["score"],
        measurements={
            "dimensions": {name: {"score": value} for name, value in dimensions.items()},
            "structural_integrity_score": structure,
            "severe_structural_cap_eligible": False,
        },
    )


def _paired(rng: random.Random) -> Verdict:
    dimensions = {name: rng.random() for name in PAIRED_WEIGHTS}
    return Verdict(
        verifier=PAIRED.name,
        status="measured",
        policy="made",
        score=paired_score(dimensions),
        measurements={"dimensions": dimensions},
    )


def _navigation(rng: random.Random) -> Verdict:
    share, arrived = rng.random(), rng.randint(0, 3)
    if rng.random() < 0.1:
        return Verdict(
            verifier=NAVIGATION.name,
            status="not_evaluated",
            policy="made",
            measurements={"reason_code": "no_route", "excluded": False},
        )
    return Verdict(
        verifier=NAVIGATION.name,
        status="measured",
        policy="made",
        score=utility(share, arrived, 3),
        measurements={"approachability": share, "completion": arrived / 3},
    )


_MADE = {
    NAVIGATION.name: _navigation,
    PAIRED.name: _paired,
    PHYSICS.name: _physics,
    REPAIR.name: _repair,
    DETAILED.name: _detailed,
    OVERVIEW.name: _overview,
}


def made_verdict(verifier: str, rng: random.Random) -> Verdict:
    """A measured verdict of a verifier, other numbers each time."""
    return _MADE[verifier](rng)


def _write(folder: TrialFolder, setting: Setting, case_id: str, configuration: str, rng: random.Random) -> None:
    valid = rng.random() < 0.95
    verdicts = {
        GATE: Verdict(
            verifier=GATE, status="valid" if valid else "invalid", policy="made", reason="" if valid else "unloadable"
        )
    }
    if valid:
        verdicts |= {PHYSICS.name: _physics(rng), NAVIGATION.name: _navigation(rng)}
        if is_construction(setting):
            verdicts |= {DETAILED.name: _detailed(rng), OVERVIEW.name: _overview(rng)}
        else:
            verdicts |= {REPAIR.name: _repair(rng), PAIRED.name: _paired(rng)}
    made = case_score(
        case_id=case_id,
        setting=setting,
        configuration=configuration,
        repeat=1,
        judge="rule",
        engine="headless",
        submitted=True,
        verdicts=verdicts,
        policy=DEFAULT_POLICY,
    )
    for name, verdict in verdicts.items():
        verdict.write(folder.verdict(name))
    made.write(folder.score)


def make_run(root: Path, trials: int, *, configurations: int = 10, seed: int = 1) -> Plan:
    """Write a run of about ``trials`` trials (a whole number of cases) and return its plan."""
    rng = random.Random(seed)
    names = [f"agent-{n}" for n in range(configurations)]
    cases = [
        PlannedCase(
            case_id=f"case-{n}",
            alias=f"case-{n}",
            setting=SETTINGS[n % len(SETTINGS)],
            scene_id="made",
            agent_digest="0",
            withheld_digest="0",
        )
        for n in range(max(1, trials // configurations))
    ]
    plan = Plan(
        run_id="made",
        suite_id="made",
        suite_digest="0",
        policy=DEFAULT_POLICY,
        judge="rule",
        engine="headless",
        configurations=[Configuration(name=name, client="noop") for name in names],
        cases=cases,
        versions={},
    )
    folder = RunFolder(root)
    for case in cases:
        for name in names:
            _write(folder.trial(name, case.case_id, 1), case.setting, case.case_id, name, rng)
    plan.write(folder.plan)
    return plan
