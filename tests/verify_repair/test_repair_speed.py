"""Repair F1 stays fast on the largest scenes, loading included."""

from __future__ import annotations

import json
import time
from pathlib import Path

from bench.repair_scene import scenes
from c4s.verify.repair import verify_repair


def test_6700_actors_with_40_edits(tmp_path: Path) -> None:
    paths = {}
    for name, value in scenes(6700, 40).items():
        paths[name] = tmp_path / f"{name}.json"
        paths[name].write_text(json.dumps(value))
    began = time.process_time()
    loaded = [json.loads(path.read_bytes()) for path in paths.values()]
    parse_s = time.process_time() - began
    assert len(loaded) == 3
    best = float("inf")
    for _ in range(3):
        began = time.process_time()
        verdict = verify_repair(paths["input"], paths["truth"], paths["candidate"])
        best = min(best, time.process_time() - began)
    assert verdict.population["targets"] == 40
    assert best < max(0.5, 2.5 * parse_s), f"{best:.2f} s; parsing alone with json takes {parse_s:.2f} s"
