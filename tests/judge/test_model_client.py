"""The judge's client on endpoints that fail: nothing is lost, nothing invented, nothing asked or paid for twice."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import pytest
import yaml

from c4s.chat.failures import LONGEST_TOLD_WAIT_S, ChatEnded, ChatFailed, failure_of
from c4s.chat.replicas import Address, Replicas
from c4s.errors import BadInput
from c4s.files import read_json
from c4s.judge.desk import Desk
from c4s.meter.spending import Ledger, SpendingLimitReached
from c4s.verify.semantic.detailed import verify_detailed
from tests.judge.hostile_endpoint import FAILED, KINDS, Hostile
from tests.judge.judge_endpoint import Body, JudgeEndpoint, Sent, Truth, completion
from tests.judge.model_evidence import Claim, bundle, claims_by_id, evidence, judged

CLAIMS = [Claim(f"p{number}", f"part {number} is there") for number in range(12)]
MET = {claim.text: number % 3 > 0 for number, claim in enumerate(CLAIMS)}
TRUTH = Truth(MET)
ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A home of its own for each test, with prices of the judge's model."""
    made = tmp_path / "home"
    made.mkdir()
    price = {"model": "Qwen/Qwen3.8-27B", "from": "2026-01-01", "input": 1, "output": 10, "source": "test"}
    (made / "prices.yaml").write_text(yaml.safe_dump({"prices": [price]}))
    monkeypatch.setenv("C4S_HOME", str(made))
    monkeypatch.delenv("C4S_JUDGE_URL", raising=False)
    return made


def serve(home: Path, *urls: str, parallel: int | None = None) -> None:
    """Describe the judge's endpoint."""
    row = {"url": urls[0], "replicas": list(urls[1:]), "formats": ["openai-chat"], "parallel": parallel}
    (home / "endpoints.yaml").write_text(yaml.safe_dump({"endpoints": {"judge": row}}))


def test_a_hostile_endpoint_at_64_requests_costs_and_makes_no_score(tmp_path: Path, home: Path) -> None:
    claims = [Claim(f"p{number}", f"part {number} is there") for number in range(130)]
    met = {claim.text: number % 3 > 0 for number, claim in enumerate(claims)}
    hostile = Hostile(Truth(met, lambda purpose, claim: claim["requirement"].endswith("7 is there")))
    together = threading.Barrier(64)
    first = threading.Semaphore(64)

    def answer(body: Body) -> Sent:
        if first.acquire(blocking=False):
            together.wait(60)
        return hostile(body)

    with JudgeEndpoint(answer) as endpoint:
        serve(home, endpoint.url, parallel=64)
        made = judged(evidence(tmp_path, claims), claims_per_request=1, timeout_s=3.0)
        hostile.release.set()
    assert endpoint.most_open >= 64
    assert hostile.done.keys() >= {*KINDS, "true"}
    assert {claim.claim: claim.answer == "MATCH" for claim in made.claims} == {c.id: met[c.text] for c in claims}
    assert not any(claim.fallback for claim in made.claims) and not made.accepted_faults
    assert verify_detailed(bundle(claims), made).measurements["known_coverage"] == 1.0
    assert made.usage is not None and made.usage.failures >= sum(hostile.done[kind] for kind in FAILED)


def test_no_more_requests_are_open_than_the_endpoint_takes(tmp_path: Path, home: Path) -> None:
    with JudgeEndpoint(TRUTH) as endpoint:
        serve(home, endpoint.url, parallel=3)
        judged(evidence(tmp_path, CLAIMS), claims_per_request=1)
    assert 1 <= endpoint.most_open <= 3


def test_a_replica_that_is_gone_is_set_aside_and_the_others_do_its_work(tmp_path: Path, home: Path) -> None:
    with JudgeEndpoint(TRUTH) as one, JudgeEndpoint(TRUTH) as other:
        serve(home, "http://127.0.0.1:9/v1", one.url, other.url, parallel=1)
        made = judged(evidence(tmp_path, CLAIMS), claims_per_request=1)
    assert {claim.claim: claim.answer == "MATCH" for claim in made.claims} == {c.id: MET[c.text] for c in CLAIMS}
    assert one.bodies and made.usage is not None and 1 <= made.usage.failures < len(made.schedule)


def test_replicas_share_work_and_come_back_when_their_time_is_over() -> None:
    now = [0.0]
    replicas = Replicas([Address("a"), Address("b")], clock=lambda: now[0])
    first, second = replicas.take(), replicas.take()
    assert {first.address.url, second.address.url} == {"a", "b"}
    assert replicas.failed(first, None) is True and replicas.take() is second
    replicas.good(second)
    replicas.good(second)
    assert replicas.failed(replicas.take(), 100.0) is False
    assert replicas.take() is first
    replicas.let_go(first)
    now[0] = 5.0
    assert replicas.take() is first
    replicas.failed(first, None)
    now[0] = 14.9
    assert first.aside_until == 15.0 and replicas.take() is first
    replicas.good(first)
    assert (first.failures, first.aside_until) == (0, 0.0)


