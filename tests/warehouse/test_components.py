"""The long table of components: every number that a stored verdict's score is made of, by name."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bench.scored_run import make_run
from c4s.protocol.case import semantic_score, t2s_case
from c4s.protocol.rules import FAMILY_WEIGHTS, OVERVIEW_WEIGHTS
from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.verify.registry import VERIFIERS, verifier_named
from c4s.verify.verifier import Components
from warehouse.components import component_rows

SHARE = st.floats(0, 1)


def components(verdict: Verdict) -> Components:
    return verifier_named(verdict.verifier).components(verdict)


@pytest.fixture(scope="module")
def stored(tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("runs") / "made"
    make_run(root, 60)
    return root


def test_every_stored_verdict_has_its_components(stored: Path) -> None:
    verdicts = [Verdict.read(path) for path in sorted(stored.rglob("verdicts/*.json"))]
    assert {verdict.verifier for verdict in verdicts} == set(VERIFIERS)
    for verdict in verdicts:
        made = components(verdict)
        assert made.get("score") == verdict.score and (made or verdict.score is None)
        counts = {name for name in made if name in ("tp", "fp", "fn")}
        assert all(0 <= value <= 1 for name, value in made.items() if name not in counts)
        match verdict.verifier:
            case "repair":
                assert made["tp"] + made["fn"] == 6 and made["profiles.nominal.f1"] == made["f1"] == verdict.score
            case "overview":
                assert {f"dimensions.{name}" for name in OVERVIEW_WEIGHTS} < set(made)
            case "detailed":
                assert made["known_coverage"] == verdict.measurements["known_coverage"]


def test_families_and_leaves_that_were_not_measured_have_no_row() -> None:
    families = {name: {"score": None} for name in FAMILY_WEIGHTS} | {
        "content_quantity": {"score": 0.5, "known_coverage": 0.25}
    }
    detailed = Verdict(
        verifier="detailed", status="measured", score=0.5, policy="p", measurements={"families": families}
    )
    assert components(detailed) == {
        "score": 0.5,
        "families.content_quantity": 0.5,
        "families.content_quantity.known_coverage": 0.25,
    }
    leaves = {"floating": {"safety": None}, "solid_penetration": {"safety": 0.75}}
    physics = Verdict(verifier="physics", status="measured", score=0.375, policy="p", measurements={"leaves": leaves})
    assert components(physics) == {"score": 0.375, "solid_penetration": 0.75}
    assert components(Verdict(verifier="repair", status="not_evaluated", policy="p")) == {}


@given(SHARE, SHARE, SHARE)
def test_the_case_score_is_the_semantic_score_and_physics(detailed: float, overview: float, physics: float) -> None:
    semantic = semantic_score(detailed=detailed, overview=overview)
    case = t2s_case(valid=True, detailed=detailed, overview=overview, physics=physics)["score"]
    assert case == pytest.approx(0.8 * semantic + 0.2 * physics, abs=0.00005 + 1e-12)
    assert min(detailed, overview) - 1e-12 <= semantic <= max(detailed, overview) + 1e-12


def test_a_text_trial_has_a_semantic_score_and_a_repair_has_none(stored: Path) -> None:
    seen = set()
    for path in sorted(stored.rglob("score.json")):
        score = TrialScore.read(path)
        digests = {"suite_digest": "d", "configuration_digest": "e"}
        key = {
            "trial_id": "t",
            "run_id": "r",
            "suite": "s",
            "configuration": "c",
            "case_id": "x",
            "repeat": 1,
        } | digests
        found = {(row.verifier, row.name): row.value for row in component_rows([], score, key)}
        seen.add((score.setting, score.status))
        if score.setting == "text-to-scene":
            halves = 0.2 * (score.components["detailed"] or 0.0) + 0.6 * (score.components["overview"] or 0.0)
            assert found == {("semantic", "score"): halves / (0.2 + 0.6)}
        else:
            assert found == {}
    assert ("text-to-scene", "measured") in seen
