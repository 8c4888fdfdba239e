"""The text-to-scene support rule equals every row of the published scorer."""

from __future__ import annotations

import gzip
import json

import pytest

from c4s.verify.physics.batch import support_rows
from tests.shared import SHARED

GOLDEN = SHARED / "golden/physics_support.jsonl.gz"


@pytest.mark.skipif(not GOLDEN.exists(), reason="the golden rows are not on this machine")
def test_every_row_is_equal():
    with gzip.open(GOLDEN, "rt") as lines:
        rows = [json.loads(line) for line in lines]
    assert len(rows) > 100
    for row, found in zip(rows, support_rows(rows), strict=True):
        if "expected_error" in row:
            assert "error" in found, row["name"]
        else:
            assert found == {"name": row["name"], **row["expected"]}, row["name"]
