"""Answers that break their contract: told by class, asked for once more, and never made into a score."""

from __future__ import annotations

import copy
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from c4s.chat.failures import ChatFailed
from c4s.judge.desk import Desk
from c4s.judge.model.overview import ContractBroken, described
from c4s.protocol.rules import SEVERE_CAP
from c4s.records.judgement import Judgements
from c4s.verify.semantic.overview import verify_overview
from tests.judge.judge_endpoint import (
    AWARE,
    FREE,
    Body,
    JudgeEndpoint,
    Sent,
    Truth,
    answer_row,
    claims_in,
    completion,
    purpose_of,
    views_in,
)
from tests.judge.model_evidence import Claim, claims_by_id, evidence, judged

CLAIMS = [Claim(f"p{number}", f"part {number} is there") for number in range(3)]
MET = {"part 0 is there": True, "part 1 is there": False, "part 2 is there": True}
TRUTH = Truth(MET)
Spoil = Callable[[Body, list[Body]], Any]


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A cache of its own for each test."""
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))


def right(body: Body) -> list[Body]:
    """The rows of a right answer."""
    return [
        answer_row(row["claim"], "MATCH" if MET[row["requirement"]] else "MISMATCH", views_in(body))
        for row in claims_in(body)
    ]


def changed(**fields: Any) -> Spoil:
    """The first row with other fields."""
    return lambda body, rows: {"answers": [{**rows[0], **fields}, *rows[1:]]}


SPOILT: dict[str, tuple[str, Spoil]] = {
    "cut": ("truncated", lambda body, rows: completion('{"answers": [', finish="length")),
    "filtered": ("withheld", lambda body, rows: completion("", finish="content_filter")),
    "no JSON": ("malformed", lambda body, rows: "The claims look fine to me."),
    "fenced": ("malformed", lambda body, rows: "```json\n{}\n```"),
    "a list": ("malformed", lambda body, rows: [1]),
    "empty": ("malformed", lambda body, rows: ""),
    "not a number": ("malformed", lambda body, rows: '{"answers": [{"claim": "c1", "confidence": NaN}]}'),
    "deep": ("malformed", lambda body, rows: "[" * 50_000),
    "other fields": ("malformed", lambda body, rows: {"claims": rows}),
    "another answer": ("malformed", changed(answer="PROBABLY")),
    "lower case": ("malformed", changed(answer="match")),
    "too sure": ("malformed", changed(confidence=1.5)),
    "true as a number": ("malformed", changed(confidence=True)),
    "an endless number": ("malformed", changed(confidence="Infinity")),
    "no views": ("malformed", changed(views="view-1")),
    "a claim left out": ("missing", lambda body, rows: {"answers": rows[1:]}),
    "a claim twice": ("repeated", lambda body, rows: {"answers": [rows[0], *rows]}),
    "a claim both ways": ("repeated", lambda body, rows: {"answers": [{**rows[0], "answer": "UNKNOWN"}, *rows]}),
    "a claim of its own": ("unknown_claim", changed(claim="c77")),
    "a view of its own": ("unknown_view", changed(views=["view-77"])),
    "a name of a file": ("unknown_view", changed(views=["overview-1"])),
    "no view": ("uncited", changed(views=[])),
    "seen and not seen": ("contradictory", changed(visible=False)),
    "a key twice": (
        "contradictory",
        lambda body, rows: '{"answers": [{"claim": "c1", "answer": "MATCH", "answer": "MISMATCH"}]}',
    ),
}


def spoiling(spoil: Spoil, times: int) -> Callable[[Body], Sent]:
    """The truth, with the first requests for sight spoilt."""
    left = [times]

    def answer(body: Body) -> Sent:
        if purpose_of(body) != "sight" or not left[0]:
            return TRUTH(body)
        left[0] -= 1
        made = spoil(body, right(body))
        return made if isinstance(made, Sent) else completion(made)

    return answer


@pytest.mark.parametrize("name", SPOILT)
def test_a_broken_answer_is_asked_for_once_more(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kind, spoil = SPOILT[name]
    with JudgeEndpoint(spoiling(spoil, 1)) as endpoint:
        monkeypatch.setenv("C4S_JUDGE_URL", endpoint.url)
        made = judged(evidence(tmp_path, CLAIMS))
    assert [claim.answer for claim in made.claims] == ["MATCH", "MISMATCH", "MATCH"]
    assert not any(claim.fallback for claim in made.claims)
    first, second = (row for row in made.schedule if row.purpose == "sight")
    assert set(first.broken.values()) <= {kind, "missing"} and kind in first.broken.values()
    assert second.again and not second.broken and second.request_sha256 != first.request_sha256
    assert set(second.claims) == (set(first.broken) - {""} or set(first.claims))


@pytest.mark.parametrize("name", ["no JSON", "a claim twice", "seen and not seen"])
def test_what_is_broken_on_every_rung_is_unknown_and_counted(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    _, spoil = SPOILT[name]

    def answer(body: Body) -> Sent:
        if purpose_of(body) not in ("sight", "arbitration"):
            return TRUTH(body)
        mine = [row for row in claims_in(body) if row["requirement"] == "part 0 is there"]
        rows = right(body)
        return completion(spoil(body, rows)) if mine else completion({"answers": rows})

    with JudgeEndpoint(answer) as endpoint:
        monkeypatch.setenv("C4S_JUDGE_URL", endpoint.url)
        made = claims_by_id(judged(evidence(tmp_path, CLAIMS), claims_per_request=1))
    assert (made["p0"].answer, made["p0"].score, made["p0"].fallback) == ("UNKNOWN", 0.0, True)
    assert (made["p1"].answer, made["p2"].answer) == ("MISMATCH", "MATCH")


def test_one_broken_claim_costs_its_neighbours_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with JudgeEndpoint(spoiling(changed(views=[]), 99)) as endpoint:
        monkeypatch.setenv("C4S_JUDGE_URL", endpoint.url)
        made = judged(evidence(tmp_path, CLAIMS))
    assert [(claim.answer, claim.stage) for claim in made.claims] == [
        ("MATCH", "arbitration"),
        ("MISMATCH", "sight"),
        ("MATCH", "sight"),
    ]


def test_words_that_no_file_can_hold_cost_no_judgement(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def answer(body: Body) -> Sent:
        if purpose_of(body) == "sight":
            return completion({"answers": [{**row, "saw": "half \ud800 of a pair"} for row in right(body)]})
        return completion({"prompt_aware": {**AWARE, "summary": "\udfff"}, "prompt_free": FREE}[purpose_of(body)])

    with JudgeEndpoint(answer) as endpoint:
        monkeypatch.setenv("C4S_JUDGE_URL", endpoint.url)
        for desk in (Desk(exchanges=tmp_path / "exchanges"), Desk()):
            made = judged(evidence(tmp_path, CLAIMS), desk)
            made.write(tmp_path / "made.json")
            assert Judgements.read(tmp_path / "made.json") == made
    assert [(claim.answer, claim.reason) for claim in made.claims] == [
        (answer, "half ? of a pair") for answer in ("MATCH", "MISMATCH", "MATCH")
    ]
    assert made.overview is not None and made.overview.summary == "?"


def overview_by(aware: Any, free: Any) -> Callable[[Body], Sent]:
    """An endpoint with these answers to the two calls."""
    return lambda body: completion({"prompt_aware": aware, "prompt_free": free}[purpose_of(body)])


def dimension(name: str, **fields: Any) -> Body:
    """The whole answer with one dimension changed."""
    made = copy.deepcopy(AWARE)
    made[name] = {**made[name], **fields}
    return made


def test_the_overview_is_two_calls_that_do_not_know_of_each_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    aware = dimension("composition_and_layout", score=0.6, anchor="partial")
    with JudgeEndpoint(overview_by(aware, {**FREE, "score": 0.8, "anchor": "minor"})) as endpoint:
        monkeypatch.setenv("C4S_JUDGE_URL", endpoint.url)
        made = judged(evidence(tmp_path, []))
    with_prompt, without = sorted(endpoint.raw, key=lambda raw: b"A made place." not in raw)
    assert b"A made place." in with_prompt and b"A made place." not in without
    assert b"secret palette" not in with_prompt + without and b"hidden tile" not in with_prompt + without
    verdict = verify_overview(made)
    assert verdict.score == round((0.4 + 0.25 * 0.6 + 0.2 + 0.15) * (0.75 + 0.25 * 0.8), 4)
    assert (verdict.policy, verdict.measurements["summary"]) == ("overview-two-calls.v1", "a scene")


@pytest.mark.parametrize(
    ("severe", "capped"),
    [
        ({"confidence": 0.8, "views": ["view-1", "view-4"]}, True),
        ({"confidence": 0.79, "views": ["view-1", "view-4"]}, False),
        ({"confidence": 1, "views": ["view-2"]}, False),
        ({"confidence": 1, "views": ["view-2", "view-2"]}, False),
        ({"confidence": 1, "views": ["view-3", "view-4"], "issues": [" "]}, False),
        ({"confidence": 1, "views": ["view-3", "view-4"], "categories": []}, False),
    ],
)
def test_a_severe_defect_caps_only_when_sure_seen_twice_and_named(
    severe: Body, capped: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    told = {"found": True, "categories": ["tearing"], "issues": ["a wall is torn"], **severe}
    free = {**FREE, "score": 0.5, "anchor": "clear", "severe": told}
    with JudgeEndpoint(overview_by(AWARE, free)) as endpoint:
        monkeypatch.setenv("C4S_JUDGE_URL", endpoint.url)
        verdict = verify_overview(judged(evidence(tmp_path, [])))
    assert (verdict.score == SEVERE_CAP) == capped and verdict.measurements["severe"]["issues"] == told["issues"]


@pytest.mark.parametrize(
    ("aware", "free"),
    [
        (dimension("completeness_and_polish", score=0.1), FREE),
        (dimension("completeness_and_polish", score=1.1), FREE),
        (dimension("completeness_and_polish", anchor="none"), FREE),
        ({**AWARE, "completeness_and_polish": None}, FREE),
        (AWARE, {**FREE, "severe": {**FREE["severe"], "found": True}}),
        (AWARE, {**FREE, "severe": None}),
        (AWARE, {**FREE, "score": 0.2}),
    ],
)
def test_an_overview_that_contradicts_itself_twice_is_a_fault_and_no_score(
    aware: Any, free: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with JudgeEndpoint(overview_by(aware, free)) as endpoint:
        monkeypatch.setenv("C4S_JUDGE_URL", endpoint.url)
        given = evidence(tmp_path, [])
        with pytest.raises(ContractBroken):
            judged(given)
        assert len(endpoint.bodies) == 3
        accepted = judged(given, Desk(accept_faults=True))
    assert accepted.overview is None and accepted.overview_reason.startswith("error: ")
    assert len(accepted.accepted_faults) == 1, "one call was lost, and is told once"
    verdict = verify_overview(accepted)
    assert verdict.status == "not_evaluated" and verdict.advisories[0]["code"] == "accepted_faults"


def test_a_call_that_fails_for_good_is_one_fault(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def answer(body: Body) -> Sent:
        return Sent(b'{"error": "gone"}', 404) if purpose_of(body) == "prompt_aware" else TRUTH(body)

    with JudgeEndpoint(answer) as endpoint:
        monkeypatch.setenv("C4S_JUDGE_URL", endpoint.url)
        accepted = judged(evidence(tmp_path, CLAIMS), Desk(accept_faults=True))
    assert len(accepted.accepted_faults) == 1 and "404" in accepted.accepted_faults[0]
    assert "1 request to the judge's model failed" in verify_overview(accepted).advisories[0]["text"]


def test_a_request_that_is_too_long_for_the_model_is_made_in_two(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def answer(body: Body) -> Sent:
        if purpose_of(body) == "sight" and len(claims_in(body)) > 1:
            return Sent(b'{"error": {"message": "maximum context length is 8192 tokens"}}', 400)
        return TRUTH(body)

    with JudgeEndpoint(answer) as endpoint:
        monkeypatch.setenv("C4S_JUDGE_URL", endpoint.url)
        made = judged(evidence(tmp_path, CLAIMS))
        assert [claim.answer for claim in made.claims] == ["MATCH", "MISMATCH", "MATCH"]
        endpoint.answer = lambda body: Sent(b'{"error": {"message": "maximum context length is 1 token"}}', 400)
        with pytest.raises(ChatFailed):
            judged(evidence(tmp_path, CLAIMS), Desk(fresh=True))


def test_the_tasks_text_ends_where_its_lists_begin() -> None:
    assert described("A yard.\n\n    === GROUND ===\nrows\n=== ASSET PALETTE ===\nrows") == "A yard."
    assert described("A yard.\n=== ASSET PALETTE ===\nrows") == "A yard." and described("A yard.\n") == "A yard."
