"""Every number that a page works out from its parts is the stored one."""

from __future__ import annotations

import json
from collections import defaultdict
from pathlib import Path
from typing import Any

import pytest

from c4s.protocol.case import SEMANTIC
from c4s.records.policy import ScorePolicy
from c4s.records.verdict import Verdict
from c4s.score.case import case_score
from c4s.score.policies import POLICIES, PUBLISHED
from c4s.score.rescore import under
from reports.working import Working, worked_score
from tests.reports.played import AGENTS
from warehouse.database import rows


@pytest.fixture
def warehouse(played_home: Path) -> Path:
    """Of trials that were played."""
    return played_home / "warehouse"


def workings(warehouse: Path) -> list[tuple[dict[str, Any], Working]]:
    documents: dict[str, dict[str, Any]] = defaultdict(dict)
    for row in rows(warehouse, "SELECT trial_id, verifier, document FROM verdicts"):
        documents[row["trial_id"]][row["verifier"]] = json.loads(row["document"])
    stored = f"SELECT trial_id, value FROM components WHERE verifier = '{SEMANTIC}' AND name = 'score'"
    semantic = {row["trial_id"]: row["value"] for row in rows(warehouse, stored)}
    return [
        (trial, worked_score(trial, documents[trial["trial_id"]], semantic.get(trial["trial_id"])))
        for trial in rows(warehouse, "SELECT * FROM outcomes")
    ]


def test_every_number_of_every_trial_is_the_stored_one(warehouse: Path) -> None:
    found = workings(warehouse)
    assert len(found) == 2 * len(AGENTS)
    wrong = [
        (trial["configuration"], trial["case_id"], step.name, step.made, step.stored)
        for trial, working in found
        for step in working.all()
        if not step.agrees
    ]
    assert wrong == []
    assert sum(len(working.all()) for _, working in found) > 100


def test_the_flow_reaches_down_to_what_was_decided(warehouse: Path) -> None:
    for trial, working in workings(warehouse):
        if not trial["status"].startswith("measured"):
            assert not working.passed and working.all() == [] and working.gate == trial["reason"]
            continue
        names = {step.name for step in working.all()}
        if trial["setting"] == "text-to-scene":
            assert {"case", "semantic", "detailed", "coverage", "overview", "prompt-alignment", "structure"} <= names
            assert {"family-content_quantity", "known-content_quantity"} <= names
        else:
            assert {"case", "repair", "tp", "fp", "fn", "precision", "recall"} <= names
        assert {"physics", "physics-floating", "physics-solid_penetration"} <= names


def test_a_number_that_was_changed_is_told(warehouse: Path) -> None:
    trial, working = next((trial, made) for trial, made in workings(warehouse) if made.passed)
    assert working.agrees
    changed = worked_score({**trial, "score": trial["score"] + 1e-6}, {})
    assert not changed.agrees and changed.steps[-1].stored != changed.steps[-1].made


def test_a_component_that_was_not_evaluated_is_worth_zero() -> None:
    trial = {"setting": "text-to-scene", "status": "measured_with_missing_zero", "score": 0.2, "reason": ""}
    gate = {"status": "valid", "reason": ""}
    none = {"status": "not_evaluated", "score": None, "reason": "the case has no requirement bundle"}
    leaves = {
        "floating": {"direction": "lower_is_better", "safety": 1.0},
        "solid_penetration": {"direction": "higher_is_better", "safety": 1.0},
    }
    results = [
        {"leaf_id": "floating", "status": "measured", "score": 0.0, "evaluated": 3, "failed": 0},
        {"leaf_id": "solid_penetration", "status": "measured", "score": 1.0, "evaluated": 3, "failed": 0},
    ]
    physics = {"status": "measured", "score": 1.0, "measurements": {"leaf_results": results, "leaves": leaves}}
    documents = {"integrity": gate, "detailed": none, "overview": none, "physics": physics}
    made = worked_score(trial, documents, 0.0)
    assert made.missing == ["Detailed", "Overview"] and made.agrees
    assert [part.share for part in made.steps[-1].parts] == [0.0, 0.2, 0.0]


@pytest.mark.parametrize("policy", [policy for policy in POLICIES.values() if policy is not PUBLISHED])
def test_a_score_is_worked_out_by_its_own_policy(warehouse: Path, policy: ScorePolicy) -> None:
    documents: dict[str, dict[str, Any]] = defaultdict(dict)
    for row in rows(warehouse, "SELECT trial_id, verifier, document FROM verdicts"):
        documents[row["trial_id"]][row["verifier"]] = json.loads(row["document"])
    for trial in rows(warehouse, "SELECT * FROM case_scores WHERE status = 'measured'"):
        own = documents[trial["trial_id"]]
        score = case_score(
            **{name: trial[name] for name in ("case_id", "setting", "configuration", "repeat", "judge", "engine")},
            submitted=True,
            verdicts={name: under(Verdict.parse(one), policy, trial["setting"]) for name, one in own.items()},
            policy=policy.policy_id,
            weights=policy.weights(trial["setting"]),
        )
        stored = {**trial, **score.components, "score": score.score, "policy": policy.policy_id}
        working = worked_score(stored, own, score.components.get(SEMANTIC))
        wrong = [(step.name, step.made, step.stored) for step in working.all() if not step.agrees]
        assert wrong == [], (trial["configuration"], trial["case_id"])
