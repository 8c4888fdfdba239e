"""The work of Repair F1 grows with the actors, loading included: no step looks at every pair of them."""

from __future__ import annotations

import json
from pathlib import Path

from bench.repair_scene import scenes
from c4s.records.verdict import Verdict
from c4s.verify.repair import verify_repair
from tests.work import calls_in, peak_bytes_of


class Repair:
    """A scene of so many actors with 40 edits, as files."""

    def __init__(self, folder: Path, actors: int) -> None:
        self.paths = []
        for name, value in scenes(actors, 40).items():
            self.paths.append(folder / f"{name}-{actors}.json")
            self.paths[-1].write_text(json.dumps(value))

    def __call__(self) -> Verdict:
        return verify_repair(*self.paths)


def test_6700_actors_with_40_edits(tmp_path: Path) -> None:
    small, large = Repair(tmp_path, 1675), Repair(tmp_path, 6700)
    assert small().population["targets"] == large().population["targets"] == 40
    few, many = calls_in(small).total(), calls_in(large).total()
    assert many < 75 * 6700 and many - few < 50 * (6700 - 1675)
    assert peak_bytes_of(large) < 15_000 * 6700