def test_an_address_that_asks_for_years_comes_back_in_minutes() -> None:
    now = [0.0]
    failure = failure_of(429, "slow down", "9" * 400)
    replicas = Replicas([Address("a"), Address("b")], clock=lambda: now[0])
    first = replicas.take()
    assert replicas.failed(first, failure.told_wait_s) and replicas.take() is not first
    now[0] = LONGEST_TOLD_WAIT_S
    assert replicas.take() is first


def test_when_all_are_down_it_is_a_fault_and_no_judgement(tmp_path: Path, home: Path) -> None:
    serve(home, "http://127.0.0.1:9/v1", "http://127.0.0.1:10/v1")
    with pytest.raises(ChatFailed, match="does not answer"):
        judged(evidence(tmp_path, CLAIMS))


def test_waiting_ends_with_the_run(tmp_path: Path, home: Path) -> None:
    waits: list[float] = []

    def wait(seconds: float) -> bool:
        waits.append(seconds)
        return len(waits) > 2

    with JudgeEndpoint(lambda body: Sent(b"no", 500)) as endpoint:
        serve(home, endpoint.url, parallel=1)
        with pytest.raises(ChatEnded):
            judged(evidence(tmp_path, CLAIMS), Desk(wait=wait))
    assert max(waits) <= 1.0


def failing_on(text: str) -> Any:
    """The truth, but no answer to requests about one claim."""

    def answer(body: Body) -> Sent:
        return Sent(b'{"error": "gone"}', 404) if text in json.dumps(body["messages"]) else TRUTH(body)

    return answer


def test_a_fault_leaves_no_judgement_and_accepted_it_is_an_error_worth_nothing(tmp_path: Path, home: Path) -> None:
    given = evidence(tmp_path, CLAIMS)
    with JudgeEndpoint(failing_on("part 3 is there")) as endpoint:
        serve(home, endpoint.url)
        with pytest.raises(ChatFailed, match="404"):
            judged(given, claims_per_request=1)
        made = judged(given, Desk(accept_faults=True), claims_per_request=1)
    found = claims_by_id(made)
    assert (found["p3"].answer, found["p3"].score, found["p3"].fallback) == ("ERROR", 0.0, False)
    assert all(claim.answer in ("MATCH", "MISMATCH") for name, claim in found.items() if name != "p3")
    verdict = verify_detailed(bundle(CLAIMS), made)
    assert verdict.population["errors"] == 1 and verdict.measurements["known_coverage"] == pytest.approx(
        11 / 12, abs=1e-4
    )
    assert verdict.score == pytest.approx(sum(met for text, met in MET.items() if "part 3 " not in text) / 12, abs=1e-4)
    assert verdict.advisories[0]["text"].startswith("1 request to the judge's model failed")


def test_an_answer_is_asked_and_paid_for_once(tmp_path: Path, home: Path) -> None:
    given = evidence(tmp_path, CLAIMS)
    with JudgeEndpoint(TRUTH) as endpoint:
        serve(home, endpoint.url)
        first = judged(given)
        asked = len(endpoint.bodies)
        second = judged(given, Desk(exchanges=tmp_path / "exchanges"))
        assert len(endpoint.bodies) == asked == first.usage.requests  # type: ignore[union-attr]
        assert second.usage.cached == asked and second.usage.cost_usd == 0.0  # type: ignore[union-attr]
        assert [row.answer_sha256 for row in second.schedule] == [row.answer_sha256 for row in first.schedule]
        assert all((tmp_path / "exchanges" / f"{row.answer_sha256}.json").is_file() for row in second.schedule)
        judged(given, Desk(fresh=True))
        assert len(endpoint.bodies) == 2 * asked
        judged(given, seed=1)
        assert len(endpoint.bodies) == 3 * asked
    assert first.claims == second.claims


def test_a_damaged_cache_is_asked_again(tmp_path: Path, home: Path) -> None:
    given = evidence(tmp_path, CLAIMS)
    with JudgeEndpoint(TRUTH) as endpoint:
        serve(home, endpoint.url)
        first = judged(given)
        asked = len(endpoint.bodies)
        kept = sorted((home / "cache/judge").rglob("*.json"))
        assert len(kept) == asked
        kept[0].write_text('{"request_')
        other = read_json(kept[1])
        kept[1].write_text(json.dumps({**other, "message": {"content": "{}"}}))
        again = judged(given)
    assert len(endpoint.bodies) == asked + 2 and again.claims == first.claims


