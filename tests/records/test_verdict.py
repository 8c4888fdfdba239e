"""A verdict is whole or cannot be made, and says which code made it."""

from __future__ import annotations

import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any, get_args

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

import c4s
from c4s.errors import BadInput
from c4s.files import digest_file
from c4s.judge.desk import Desk
from c4s.judge.names import JUDGE_NAMES, judge_configuration
from c4s.judge.registry import JUDGES, Judge, judge_version, make_judgements
from c4s.records.evidence import Evidence, EvidenceName
from c4s.records.judge import RULE_JUDGE, JudgeConfiguration
from c4s.records.judgement import ClaimJudgement, Judgements
from c4s.records.plan import Configuration
from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.verify.registry import VERIFIERS, headlines_of, make_verdict, verifier_named, verifiers_of

SCORES = st.one_of(st.none(), st.floats(), st.integers(-3, 3))
NO_NUMBER = ("not_applicable", "not_evaluated", "error", "valid", "invalid")


@given(SCORES)
def test_a_measured_score_is_a_finite_number_in_the_unit_interval(score: Any) -> None:
    def make() -> Verdict:
        return Verdict(verifier="v", status="measured", score=score, policy="p")

    if score is not None and 0 <= score <= 1:
        assert make().score == score
    else:
        with pytest.raises(ValidationError):
            make()


@pytest.mark.parametrize("status", NO_NUMBER)
def test_no_other_status_carries_a_number(status: Any) -> None:
    assert Verdict(verifier="v", status=status, policy="p").score is None
    with pytest.raises(ValidationError):
        Verdict(verifier="v", status=status, score=0.0, policy="p")


@pytest.mark.parametrize("score", ["7.5", "-0.1", "NaN", "Infinity", "null"])
def test_a_stored_verdict_that_is_not_whole_is_refused(score: str, tmp_path: Path) -> None:
    path = tmp_path / "physics.json"
    path.write_text(f'{{"verifier": "physics", "status": "measured", "score": {score}, "policy": "p"}}')
    with pytest.raises(BadInput, match=r"physics\.json"):
        Verdict.read(path)


@pytest.mark.parametrize("score", [-0.1, 1.1, float("nan")])
def test_a_judgement_outside_the_unit_interval_cannot_be_made(score: float) -> None:
    with pytest.raises(ValidationError):
        ClaimJudgement(claim="p1", answer="MATCH", score=score)


def test_unknown_names_are_refused_with_the_choices() -> None:
    with pytest.raises(BadInput, match="physics"):
        verifier_named("taste")
    with pytest.raises(BadInput, match="rule"):
        judge_configuration("gpt-9-vlm")


def test_every_row_of_the_table_adds_the_numbers_that_it_names() -> None:
    for verifier in VERIFIERS.values():
        for setting in verifier.settings:
            assert verifier.gate or verifier in verifiers_of(setting)
            assert set(verifier.headlines) <= {*headlines_of(setting)}
        for status in ("measured", "not_evaluated"):
            score = 0.5 if status == "measured" else None
            made = Verdict(verifier=verifier.name, status=status, score=score, policy="p")  # type: ignore[arg-type]
            assert verifier.components(made).keys() >= ({"score"} if score else set())
            assert verifier.shown(made).keys() == verifier.headlines.keys()


def test_a_changed_word_list_or_rule_makes_another_judge_and_another_verdict(tmp_path: Path) -> None:
    shutil.copytree(
        Path(c4s.__file__).parent, tmp_path / "c4s", ignore=shutil.ignore_patterns("__pycache__", "headless")
    )

    def versions() -> list[str]:
        ask = (
            "from c4s.judge.rule.version import rule_version\n"
            "from c4s.records.version import code_version\n"
            "print(rule_version(), code_version('verify', 'protocol'))"
        )
        done = subprocess.run([sys.executable, "-c", ask], cwd=tmp_path, capture_output=True, text=True, check=True)
        return done.stdout.split()

    before = versions()
    words = tmp_path / "c4s/protocol/words.py"
    words.write_text(words.read_text().replace('"the"', '"thee"', 1) + "\n")
    changed = versions()
    assert before[0] != changed[0] and before[1] != changed[1]
    support = tmp_path / "c4s/verify/physics/support.py"
    support.write_text(support.read_text() + "\n")
    again = versions()
    assert again[0] == changed[0] and again[1] != changed[1]


