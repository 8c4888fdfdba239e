"""A meter with runs, in front of an upstream on loopback."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "agent_clients"))
sys.path.insert(0, str(Path(__file__).parent))

from c4s.meter.endpoints import ModelEndpoint
from c4s.meter.exchange import Timeouts
from c4s.meter.meter import Meter
from c4s.meter.metered import MeterRun
from c4s.meter.prices import Price, PriceTable
from c4s.meter.wire import BY_NAME

MODEL = "model-1"
PRICE = Price.model_validate(
    {
        "model": MODEL,
        "from": "2026-01-01",
        "input": 10,
        "output": 100,
        "cache_read": 1,
        "cache_write": 12,
        "cache_write_1h": 20,
        "source": "test",
    }
)


@pytest.fixture(scope="session")
def meter() -> Iterator[Meter]:
    with Meter(Timeouts(connect_s=5, silence_s=0.5)) as opened:
        yield opened


@pytest.fixture
def open_run(meter: Meter, tmp_path: Path) -> Iterator[Callable[..., MeterRun]]:
    """Open a run towards an upstream; ``number`` tells runs of one test apart."""
    opened = []

    def start(url: str, number: int = 1, **options: Any) -> MeterRun:
        endpoint = ModelEndpoint(url=url, formats=options.pop("formats", list(BY_NAME)), **options.pop("endpoint", {}))
        run = MeterRun(
            f"run-{number}",
            endpoint,
            "real-key",
            tmp_path / f"usage-{number}.jsonl",
            prices=PriceTable([PRICE]),
            **options,
        )
        meter.open_run(run)
        opened.append(run)
        return run

    yield start
    for run in opened:
        meter.close_run(run)
