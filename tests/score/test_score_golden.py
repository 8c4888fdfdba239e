"""Every aggregation row of the published scorer: all kinds, all fields."""

from __future__ import annotations

import gzip
import json
from typing import Any

import pytest

from c4s.protocol.physics import physics_from_report
from c4s.score.batch import KINDS, score_batch
from tests.shared import SHARED

GOLDEN = SHARED / "golden"


def published(name: str) -> list[dict[str, Any]]:
    path = GOLDEN / name
    if not path.is_file():
        pytest.skip(f"no answers of the published scorer at {path}")
    with gzip.open(path, "rt") as lines:
        return [json.loads(line) for line in lines]


def test_batch_gives_every_expected_value_and_refusal() -> None:
    rows = published("aggregation.jsonl.gz")
    assert {row["kind"] for row in rows} == set(KINDS)
    for row, answer in zip(rows, score_batch(rows), strict=True):
        assert answer.pop("name") == row["name"]
        if "expected_error" in row:
            assert set(answer) == {"error"} and "\n" not in answer["error"], row["name"]
        else:
            assert answer.get("models", answer) == row["expected"], row["name"]


def test_text_to_scene_physics_with_the_recomputed_support_rate() -> None:
    rows = [row for row in published("physics_support.jsonl.gz") if "expected_t2s_physics" in row]
    assert rows
    for row in rows:
        answer = physics_from_report(row["report"], row["expected"]["rate"])
        del answer["policy"]
        assert answer == row["expected_t2s_physics"], row["name"]
