"""A configuration that names another client for some cases: that one works there, and is on record."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from c4s.records.attempt import AttemptOutcome
from tests.run.conftest import Command, trial_in
from warehouse.database import rows

TEXT, FIRST, SECOND = "text-flat-family", "indoor-flat-01-mirrored-bath", "indoor-flat-02-living-room"
MIXED = f"""\
name: mixed
client: noop
per_case:
  i2s-indoor: {{client: random, options: {{seed: 3}}}}
  {SECOND}: {{client: vandal, model: of-its-own}}
"""


def test_each_case_is_worked_on_by_the_client_that_it_names(c4s: Command, home: Path, tmp_path: Path) -> None:
    (tmp_path / "mixed.yaml").write_text(MIXED)
    done = c4s("run", "small", "-a", str(tmp_path / "mixed.yaml"), "--run-id", "mixed")
    assert done.returncode == 0, done.stderr
    expected = {TEXT: ("noop", None), FIRST: ("random", None), SECOND: ("vandal", "of-its-own")}
    for case, (client, model) in expected.items():
        outcome = AttemptOutcome.read(trial_in(home, "mixed", "mixed", case).attempt(1).outcome)
        assert (outcome.client, outcome.model, outcome.client_version) == (client, model, f"{client} 1")
    stored = rows(home / "warehouse", "SELECT case_id, client, model FROM attempts WHERE configuration = 'mixed'")
    assert {row["case_id"]: (row["client"], row["model"]) for row in stored} == expected
    planned = rows(home / "warehouse", "SELECT case_id, client FROM schedule WHERE configuration = 'mixed'")
    assert {row["case_id"]: row["client"] for row in planned} == {case: told[0] for case, told in expected.items()}
    board = json.loads(c4s("run", "small", "-a", str(tmp_path / "mixed.yaml"), "--run-id", "mixed", "--json").stdout)
    assert board["ran"] == 0 and {row["configuration"] for row in board["leaderboard"]} >= {"mixed"}


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ("indoor-flat-02-livingroom: {client: noop}", f"did you mean '{SECOND}'?"),
        ("i2s: {client: noop}", "unknown case or setting 'i2s'"),
        ("indoor: {client: nobody}", "unknown agent client 'nobody'"),
        ("indoor: {client: api, model: m, options: {endpoint: nowhere}}", "unknown model endpoint"),
        ("indoor: {model: m}", "client"),
        ("[noop]", "per_case"),
    ],
)
def test_what_cannot_be_obeyed_is_one_line(c4s: Command, home: Path, tmp_path: Path, change: str, words: str) -> None:
    (tmp_path / "mixed.yaml").write_text(f"name: other\nclient: noop\nper_case:\n  {change}\n")
    done = c4s("run", "small", "-a", str(tmp_path / "mixed.yaml"), "--run-id", "not-obeyed")
    assert (done.returncode, done.stderr.count("\n")) == (2, 1) and words in done.stderr
    assert not (home / "runs/not-obeyed").exists()