def test_a_judge_that_is_killed_goes_on_from_its_answers(tmp_path: Path, home: Path) -> None:
    given = evidence(tmp_path, CLAIMS)
    code = (
        "import sys\nfrom pathlib import Path\nfrom tests.judge.test_model_client import CLAIMS\n"
        "from tests.judge.model_evidence import evidence, judged\n"
        "judged(evidence(Path(sys.argv[1]), CLAIMS), claims_per_request=1)\n"
    )
    victim: list[int] = []

    def answer(body: Body) -> Sent:
        if len(endpoint.bodies) == 6:
            os.kill(victim[0], signal.SIGKILL)
        return TRUTH(body)

    with JudgeEndpoint(answer) as endpoint:
        serve(home, endpoint.url, parallel=1)
        process = subprocess.Popen([sys.executable, "-c", code, str(tmp_path)], cwd=ROOT)
        victim.append(process.pid)
        assert process.wait(60) == -signal.SIGKILL
        assert len(endpoint.bodies) == 6
        made = judged(given, claims_per_request=1)
    assert {claim.claim: claim.answer == "MATCH" for claim in made.claims} == {c.id: MET[c.text] for c in CLAIMS}
    assert made.usage is not None and made.usage.cached == 5 and len(endpoint.bodies) == 6 + made.usage.requests - 5


def test_the_money_of_a_run_is_kept_within_its_limit(tmp_path: Path, home: Path) -> None:
    given = evidence(tmp_path, CLAIMS)
    ledger = Ledger(tmp_path / "judging.jsonl", 0.1)
    with JudgeEndpoint(lambda body: completion_with(TRUTH(body))) as endpoint:
        serve(home, endpoint.url, parallel=1)
        with pytest.raises(SpendingLimitReached, match="judge"):
            judged(given, Desk(ledger=ledger), claims_per_request=1)
        assert ledger.spent().settled_usd == pytest.approx(0.1) and len(endpoint.bodies) == 5
        made = judged(given, Desk(ledger=Ledger(tmp_path / "judging.jsonl", 10.0)), claims_per_request=1)
    assert made.usage is not None and made.usage.cached == 5
    assert made.usage.cost_usd == pytest.approx(0.02 * (made.usage.requests - 5))


def completion_with(sent: Sent) -> Sent:
    """The same answer with a usage that costs 2 cents."""
    content = json.loads(sent.body)["choices"][0]["message"]["content"]
    return completion(content, usage={"prompt_tokens": 10_000, "completion_tokens": 1_000})


def test_the_tokens_of_a_run_are_kept_within_their_limit(tmp_path: Path, home: Path) -> None:
    ledger = Ledger(tmp_path / "judging.jsonl", None, limit_tokens=3000)
    with JudgeEndpoint(TRUTH) as endpoint:
        serve(home, endpoint.url, parallel=1)
        with pytest.raises(SpendingLimitReached, match="tokens"):
            judged(evidence(tmp_path, CLAIMS), Desk(ledger=ledger), claims_per_request=1)
    assert ledger.spent().tokens == 3300 and len(endpoint.bodies) == 3


@pytest.mark.parametrize("tokens", [10**30, 1e300, -1, 1.5, True, "many", [7], 2**63])
def test_a_usage_that_cannot_be_is_unknown_and_leaves_the_limit_to_the_others(
    tokens: Any, tmp_path: Path, home: Path
) -> None:
    ledger = Ledger(tmp_path / "judging.jsonl", 100.0, limit_tokens=10**9)

    def answer(body: Body) -> Sent:
        content = json.loads(TRUTH(body).body)["choices"][0]["message"]["content"]
        return completion(content, usage={"prompt_tokens": tokens, "completion_tokens": 1})

    with JudgeEndpoint(answer) as endpoint:
        serve(home, endpoint.url)
        made = judged(evidence(tmp_path, CLAIMS), Desk(ledger=ledger))
    assert {claim.claim: claim.answer == "MATCH" for claim in made.claims} == {c.id: MET[c.text] for c in CLAIMS}
    assert made.usage is not None and made.usage.unknown == made.usage.requests == len(endpoint.bodies)
    assert made.usage.cost_usd is None and 0 < ledger.spent().held_usd < 1 and ledger.spent().settled_usd == 0


def test_without_a_price_no_limit_in_money_can_be_kept(tmp_path: Path, home: Path) -> None:
    (home / "prices.yaml").unlink()
    with JudgeEndpoint(TRUTH) as endpoint:
        serve(home, endpoint.url)
        with pytest.raises(SpendingLimitReached, match="no price"):
            judged(evidence(tmp_path, CLAIMS), Desk(ledger=Ledger(tmp_path / "judging.jsonl", 1.0)))
        made = judged(evidence(tmp_path, CLAIMS), Desk(ledger=Ledger(tmp_path / "judging.jsonl", None)))
    assert made.usage is not None and made.usage.cost_usd is None and made.usage.input_tokens > 0


@pytest.mark.parametrize("url", ["", "ftp://host", "http://", "http://[", "host:80"])
def test_what_is_no_address_is_refused(url: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("C4S_JUDGE_URL", f"{url},{url}" if url else " ")
    with pytest.raises(BadInput, match="C4S_JUDGE_URL"):
        judged(evidence(tmp_path, CLAIMS))