def test_a_judge_and_a_verifier_are_given_what_they_may_read_and_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[EvidenceName] = []

    def look(_: JudgeConfiguration, evidence: Evidence, __: Desk) -> Any:
        peek(evidence)

    def peek(evidence: Evidence) -> Any:
        asked.extend(name for name in get_args(EvidenceName) if name in evidence.files)
        evidence.json("truth_snapshot")

    files = {name: tmp_path / f"{name}.json" for name in get_args(EvidenceName)}
    for path in files.values():
        path.write_text("{}")
    evidence = Evidence(setting="text-to-scene", prompt="", files=files)
    monkeypatch.setitem(JUDGES, "rule", Judge(look, str))
    with pytest.raises(BadInput, match="no truth snapshot"):
        make_judgements(RULE_JUDGE, evidence)
    assert set(asked) == {"candidate_snapshot", "captures", "requirements", "binding"}
    for verifier in VERIFIERS.values():
        asked.clear()
        monkeypatch.setitem(VERIFIERS, verifier.name, replace(verifier, verify=peek))
        if "truth_snapshot" not in verifier.needs:
            with pytest.raises(BadInput, match="no truth snapshot"):
                make_verdict(verifier.name, evidence)
            assert set(asked) == verifier.needs


def test_evidence_that_changed_since_it_was_made_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "snapshot.json"
    path.write_text("{}")
    noted = {"candidate_snapshot": digest_file(path)}
    evidence = Evidence(setting="text-to-scene", prompt="", files={"candidate_snapshot": path}, noted=noted)
    assert evidence.json("candidate_snapshot") == {} and evidence.digests == noted
    path.write_text("{} ")
    with pytest.raises(BadInput, match="has changed"):
        evidence.json("candidate_snapshot")


@pytest.mark.parametrize("update", [{"score": 7.5}, {"score": float("nan")}, {"score": None}, {"status": "error"}])
def test_no_copy_of_a_verdict_is_less_whole(update: dict[str, Any]) -> None:
    verdict = Verdict(verifier="v", status="measured", score=0.5, policy="p")
    with pytest.raises(ValueError, match="score"):
        verdict.model_copy(update=update)


@pytest.mark.parametrize("score", [True, "0.5"])
def test_a_score_is_a_number(score: Any) -> None:
    with pytest.raises(ValidationError):
        Verdict(verifier="v", status="measured", score=score, policy="p")


def test_a_claim_is_answered_once_and_the_unknown_is_worth_nothing() -> None:
    no = ClaimJudgement(claim="p1", answer="MISMATCH", score=0.0)
    yes = ClaimJudgement(claim="p1", answer="MATCH", score=1.0)
    with pytest.raises(ValidationError, match="more than once"):
        Judgements(judge="rule", judge_version="v", claims=[no, yes])
    with pytest.raises(ValidationError):
        ClaimJudgement(claim="p1", answer="UNKNOWN", score=1.0)


@pytest.mark.parametrize(
    ("status", "score"), [("measured", 7.0), ("measured", None), ("pending", 0.5), ("zero_missing_submission", 0.5)]
)
def test_a_trial_score_says_what_its_status_says(status: Any, score: Any) -> None:
    with pytest.raises(ValidationError):
        TrialScore(
            case_id="c",
            setting="text-to-scene",
            configuration="a",
            repeat=1,
            status=status,
            score=score,
            policy="p",
            judge="rule",
            engine="headless",
        )


@pytest.mark.parametrize("name", ["../escaped", "./noop", "a/b", "", ".hidden", "a\nb", "x" * 121])
def test_a_name_that_becomes_a_folder_is_one(name: str) -> None:
    with pytest.raises(BadInput, match="name"):
        Configuration.parse({"name": name, "client": "noop"})


def test_every_judge_that_can_be_named_is_there() -> None:
    found = [judge_configuration(name) for name in JUDGE_NAMES]
    assert tuple(one.name for one in found) == JUDGE_NAMES and {one.kind for one in found} == set(JUDGES)
    assert len({judge_version(one) for one in found}) == len(found)
