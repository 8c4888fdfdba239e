"""Every row of the published scorer's answers: counts, scores, and the parts that lead to them."""

from __future__ import annotations

import gzip
import json
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from c4s.errors import BadInput
from c4s.verify.repair import repair, verify_repair
from c4s.verify.repair.batch import repair_batch
from tests.shared import SHARED

GOLDEN = SHARED / "golden" / "repair_f1.jsonl.gz"


@pytest.fixture(scope="module")
def rows() -> list[dict[str, Any]]:
    if not GOLDEN.is_file():
        pytest.skip(f"no answers of the published scorer at {GOLDEN}")
    with gzip.open(GOLDEN, "rt") as lines:
        found = [json.loads(line) for line in lines]
    assert {"expected_error" in row for row in found} == {True, False}
    return found


def test_batch_gives_every_expected_number_and_refusal(rows: list[dict[str, Any]]) -> None:
    for row, answer in zip(rows, repair_batch(rows), strict=True):
        if "expected_error" in row:
            assert set(answer) == {"name", "error"} and "\n" not in answer["error"], row["name"]
        else:
            assert answer == {"name": row["name"], **row["expected"]}


def test_intermediate_results_agree(rows: list[dict[str, Any]]) -> None:
    for row in rows:
        if "expected_error" in row:
            with pytest.raises(BadInput):
                repair(row["input"], row["ground_truth"], row["candidate"])
            continue
        result = repair(row["input"], row["ground_truth"], row["candidate"])
        case, detail = result.case, row["detail"]
        assert [[t.operation, sorted(t.fields)] for t in case.targets] == [
            [operation, sorted(fields)] for operation, fields in detail["targets"]
        ], row["name"]
        assert Counter(pair.method for pair in case.matched.pairs) == detail["methods"], row["name"]
        assert {
            "m": len(result.accepted),
            "d": len(result.removed_targets),
            "C": len(case.pool),
            "o": len(result.losses),
            "repurposed": len(result.repurposed),
            "rebinds": result.rebound,
        } == {key: detail[key] for key in ("m", "d", "C", "o", "repurposed", "rebinds")}, row["name"]


def test_files_give_what_plain_data_gives(rows: list[dict[str, Any]], tmp_path: Path) -> None:
    paths = {name: tmp_path / f"{name}.json" for name in ("input", "ground_truth", "candidate")}
    for row in rows:
        for name, path in paths.items():
            path.write_text(json.dumps(row[name]))
        try:
            verdict = verify_repair(*paths.values())
        except BadInput:
            assert "expected_error" in row, row["name"]
            continue
        assert (verdict.score is None) == ("expected_error" in row), row["name"]
        if verdict.score is not None:
            assert {key: verdict.measurements[key] for key in row["expected"]} == row["expected"], row["name"]
