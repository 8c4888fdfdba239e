"""Judgements repeated from their own schedule, on an endpoint that answers over HTTP: what is asked, what is kept."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import pytest

from c4s.chat.failures import ChatFailed
from c4s.errors import BadInput
from c4s.files import read_json, write_json
from c4s.judge.desk import Desk
from c4s.judge.registry import repeat_judgements
from c4s.records.evidence import Evidence
from c4s.records.judge import RULE_JUDGE
from c4s.records.judgement import ClaimJudgement, Judgements
from c4s.records.repeatability import ServedRepeat
from tests.judge.judge_endpoint import Body, JudgeEndpoint, Sent, Truth, claims_in, completion, purpose_of
from tests.judge.model_evidence import QWEN, Claim, claims_by_id, evidence, judged
from tests.judge.test_model_ladder import known, sorted_views


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A cache of its own for each test."""
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    monkeypatch.delenv("C4S_JUDGE_KEY", raising=False)


@pytest.fixture
def on(monkeypatch: pytest.MonkeyPatch) -> Callable[[JudgeEndpoint], None]:
    """Sets where the judge's model is."""
    return lambda endpoint: monkeypatch.setenv("C4S_JUDGE_URL", endpoint.url)


On = Callable[[JudgeEndpoint], None]


def scene(root: Path, count: int = 33) -> tuple[Evidence, Truth]:
    """Evidence whose claims end on all rungs, some of them made of others that are not scored themselves."""
    claims, met = known(count)
    hidden = [Claim(claim.id, claim.text, claim.kind, claim.denied, scored=False) for claim in claims[:6]]
    claims = [*hidden, *claims[6:]]
    rng = random.Random(3)
    late = {claim.text: rng.choice(("sight", "alternate", "arbitration")) for claim in claims}
    truth = Truth(met, lambda purpose, claim: late[claim["requirement"]] not in ("sight", purpose))
    return evidence(root, claims, sorted_views(claims)), truth


def stored(root: Path, given: Evidence) -> Judgements:
    """Judgements with their requests beside them, as a run keeps them."""
    return judged(given, Desk(exchanges=root / "stored", wait=lambda seconds: False))


def repeated(root: Path, made: Judgements, given: Evidence, name: str = "repeat") -> Judgements:
    """One repeat."""
    at = Desk(exchanges=root / name, answers=root / f"{name}-answers", fresh=True, wait=lambda seconds: False)
    return repeat_judgements(QWEN, made, given, root / "stored", at)


def told(made: Judgements) -> list[ClaimJudgement]:
    """All claims of judgements."""
    return [*made.claims, *made.beneath]


def test_a_repeat_sends_the_stored_requests_of_claims_and_no_other(tmp_path: Path, on: On) -> None:
    given, truth = scene(tmp_path)
    with JudgeEndpoint(truth) as endpoint:
        on(endpoint)
        made = stored(tmp_path, given)
        first = Counter(raw for raw, body in zip(endpoint.raw, endpoint.bodies, strict=True) if claims_of(body))
        endpoint.raw.clear()
        again = repeated(tmp_path, made, given)
        assert Counter(endpoint.raw) == first
    assert {row.purpose for row in again.schedule} == {"sight", "alternate", "arbitration"}
    assert [row.request_sha256 for row in again.schedule] == [row.request_sha256 for row in made.claim_schedule()]
    assert [row.views for row in again.schedule] == [row.views for row in made.claim_schedule()]
    assert told(again) == told(made) and made.beneath and again.overview is None
    assert again.usage is not None and again.usage.requests == len(endpoint.raw) and again.usage.cached == 0
    assert again.served is not None and (again.served.replicas, again.served.models) == (1, ["m"])


def claims_of(body: Body) -> bool:
    """Whether a request asks for claims."""
    return purpose_of(body) in ("sight", "alternate", "arbitration")


def test_fresh_answers_decide_and_logic_follows_while_the_routing_stays(tmp_path: Path, on: On) -> None:
    given, truth = scene(tmp_path)
    with JudgeEndpoint(truth) as endpoint:
        on(endpoint)
        made = stored(tmp_path, given)
        endpoint.answer = Truth({text: not met for text, met in truth.met.items()})
        again = repeated(tmp_path, made, given)
    before, after = claims_by_id(made), claims_by_id(again)
    turned = {"MATCH": "MISMATCH", "MISMATCH": "MATCH"}
    leaves = [claim for claim in before.values() if claim.stage != "combined"]
    assert leaves and all(after[claim.claim].answer == turned[claim.answer] for claim in leaves)
    assert {claim.claim: claim.stage for claim in told(again)} == {claim.claim: claim.stage for claim in told(made)}
    parts = {claim.claim: claim.answer for claim in told(again)}
    logic = [claim for claim in after.values() if claim.stage == "combined"]
    assert logic and all(
        claim.measures == {"operands": {p: parts[p] for p in claim.measures["operands"]}} for claim in logic
    )
    assert any(after[claim.claim].answer != before[claim.claim].answer for claim in logic)


