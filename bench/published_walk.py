"""``python -m bench.published_walk SCRIPT TRIAL``: the published probe in the headless engine, beside ours.

SCRIPT is the benchmark's own ``measure_reachability.py``, run as it is: it finds its output path and its options as
globals, as in an editor. TRIAL is the folder of a trial (``runs/RUN/AGENT/CASE/r1``) that saved a scene. A level
without a navigation mesh has nothing to probe, here as in Unreal, so our editor probe builds one first and answers too.

Printed is one JSON object: the probe's status and counts, ours by the editor probe's mesh and by the walkable space,
and how single actors fall. The probe has other rules (no own storey, no band of the floor, surfaces are targets), so
actors differ by them. Exit 1 unless it ends in ``success``.
"""

from __future__ import annotations

import argparse
import importlib
import json
import shutil
import sys
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any, cast

from c4s.cli.levels import packs_of
from c4s.engine import Engine
from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.world.documents import references
from c4s.evidence.walk import probe_navigation
from c4s.files import read_json
from c4s.navigation import approachable, measure_snapshot
from c4s.records.folder import TrialFolder
from c4s.records.level import Level
from c4s.records.navigation import LETTERS, NavigationEvidence


class InsideEditor:
    """Calls the editor's scripts in this process, as an engine does."""

    def call(self, function: str, /, *, timeout_s: float = 600.0, **given: Any) -> Any:
        """What a function of ``c4s.editor`` answers."""
        module, name = function.split(".")
        return getattr(importlib.import_module(f"c4s.editor.{module}"), name)(**given)


def probed(script: Path, trial: TrialFolder) -> tuple[NavigationEvidence, dict[str, Any]]:
    """What our editor probe finds in the scene that a trial saved, and what the script then writes of it."""
    with tempfile.TemporaryDirectory() as place:
        content, out = Path(place) / "content", Path(place) / "reachability.json"
        shutil.copytree(trial.attempts()[-1].submission, content)
        level = Level.read(next(content.rglob("*.level.json")))
        boot(packs_of(list(references(level))), content, start_map=level.package)
        ours = probe_navigation(cast(Engine, InsideEditor()), read_json(trial.evidence.snapshot))
        options = json.dumps({"settle_wait_s": 0.1})
        given = {"SCENE_REACHABILITY_OUTPUT": str(out), "SCENE_REACHABILITY_OPTIONS_JSON": options}
        exec(compile(script.read_text(), script.name, "exec"), {"__name__": "__main__", **given})
        return ours, read_json(out)


def told(evidence: NavigationEvidence) -> dict[str, Any]:
    """Counts of a measurement of ours."""
    falls = [LETTERS[letter] for letter in evidence.builds[-1].falls]
    return {"pool": len(falls), "A": approachable(falls), "falls": Counter(falls), "cells": evidence.builds[-1].cells}


def compared(script: Path, trial: TrialFolder) -> dict[str, Any]:
    """Both, and where they agree."""
    engine, theirs = probed(script, trial)
    ours = measure_snapshot(read_json(trial.evidence.snapshot))
    pool = [target for target in ours.targets if not target.left]
    falls = {target.name: LETTERS[letter] for target, letter in zip(pool, ours.builds[-1].falls, strict=True)}
    actors = {path.rpartition(".")[2]: row for path, row in theirs["actors"].items() if row["eligible"]}
    both = sorted(actors.keys() & falls.keys())
    pairs = Counter(f"published {actors[name]['connected']}, ours {falls[name]}" for name in both)
    counts = theirs["diagnostics"]
    return {
        "status": counts["status"],
        "settled": theirs["navmesh"]["settle"]["settled"],
        "settings_after_rebuild": theirs["navmesh"]["parameters_after_rebuild"],
        "published": {
            "eligible": counts["eligible_actor_count"],
            "projected": counts["projected_actor_count"],
            "connected": counts["connected_actor_count"],
            "components": theirs["components"]["sizes"][:5],
        },
        "editor_probe": told(engine),
        "walkable_space": told(ours),
        "both_judge": len(both),
        "pairs": pairs,
    }


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("script", type=Path)
    parser.add_argument("trial", type=Path)
    chosen = parser.parse_args()
    report = compared(chosen.script, TrialFolder(chosen.trial))
    print(json.dumps(report, indent=1))
    sys.exit(report["status"] != "success")
