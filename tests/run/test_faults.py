"""A few of the faults of ``python -m bench.faults``, done for real: nothing is lost, repeated twice or left behind."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from bench.fault_table import FAULTS
from bench.faults import tried, undisturbed

FAST = (
    "kill -9 of the driver at the saved scene",
    "kill -9 of the workers at the gate's verdict",
    "truncated outcome rows",
    "garbled trajectory, moved away as told",
)


@pytest.fixture(scope="module")
def undisturbed_run(home: Path) -> Iterator[tuple[Path, list[str]]]:
    with undisturbed(home) as made:
        yield made


@pytest.mark.parametrize("name", FAST)
def test_a_fault_costs_nothing(home: Path, undisturbed_run: tuple[Path, list[str]], name: str) -> None:
    (fault,) = [fault for fault in FAULTS if fault.name == name]
    result = tried(fault, home, *undisturbed_run)
    assert result.holds, result


def test_the_table_names_each_fault_once() -> None:
    names = [fault.name for fault in FAULTS]
    assert len(names) == len(set(names)) >= 40
