"""The bill of materials: valid CycloneDX, of every locked package, the same each time."""

from __future__ import annotations

import json
from typing import Any

import pytest
from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator

from bench.locks import RUN, WHOLE, locked
from bench.sbom import bill


@pytest.mark.parametrize("run_only", [False, True])
def test_it_is_valid_and_the_same_each_time(run_only: bool) -> None:
    text = json.dumps(bill(run_only=run_only))
    assert JsonStrictValidator(SchemaVersion.V1_6).validate_str(text) is None
    assert json.dumps(bill(run_only=run_only)) == text


def _rows(made: dict[str, Any]) -> list[tuple[str, str, tuple[str, ...]]]:
    return [(one["name"], one["version"], tuple(row["content"] for row in one["hashes"])) for one in made["components"]]


def test_it_holds_what_the_locks_hold() -> None:
    whole, run = bill(run_only=False), bill(run_only=True)
    assert _rows(whole) == [(row.name, row.version, row.hashes) for row in locked(WHOLE)]
    assert _rows(run) == [(row.name, row.version, row.hashes) for row in locked(RUN)]
    required = {one["name"] for one in whole["components"] if one["scope"] == "required"}
    assert required == {one["name"] for one in run["components"]} == {row.name for row in locked(RUN)}


def test_each_package_that_runs_here_names_its_licence() -> None:
    silent = [one["name"] for one in bill(run_only=True)["components"] if "licenses" not in one]
    elsewhere = {row.name for row in locked(RUN) if "win32" in row.marker or "emscripten" in row.marker}
    assert set(silent) <= elsewhere, silent
