"""Prices by day, unknown apart from zero, and the spending limit of a run."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable
from datetime import date
from pathlib import Path

import httpx
import pytest
from canned import CannedUpstream, Reply
from hypothesis import given
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.meter.endpoints import LIMIT_VARIABLE, model_endpoint, spending_limit
from c4s.meter.meter import Meter
from c4s.meter.metered import MeterRun
from c4s.meter.prices import PriceTable, cost_of
from c4s.meter.record import sums
from c4s.meter.spending import Ledger
from c4s.meter.usage import UNKNOWN, ZERO, Usage

COSTLY = Reply(
    [b'{"choices": [], "usage": {"prompt_tokens": 0, "completion_tokens": 5000, "prompt_tokens_details": {}}}']
)
"""Half a dollar at the test price."""


def table(text: str, tmp_path: Path) -> PriceTable:
    path = tmp_path / "prices.yaml"
    path.write_text(text)
    return PriceTable.load(path)


def test_the_price_of_the_day(tmp_path: Path) -> None:
    prices = table(
        "prices:\n"
        "- {model: m, from: 2026-01-01, input: 1, output: 2, source: a}\n"
        "- {model: m, also: [x/m], from: 2026-03-01, input: 3, output: 4, source: b}\n"
        "- {model: sale, from: 2026-03-01, until: 2026-03-31, input: 3, output: 4, source: b}\n",
        tmp_path,
    )
    assert prices.price("m", date(2025, 12, 31)) is None
    assert [
        price.input
        for day in (date(2026, 1, 1), date(2026, 2, 28), date(2026, 3, 1))
        if (price := prices.price("m", day))
    ] == [1, 1, 3]
    assert prices.price("sale", date(2026, 3, 31)) and prices.price("sale", date(2026, 4, 1)) is None
    assert prices.price("x/m", date(2026, 2, 1)) is None and prices.price("m-2", date(2026, 5, 1)) is None


@pytest.mark.parametrize(
    "text",
    [
        "prices: [{model: m, from: 2026-01-01, input: -1, output: 1, source: a}]",
        "prices: [{model: m, input: 1, output: 1, source: a}]",
        "prices: [{model: m, from: soon, input: 1, output: 1, source: a}]",
        "prices: [",
        "[]",
    ],
)
def test_a_bad_price_table_is_named(tmp_path: Path, text: str) -> None:
    with pytest.raises(BadInput, match=r"prices\.yaml"):
        table(text, tmp_path)


def test_the_shipped_table_can_be_read() -> None:
    price = PriceTable.load().price("claude-sonnet-4-5-20250929", date(2026, 11, 1))
    assert price is not None and price.source and price.cache_write_1h == 2 * price.input


@pytest.mark.parametrize(
    "model",
    [
        "openai/gpt-6-astra",
        "gpt-5.6-sol",
        "claude-fable-5-1",
        "claude-opus-5",
        "gemini-3.8-flash",
        "x-ai/grok-4.6",
        "meta/muse-spark-1.3",
        "z-ai/glm-5.3-flash",
        "deepseek/deepseek-v4.1-flash",
        "thinkingmachines/inkling",
    ],
)
def test_hosted_models_of_the_paper_have_a_price_and_those_that_are_served_by_oneself_have_none(model: str) -> None:
    prices, day = PriceTable.load(), date(2026, 11, 1)
    price = prices.price(model, day)
    assert price is not None and 0 < (price.cache_read or 0) < price.input < price.output and "2026-11" in price.source
    for open_weights in ("Qwen/Qwen3.8-27B", "qwen/qwen3.8-27b", "google/gemma-4-31b-it"):
        assert prices.price(open_weights, day) is None
        assert cost_of(ZERO, prices.price(open_weights, day)).usd is None


CLASSES = st.integers(0, 10**7)


@given(CLASSES, CLASSES, CLASSES, CLASSES)
def test_a_class_without_a_price_of_its_own_is_billed_as_input(fresh: int, read: int, write: int, output: int) -> None:
    usage = Usage(
        input_tokens=fresh + read + write,
        fresh_input_tokens=fresh,
        cache_read_tokens=read,
        cache_write_tokens=write,
        cache_write_1h_tokens=0,
        output_tokens=output,
    )
    row = {"model": "m", "from": "2026-01-01", "input": 2, "output": 10, "source": "t"}
    from c4s.meter.prices import Price

    plain = cost_of(usage, Price.model_validate(row))
    assert plain.usd == pytest.approx(((fresh + read + write) * 2 + output * 10) / 1e6)
    cheap = cost_of(usage, Price.model_validate({**row, "cache_read": 0}))
    assert cheap.usd == pytest.approx(((fresh + write) * 2 + output * 10) / 1e6)


def test_unknown_is_not_zero() -> None:
    price = PriceTable.load().price("claude-sonnet-4-5", date(2026, 11, 1))
    assert cost_of(ZERO, price).usd == 0 and cost_of(UNKNOWN, price).usd is None and cost_of(ZERO, None).usd is None
    known, unknown = {"wire": "x", "cost_usd": 1.0, "input_tokens": 5, "output_tokens": 0}, {"wire": "x"}
    assert sums([known, known])["cost_usd"] == 2 and sums([known, unknown])["cost_usd"] is None
    assert sums([])["cost_usd"] is None and sums([known, {"wire": None, "cost_usd": 0}])["input_tokens"] == 5


HTTP = httpx.Client(trust_env=False, timeout=20)


def ask(meter: Meter, run: MeterRun, model: str = "model-1", path: str = "/v1/chat/completions") -> httpx.Response:
    return HTTP.post(
        meter.url + path, json={"model": model, "max_tokens": 10}, headers={"Authorization": f"Bearer {run.token}"}
    )


def test_the_limit_refuses_with_a_clear_error_and_a_higher_limit_goes_on(
    meter: Meter, open_run: Callable[..., MeterRun], tmp_path: Path
) -> None:
    stopped: list[int] = []
    with CannedUpstream(COSTLY) as upstream:
        run = open_run(
            upstream.url, ledger=Ledger(tmp_path / "spending.jsonl", 0.9), at_limit=lambda: stopped.append(1)
        )
        assert [ask(meter, run).status_code for _ in range(4)] == [200, 200, 402, 402]
        refusal = ask(meter, run, path="/v1/messages").json()
        assert refusal["error"]["type"] == "billing_error" and "spending limit" in refusal["error"]["message"]
        assert stopped == [1] and len(upstream.requests) == 2
        assert [record.cost_usd for record in run.records] == [0.5, 0.5, 0, 0, 0]
        again = open_run(upstream.url, 2, ledger=Ledger(tmp_path / "spending.jsonl", 1.2))
        assert [ask(meter, again).status_code for _ in range(2)] == [200, 402]


def test_under_a_limit_a_model_without_a_price_is_refused(
    meter: Meter, open_run: Callable[..., MeterRun], tmp_path: Path
) -> None:
    with CannedUpstream(COSTLY) as upstream:
        limited = open_run(upstream.url, ledger=Ledger(tmp_path / "a.jsonl", 5))
        got = ask(meter, limited, "unpriced")
        assert got.status_code == 402 and "no price for model 'unpriced'" in got.text and upstream.requests == []
        free = open_run(upstream.url, 2, ledger=Ledger(tmp_path / "b.jsonl", None))
        assert ask(meter, free, "unpriced").status_code == 200
    assert free.records[0].cost_usd is None and free.records[0].cost_note == "no price for this model"
    assert Ledger(tmp_path / "b.jsonl", None).spent().unknown == 1


def test_an_unknown_cost_counts_as_its_estimate(
    meter: Meter, open_run: Callable[..., MeterRun], tmp_path: Path
) -> None:
    with CannedUpstream(Reply([b"{}"])) as upstream:
        run = open_run(upstream.url, ledger=Ledger(tmp_path / "spending.jsonl", 5))
        ask(meter, run)
    spent = Ledger(tmp_path / "spending.jsonl", 5).spent()
    assert spent.settled_usd == 0 and 0.001 < spent.held_usd < 0.01 and spent.unknown == 1


def test_a_line_that_a_crash_cut_short_loses_nothing_else(tmp_path: Path) -> None:
    path = tmp_path / "spending.jsonl"
    ledger = Ledger(path, 10)
    first = ledger.hold(1.0)
    assert first is not None
    ledger.settle(first, 2.0)
    with path.open("ab") as lines:
        lines.write(b'{"hold": "lost", "us')
    second = Ledger(path, 10).hold(3.0)
    assert second is not None
    assert (ledger.spent().settled_usd, ledger.spent().held_usd) == (2.0, 3.0)
    assert Ledger(path, 5).hold(0.1) is None


def test_what_open_requests_may_take_is_told_apart_from_what_was_used(tmp_path: Path) -> None:
    ledger = Ledger(tmp_path / "judging.jsonl", None, limit_tokens=10_000)
    first = ledger.hold(0.05, 9_000)
    assert first is not None
    ledger.settle(first, 0.0025, 1_700)
    assert ledger.spent().told() == "0.0025 USD, 1700 tokens"
    assert ledger.hold(0.05, 9_000) is not None and ledger.hold(0.05, 9_000) is None
    told = "0.0025 USD, 1700 tokens, and up to 0.0500 USD, 9000 tokens of requests not yet accounted for"
    assert ledger.spent().told() == told


def _spend(path: str, results: list[bool]) -> None:
    ledger = Ledger(Path(path), 1.0)
    for _ in range(40):
        entry = ledger.hold(0.05)
        results.append(entry is not None)
        if entry is not None:
            ledger.settle(entry, 0.05)


def test_processes_share_one_limit(tmp_path: Path) -> None:
    path = tmp_path / "spending.jsonl"
    context = multiprocessing.get_context("fork")
    workers = [context.Process(target=_spend, args=(str(path), [])) for _ in range(3)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert 1.0 <= Ledger(path, None).spent().total_usd + 1e-9 <= 1.0 + 3 * 0.05


def test_the_limit_and_the_endpoints_come_from_the_operator(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path))
    monkeypatch.delenv(LIMIT_VARIABLE, raising=False)
    monkeypatch.delenv("C4S_ENDPOINTS", raising=False)
    assert spending_limit() is None
    (tmp_path / "endpoints.yaml").write_text(
        "spending_limit_usd: 40\nendpoints: {own: {url: 'http://10.0.0.5:8000/v1', formats: [openai-chat]}}\n"
    )
    assert spending_limit() == 40 and model_endpoint("own").key_env is None
    (tmp_path / "other.yaml").write_text("spending_limit_usd: 7\n")
    with monkeypatch.context() as other:
        other.setenv("C4S_ENDPOINTS", str(tmp_path / "other.yaml"))
        assert spending_limit() == 7
    monkeypatch.setenv(LIMIT_VARIABLE, "2.5")
    assert spending_limit() == 2.5
    monkeypatch.setenv(LIMIT_VARIABLE, "much")
    with pytest.raises(BadInput, match="not an amount"):
        spending_limit()
    with pytest.raises(BadInput, match="own"):
        model_endpoint("nowhere")
