"""Re-scoring stored runs under other policies: what changes, what never does."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml

from bench.scored_run import make_run
from c4s.errors import BadInput
from c4s.protocol.rules import FAMILY_WEIGHTS, I2S_WEIGHTS, OVERVIEW_WEIGHTS, PHYSICS_LEAF_WEIGHTS, T2S_WEIGHTS
from c4s.records.folder import RunFolder
from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.score.policies import POLICIES, PUBLISHED, ScorePolicy, policy_named
from c4s.score.rescore import rescore
from c4s.trees import digest_tree
from tests.work import calls_in


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("runs") / "made"
    make_run(root, 60)
    return root


def test_the_published_policy_is_the_published_numbers() -> None:
    assert (PUBLISHED.text_to_scene, PUBLISHED.image_to_scene) == (T2S_WEIGHTS, I2S_WEIGHTS)
    assert (PUBLISHED.families, PUBLISHED.physics_leaves) == (FAMILY_WEIGHTS, PHYSICS_LEAF_WEIGHTS)
    assert {"code4scene-published", "strict-tolerance", "relaxed-tolerance", "repair-only"} <= set(POLICIES)


def test_the_published_policy_gives_every_stored_score_again(run: Path) -> None:
    found = rescore(run, PUBLISHED)
    assert list(found.deltas()) == [] and found.pending == [] and len(found.pairs) == 60
    assert all(old == new for _, old, new in found.pairs)


def test_stricter_tolerances_change_repairs_only_and_never_upwards(run: Path) -> None:
    deltas = list(rescore(run, POLICIES["strict-tolerance"]).deltas())
    assert deltas and all(delta.setting.startswith("image-to-scene") for delta in deltas)
    assert {delta.component for delta in deltas} <= {"repair_precision", "repair_recall", "repair_f1", "score"}
    assert all(delta.before is not None and delta.after is not None and delta.after < delta.before for delta in deltas)
    for name, _, new in rescore(run, POLICIES["relaxed-tolerance"]).pairs:
        configuration, case_id, _ = name.split("/")
        stored = RunFolder(run).trial(configuration, case_id, 1).verdict("repair")
        if stored.is_file():
            relaxed = Verdict.read(stored).measurements["profiles"]["relaxed"]
            assert (new.components["repair_f1"], new.components["repair_recall"]) == (relaxed["f1"], relaxed["recall"])


def test_repair_only_makes_the_score_repair_f1(run: Path) -> None:
    for _, old, new in rescore(run, POLICIES["repair-only"]).pairs:
        assert new.policy == "repair-only"
        if old.setting == "text-to-scene":
            assert new.score == old.score
        elif old.status == "measured":
            assert new.score == round(old.components["repair_f1"] or 0.0, 6)


def test_leaf_and_family_weights_reach_the_score(run: Path) -> None:
    support = ScorePolicy(policy_id="support-only", physics_leaves={"floating": 1.0, "solid_penetration": 0.0})
    assert {delta.component for delta in rescore(run, support).deltas()} == {"physics", "score"}
    equal = rescore(run, POLICIES["equal-families"])
    assert {delta.component for delta in equal.deltas()} <= {"detailed", "known_coverage", "semantic", "score"}
    assert any(delta.component == "detailed" for delta in equal.deltas())


def test_a_zero_by_rule_stays_a_zero_and_a_pending_trial_has_no_number(tmp_path: Path) -> None:
    root = tmp_path / "run"
    make_run(root, 20, configurations=2, seed=5)
    gone = RunFolder(root).trial("agent-0", "case-0", 1).score
    zero = RunFolder(root).trial("agent-1", "case-0", 1).score
    gone.unlink()
    stored = TrialScore.read(zero).model_copy(update={"status": "zero_missing_submission", "score": 0.0})
    stored.write(zero)
    found = rescore(root, POLICIES["repair-only"])
    assert found.pending == ["agent-0/case-0/r1"]
    assert [(new.status, new.score) for name, _, new in found.pairs if name == "agent-1/case-0/r1"] == [
        ("zero_missing_submission", 0.0)
    ]


def test_bad_verdicts_and_policies_are_one_line(tmp_path: Path) -> None:
    root = tmp_path / "run"
    make_run(root, 2, configurations=2, seed=5)
    verdict = RunFolder(root).trial("agent-0", "case-0", 1).verdict("physics")
    verdict.write_text(verdict.read_text()[:40])
    with pytest.raises(BadInput, match=r"agent-0/case-0/r1.*not valid JSON"):
        rescore(root, PUBLISHED)
    with pytest.raises(BadInput, match="unknown policy 'nosuch'"):
        policy_named("nosuch")
    for changes, said in (
        ({"image_to_scene": {"repair_f1": 0.5, "physics": 0.1}}, "sum to 1"),
        ({"physics_leaves": {"floating": 1.0}}, "needs exactly"),
        ({"families": {**FAMILY_WEIGHTS, "content_quantity": 0}}, "must be positive"),
        ({"repair_tolerances": "lax"}, "repair_tolerances"),
        ({"colour": 1}, "colour"),
        ({"policy_id": "repair-only"}, "shipped"),
    ):
        path = tmp_path / "policy.yaml"
        path.write_text(yaml.safe_dump({"policy_id": "mine", **changes}))
        with pytest.raises(BadInput, match=said) as caught:
            policy_named(str(path))
        assert "\n" not in caught.value.line()


def _c4s(*arguments: str) -> Any:
    done = subprocess.run(
        [sys.executable, "-m", "c4s.cli", *arguments],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
        env={**os.environ, "COLUMNS": "140"},
    )
    return done


def test_the_command_reports_and_leaves_stored_files_alone(run: Path, tmp_path: Path) -> None:
    before = digest_tree(run)
    policy = tmp_path / "mine.yaml"
    policy.write_text("policy_id: half-and-half\nimage_to_scene: {repair_f1: 0.5, physics: 0.5}\n")
    done = _c4s("score", str(run), "--policy", str(policy), "--json")
    assert done.returncode == 0, done.stderr
    report = json.loads(done.stdout)
    assert report["policy"]["policy_id"] == "half-and-half" and report["trials"] == 60
    assert {delta["component"] for delta in report["deltas"]} == {"score"}
    assert report["changed_trials"] == len({delta["trial"] for delta in report["deltas"]})
    assert all(set(delta) == {"trial", "setting", "component", "from", "to"} for delta in report["deltas"])
    assert digest_tree(run) == before
    for arguments in (("score",), ("score", "nosuch"), ("score", str(run), "--policy", "nosuch")):
        bad = _c4s(*arguments)
        assert bad.returncode == 2 and bad.stderr.count("\n") == 1, bad.stderr


def test_the_work_of_scoring_again_grows_with_the_trials(run: Path, tmp_path: Path) -> None:
    make_run(tmp_path / "run", 240)
    few = calls_in(lambda: rescore(run, POLICIES["strict-tolerance"]).report()).total()
    many = calls_in(lambda: rescore(tmp_path / "run", POLICIES["strict-tolerance"]).report()).total()
    assert many < 4.5 * few and many < 7500 * 240


def test_every_weight_of_a_policy_reaches_the_scores(run: Path) -> None:
    style = ScorePolicy(
        policy_id="style-only", overview=dict.fromkeys(OVERVIEW_WEIGHTS, 0.0) | {"style_atmosphere_coherence": 1.0}
    )
    found = list(rescore(run, style).deltas())
    assert found and {delta.setting for delta in found} == {"text-to-scene"}
    assert {delta.component for delta in found} == {"overview", "semantic", "score"}
    solid = ScorePolicy(policy_id="solid-text", text_physics_leaves={"floating": 0.0, "solid_penetration": 1.0})
    moved = list(rescore(run, solid).deltas())
    assert {delta.setting for delta in moved} == {"text-to-scene"}
    assert {delta.component for delta in moved} == {"physics", "score"}
    for name in ("human-fit-individual", "human-fit-consensus"):
        assert {delta.setting for delta in rescore(run, POLICIES[name]).deltas()} == {"text-to-scene"}


def test_the_table_shows_changes_of_the_last_digit(run: Path, tmp_path: Path) -> None:
    policy = tmp_path / "near.yaml"
    policy.write_text("policy_id: near\nimage_to_scene: {repair_f1: 0.79999, physics: 0.20001}\n")
    done = _c4s("score", str(run), "--policy", str(policy))
    rows = [line.split("│") for line in done.stdout.splitlines() if " score " in line and "/r1" in line]
    assert rows and all(stored.strip() != new.strip() for _, _, stored, new in rows)
