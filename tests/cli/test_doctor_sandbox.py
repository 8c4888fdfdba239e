"""``c4s doctor`` tells which sandbox engines get, by the same rule as the engine."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from c4s.cli.main import app
from c4s.engine.confine import sandbox


@pytest.mark.parametrize(
    ("choice", "missing", "found", "told"),
    [
        ("", "", True, "bubblewrap confines engine processes; landlock would let agent code ask"),
        ("", "bubblewrap", True, "landlock confines engine processes; bubblewrap does not work here: broken"),
        ("landlock", "", True, "landlock confines engine processes; asked for by C4S_SANDBOX; bubblewrap would hide"),
        ("bubblewrap", "bubblewrap", False, "no sandbox for the engine, so it will not start: bubblewrap: broken"),
        ("none", "", True, "C4S_SANDBOX=none: nothing confines agent code"),
        ("wishful", "", False, "no sandbox is called 'wishful'"),
    ],
)
def test_the_sandbox_in_use_is_told(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, choice: str, missing: str, found: bool, told: str
) -> None:
    faults = {"bubblewrap": None, "landlock": None} | ({missing: "broken"} if missing else {})
    monkeypatch.setattr(sandbox, "faults", lambda: faults)
    monkeypatch.setattr("c4s.cli.doctor.faults", lambda: faults)
    monkeypatch.setenv("C4S_SANDBOX", choice)
    monkeypatch.setenv("C4S_HOME", str(tmp_path))
    answer = CliRunner().invoke(app, ["doctor", "--json"])
    row = next(row for row in json.loads(answer.stdout) if row["what"] == "sandbox")
    assert row["found"] is found and told in row["text"], row
    assert answer.exit_code == (0 if found else 1) or not found
