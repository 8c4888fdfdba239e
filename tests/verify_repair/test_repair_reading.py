"""Snapshot files: the non-finite tokens that exporters write are read, broken files are refused in one line."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest

from c4s.errors import BadInput
from c4s.files import read_json
from c4s.verify.repair.reading import read_snapshots


def test_non_finite_tokens_are_read(tmp_path: Path) -> None:
    path = tmp_path / "a.json"
    path.write_text('{"a": [NaN, Infinity, -Infinity, 1.5], "b": "\\ud800"}')
    values, digests = read_snapshots({"input": path})
    assert math.isnan(values["input"]["a"][0]) and values["input"]["a"][1:] == [math.inf, -math.inf, 1.5]
    assert values["input"]["b"] == "\ud800" and len(digests["input_snapshot"]) == 64


def test_both_parsers_give_the_same_values(tmp_path: Path) -> None:
    value = {"n": [0, -0.0, 1e-300, 1 / 3, 2**53 + 1, -5], "text": "ü\n€", "none": None, "yes": True}
    path = tmp_path / "a.json"
    path.write_text(json.dumps(value))
    fast = read_json(path)
    path.write_text(json.dumps({**value, "x": math.inf}))
    slow = read_json(path)
    assert fast == value and slow == {**value, "x": math.inf}
    assert [type(v) for v in fast["n"]] == [type(v) for v in slow["n"]]


@pytest.mark.parametrize("content", [b"", b'{"a": [1, 2', b"\xff\xfe{", b"nul", b"[" * 100_000])
def test_broken_files_are_one_line(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "a.json"
    path.write_bytes(content)
    for read in (lambda: read_json(path), lambda: read_snapshots({"input": path})):
        with pytest.raises(BadInput) as caught:
            read()
        assert "\n" not in caught.value.line() and str(path) in caught.value.line()
