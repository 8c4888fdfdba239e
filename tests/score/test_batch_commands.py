"""The batch commands on the published scorer's rows, through the real command line: every row equal."""

from __future__ import annotations

import gzip
import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.shared import SHARED

GOLDEN = SHARED / "golden"
COMMANDS = {
    "repair_f1.jsonl.gz": ("verify", "repair"),
    "physics_support.jsonl.gz": ("verify", "support"),
    "aggregation.jsonl.gz": ("score",),
}


def batch(path: Path, *command: str) -> list[dict[str, Any]]:
    done = subprocess.run(
        [sys.executable, "-m", "c4s.cli", *command, "--batch", str(path)],
        capture_output=True,
        text=True,
        timeout=250,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines()]


@pytest.mark.parametrize("name", COMMANDS)
def test_every_published_row_is_equal(name: str) -> None:
    path = GOLDEN / name
    if not path.is_file():
        pytest.skip(f"no answers of the published scorer at {path}")
    with gzip.open(path, "rt") as lines:
        rows = [json.loads(line) for line in lines]
    answers = batch(path, *COMMANDS[name])
    assert len(answers) == len(rows) > 100
    for row, answer in zip(rows, answers, strict=True):
        assert answer.pop("name") == row["name"]
        if "expected_error" in row:
            assert set(answer) == {"error"} and "\n" not in answer["error"], row["name"]
        else:
            assert answer.get("models", answer) == row["expected"], row["name"]


def test_a_plain_file_and_bad_rows(tmp_path: Path) -> None:
    rows = [
        {"name": "good", "kind": "i2s_case", "input": {"valid": True, "repair_f1": 0.5, "physics_score": 1}},
        {"name": "bad", "kind": "i2s_case", "input": {"valid": True, "repair_f1": 7, "physics_score": 1}},
        {"name": "odd", "kind": "nosuch", "input": {}},
    ]
    plain, zipped = tmp_path / "rows.jsonl", tmp_path / "rows.jsonl.gz"
    plain.write_text("\n".join(json.dumps(row) for row in rows) + "\n")
    with plain.open("rb") as source, gzip.open(zipped, "wb") as out:
        shutil.copyfileobj(source, out)
    answers = batch(plain, "score")
    assert answers == batch(zipped, "score")
    assert answers[0]["score"] == 0.6 and set(answers[1]) == set(answers[2]) == {"name", "error"}
