"""What a trial's rows tell of model requests: classes of tokens at their rates, and unknown apart from zero."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from c4s.meter.prices import COST_CLASSES
from c4s.meter.record import RequestRecord
from warehouse.usage import TOKEN_CLASSES, usage_columns

DAY = 1_790_000_000.0
"""In September 2026."""
KNOWN = {
    "input_tokens": 1_500_000,
    "fresh_input_tokens": 1_000_000,
    "cache_read_tokens": 400_000,
    "cache_write_tokens": 100_000,
    "cache_write_1h_tokens": 0,
    "output_tokens": 200_000,
}


@pytest.fixture
def priced(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A home with prices of its own."""
    home = tmp_path / "home"
    home.mkdir()
    (home / "prices.yaml").write_text(
        "prices:\n- {model: m, from: 2026-01-01, input: 2, output: 10, cache_read: 0.5, cache_write: 4, source: t}\n"
    )
    monkeypatch.setenv("C4S_HOME", str(home))
    return tmp_path / "usage.jsonl"


def request(**other: Any) -> RequestRecord:
    given = {"seq": 1, "time": DAY, "wire": "openai-chat", "path": "/", "model": "m", "ending": "ok", "duration_s": 1.0}
    return RequestRecord.parse({**given, "request_bytes": 1, **KNOWN, **other})


def told(path: Path, *requests: RequestRecord) -> dict[str, Any]:
    path.write_text("".join(json.dumps(one.plain()) + "\n" for one in requests))
    return usage_columns(path)


def test_each_class_has_its_rate(priced: Path) -> None:
    found = told(priced, request(), request())
    assert (found["requests"], found["unpriced_requests"]) == (2, 0)
    assert [found[name] for name in TOKEN_CLASSES] == [2_000_000, 800_000, 200_000]
    assert [found[f"{name}_usd"] for name in COST_CLASSES] == pytest.approx([4.0, 0.4, 0.8, 4.0])


@pytest.mark.parametrize(
    "other",
    [
        {"model": "nobody-sells-it"},
        {"cache_read_tokens": None, "fresh_input_tokens": None},
        {"output_tokens": None},
        {"ending": "cut"},
        {"ending": "aborted"},
    ],
)
def test_one_request_that_is_not_known_leaves_no_sum(priced: Path, other: dict[str, Any]) -> None:
    found = told(priced, request(), request(**other))
    assert found["unpriced_requests"] == 1 and found["requests"] == 2
    assert [found[f"{name}_usd"] for name in COST_CLASSES] == [None] * len(COST_CLASSES)


def test_what_was_never_billed_costs_nothing_and_asks_for_no_price(priced: Path) -> None:
    zero = dict.fromkeys(KNOWN, 0)
    found = told(priced, request(), request(ending="refused", model="nobody-sells-it", **zero))
    assert found["unpriced_requests"] == 0 and found["output_usd"] == pytest.approx(2.0)


def test_a_request_for_no_output_is_none_and_no_record_is_unknown(priced: Path) -> None:
    assert told(priced, request(wire=None)) == {}
    assert usage_columns(priced.with_name("missing.jsonl")) == {}


def test_a_price_that_is_added_later_prices_the_same_requests(priced: Path) -> None:
    before = told(priced, request(model="late"))
    assert before["output_usd"] is None and before["fresh_input_tokens"] == 1_000_000
    prices = priced.parent / "home" / "prices.yaml"
    prices.write_text(prices.read_text() + "- {model: late, from: 2026-01-01, input: 1, output: 1, source: t}\n")
    assert usage_columns(priced)["output_usd"] == pytest.approx(0.2)