def test_what_breaks_its_contract_twice_is_unknown_and_a_fallback(tmp_path: Path, on: On) -> None:
    """The second request is the one that the ladder would write; it is no part of the schedule."""
    given, truth = scene(tmp_path)

    def broken(body: Body) -> Sent:
        lost = [row["requirement"] for row in claims_in(body)] if claims_of(body) else []
        sent = truth(body)
        return completion({"answers": []}) if any(text.endswith("7 holds") for text in lost) else sent

    with JudgeEndpoint(truth) as endpoint:
        on(endpoint)
        made = stored(tmp_path, given)
        endpoint.answer = broken
        again = repeated(tmp_path, made, given)
        ladder = judged(given, Desk(fresh=True, wait=lambda seconds: False))
    fallbacks = [claim for claim in told(again) if claim.fallback]
    assert fallbacks and {claim.answer for claim in fallbacks} == {"UNKNOWN"}
    anew = [row for row in again.schedule if row.again]
    assert anew and len(again.schedule) - len(anew) == len(made.claim_schedule())
    wanted = {row.request_sha256 for row in ladder.schedule if row.again and row.purpose == "sight"}
    assert wanted == {row.request_sha256 for row in anew if row.purpose == "sight"}
    with JudgeEndpoint(truth) as endpoint:
        on(endpoint)
        once = repeated(tmp_path, again, given, "from-broken")
        assert len(endpoint.bodies) == len(made.claim_schedule()) and not any(row.again for row in once.schedule)


def test_a_repeat_that_was_cut_off_goes_on_with_the_answers_it_has(tmp_path: Path, on: On) -> None:
    given, truth = scene(tmp_path)
    with JudgeEndpoint(truth) as endpoint:
        on(endpoint)
        made = stored(tmp_path, given)
        planned = len(made.claim_schedule())
        endpoint.bodies.clear()
        left = iter(range(planned // 2))
        endpoint.answer = lambda body: truth(body) if next(left, None) is not None else Sent(b"{}", 400)
        with pytest.raises(ChatFailed):
            repeated(tmp_path, made, given)
        kept = len(list((tmp_path / "repeat-answers").rglob("*.json")))
        assert 0 < kept <= planned // 2
        endpoint.bodies.clear()
        endpoint.answer = truth
        again = repeated(tmp_path, made, given)
        assert len(endpoint.bodies) == planned - kept
    assert told(again) == told(made)
    assert again.usage is not None and again.usage.input_tokens == 1000 * planned


def test_what_is_not_as_it_was_stored_is_not_repeated(tmp_path: Path, on: On) -> None:
    given, truth = scene(tmp_path)
    with JudgeEndpoint(truth) as endpoint:
        on(endpoint)
        made = stored(tmp_path, given)
        with pytest.raises(BadInput, match="another version of the judge"):
            repeated(tmp_path, made.model_copy(update={"judge_version": "0+older"}), given)
        with pytest.raises(BadInput, match="asks no model"):
            repeat_judgements(RULE_JUDGE, made, given, tmp_path / "stored", Desk())
        (tmp_path / "captures/claim-3.png").write_bytes((tmp_path / "captures/claim-4.png").read_bytes())
        with pytest.raises(BadInput, match="pictures of this request"):
            repeated(tmp_path, made, Evidence(given.setting, given.prompt, given.files))
        file = tmp_path / "stored" / f"{made.schedule[0].request_sha256}.json"
        write_json(file, {**read_json(file), "temperature": 1.0})
        with pytest.raises(BadInput, match="has changed since it was stored"):
            repeated(tmp_path, made, given)
        file.unlink()
        with pytest.raises(BadInput, match="no such request"):
            repeated(tmp_path, made, given)


def test_who_answered_may_change_between_repeats_and_is_on_record(
    tmp_path: Path, on: On, monkeypatch: pytest.MonkeyPatch
) -> None:
    given, truth = scene(tmp_path)

    def other(body: Body) -> Sent:
        return Sent(truth(body).body.replace(b'"model": "m"', b'"model": "m-int4", "system_fingerprint": "fp_2"'))

    with JudgeEndpoint(truth) as endpoint, JudgeEndpoint(other) as second:
        on(endpoint)
        made = stored(tmp_path, given)
        one = repeated(tmp_path, made, given, "one")
        monkeypatch.setenv("C4S_JUDGE_URL", f"{endpoint.url},{second.url}")
        two = repeated(tmp_path, made, given, "two")
    said = [[(claim.claim, claim.answer) for claim in told(judgements)] for judgements in (made, one, two)]
    assert said[0] == said[1] == said[2]
    assert one.served is not None and two.served is not None and second.bodies
    assert (one.served.replicas, one.served.models, one.served.fingerprints) == (1, ["m"], [])
    assert (two.served.replicas, two.served.models, two.served.fingerprints) == (2, ["m", "m-int4"], ["fp_2"])
    both = ServedRepeat.of([one.served, two.served])
    assert both.replicas == (1, 2) and both.models == ["m", "m-int4"]
