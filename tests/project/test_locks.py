"""The locks: what runs c4s is a part of what develops it, with the same versions, by hash, from no named place."""

from __future__ import annotations

import re
import tomllib

import pytest

from bench.locks import ROOT, RUN, WHOLE, locked, normal
from c4s import weights

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
EXTRAS = PROJECT["optional-dependencies"]
HELD = {row.name for row in locked(RUN)}


def _names(requirements: list[str]) -> set[str]:
    return {normal(re.split(r"[\[<>=!~; ]", one, maxsplit=1)[0]) for one in requirements} - {"c4s"}


def test_what_runs_is_a_part_of_the_whole_with_the_same_versions_and_digests() -> None:
    whole = {(row.name, row.version): row.hashes for row in locked(WHOLE)}
    rows = locked(RUN)
    assert 50 < len(rows) < len(whole)
    assert [row for row in rows if whole.get((row.name, row.version)) != row.hashes] == []


def test_what_runs_holds_what_the_wheel_asks_for_and_the_model_and_no_extra() -> None:
    assert _names([*PROJECT["dependencies"], weights.REQUIREMENT]) <= HELD
    assert {extra: held for extra in EXTRAS if extra != "dev" and (held := _names(EXTRAS[extra]) & HELD)} == {}


def test_the_whole_holds_what_is_developed_with() -> None:
    whole = {row.name for row in locked(WHOLE)}
    assert EXTRAS.keys() == {"service", "s3", "plots", "telemetry", "inspect", "dev"}
    assert [name for extra in EXTRAS.keys() - {"inspect"} for name in sorted(_names(EXTRAS[extra]) - whole)] == []


@pytest.mark.parametrize("name", [RUN, WHOLE])
def test_a_lock_names_no_place(name: str) -> None:
    assert not re.search(r"https?:|file:|--(?:extra-)?index|--find-links| @ ", (ROOT / name).read_text())


def test_the_wheel_asks_for_nothing_that_brings_pytorch() -> None:
    asked = _names([*PROJECT["dependencies"], *(one for requirements in EXTRAS.values() for one in requirements)])
    assert not asked & {*_names([weights.REQUIREMENT]), "torch", "sentence-transformers", "transformers"}


def test_the_model_is_the_locked_one() -> None:
    rows = [row for row in locked(RUN) if f"{row.name}=={row.version}" == weights.REQUIREMENT]
    assert len(rows) == 1 and weights.WHEEL_SHA256 in rows[0].hashes
