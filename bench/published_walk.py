"""``python -m bench.published_walk SCRIPT TRIAL``: the published probe in the headless engine, beside ours.

SCRIPT is the benchmark's own ``measure_reachability.py``, run as it is: it finds its output path and its options as
globals, as in an editor. TRIAL is the folder of a trial (``runs/RUN/AGENT/CASE/r1``) that saved a scene. As in Unreal a
level needs a ``NavMeshBoundsVolume``, which brings its ``RecastNavMesh``: one is placed around the scene, and the
mesh's settings are the paper's. Nothing is built before the probe asks. The probe draws its samples within 5 m of half
the height of its bounds, which among houses are roofs, so its option ``navmesh_bounds_cm`` tells it the ground.

Printed is one JSON object: the probe's status and counts, ours, what the navigation verifier says of the probe's
output, how actors fall that both judge, and for each that falls differently the rule that parts them. Exit 1 unless
the probe ends in ``success``, or where a difference has no such rule.
"""

from __future__ import annotations

import argparse
import json
import shutil
import sys
import tempfile
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from c4s.cli.levels import packs_of
from c4s.collision import scene_bodies
from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.world.documents import references
from c4s.files import read_json
from c4s.navigation import NavigationSettings, approachable, measure_snapshot, read_published
from c4s.navigation.solids import navigation_bounds
from c4s.protocol.navigation import REACH_CM, SAMPLES
from c4s.records.folder import TrialFolder
from c4s.records.level import Level
from c4s.records.navigation import LETTERS, NavigationEvidence, PlaceRecord
from c4s.verify.navigation.verdict import verify_navigation

PARTED = {
    "corner": "the point lies within a metre along each axis, but not within a metre around",
    "lattice": "the point lies within a metre, but no point of the 25 cm lattice does",
    "height": "the point lies more than a metre above or below, but on the own storey",
    "scenery": "the point lies on another storey",
    "place": "the point lies on other ground: of another sample, or nearer but not on the own storey",
}
"""Rules by which the same mesh and footprint give another answer."""


def probed(script: Path, trial: TrialFolder, ours: NavigationEvidence) -> dict[str, Any]:
    """What the script writes of the scene that a trial saved; ``ours`` tells its ground."""
    with tempfile.TemporaryDirectory() as place:
        content, out = Path(place) / "content", Path(place) / "reachability.json"
        shutil.copytree(trial.attempts()[-1].submission, content)
        level = Level.read(next(content.rglob("*.level.json")))
        unreal = boot(packs_of(list(references(level))), content, start_map=level.package)
        bounded(unreal, read_json(trial.evidence.snapshot))
        options: dict[str, Any] = {"settle_wait_s": 0.1}
        if ours.bounds_cm is not None:
            corners = zip(("min_cm", "max_cm"), ours.bounds_cm, strict=True)
            options["navmesh_bounds_cm"] = {name: [*corner[:2], ours.ground_cm] for name, corner in corners}
        given = {"SCENE_REACHABILITY_OUTPUT": str(out), "SCENE_REACHABILITY_OPTIONS_JSON": json.dumps(options)}
        exec(compile(script.read_text(), script.name, "exec"), {"__name__": "__main__", **given})
        found: dict[str, Any] = read_json(out)
        return found


def bounded(unreal: Any, snapshot: Mapping[str, Any]) -> None:
    """Place the volume around a scene, and give the mesh that it brings the paper's settings."""
    actors, settings = unreal.get_editor_subsystem(unreal.EditorActorSubsystem), NavigationSettings()
    bounds = navigation_bounds(scene_bodies(snapshot))
    if bounds is None:
        return
    low, high = bounds[0], bounds[1] + [0, 0, settings.height_cm]
    volume = actors.spawn_actor_from_class(unreal.NavMeshBoundsVolume, unreal.Vector(*map(float, (low + high) / 2)))
    _, extent = volume.get_actor_bounds(False)
    half = (high - low) / 2
    volume.set_actor_scale3d(unreal.Vector(half[0] / extent.x, half[1] / extent.y, half[2] / extent.z))
    for actor in actors.get_all_level_actors():
        if isinstance(actor, unreal.RecastNavMesh):
            for name, value in settings.properties().items():
                actor.set_editor_property(name, value)


def parted(row: Mapping[str, Any], box: Mapping[str, Any], fall: str, place: PlaceRecord | None) -> str:
    """The rule by which an actor falls differently; empty for none."""
    if row["projected_point_cm"] is None:
        return "scenery" if fall in ("raised", "buried") else "height"
    low, high = (np.array(box["origin_cm"]) + sign * np.array(box["extent_cm"]) for sign in (-1, 1))
    sample = (low + high)[:2] / 2 + np.array(SAMPLES[row["projection_offset_index"]]) * (high - low)[:2] / 2
    away = float(np.linalg.norm(np.array(row["projected_point_cm"])[:2] - sample))
    if fall == "unreached":
        return "corner" if away > REACH_CM else "lattice"
    if place is None:
        return "scenery"
    apart = float(np.linalg.norm(np.array(row["projected_point_cm"]) - place.point_cm))
    return "place" if place.sample != row["projection_offset_index"] or apart > REACH_CM / 2 else ""


def compared(script: Path, trial: TrialFolder) -> dict[str, Any]:
    """Both, and where they agree."""
    snapshot = read_json(trial.evidence.snapshot)
    ours = measure_snapshot(snapshot)
    theirs = probed(script, trial, ours)
    pool = [target for target in ours.targets if not target.left]
    falls = {target.name: LETTERS[letter] for target, letter in zip(pool, ours.builds[-1].falls, strict=True)}
    places = dict(zip(falls, ours.places, strict=True))
    boxes = {actor["name"]: actor["bounds"] for actor in snapshot["actors"]}
    actors = {path.rpartition(".")[2]: row for path, row in theirs["actors"].items() if row["eligible"]}
    both = sorted(actors.keys() & falls.keys())
    word = {True: "connected", False: "unconnected", None: "unreached"}
    other = [name for name in both if word[actors[name]["connected"]] != falls[name]]
    rules = Counter(parted(actors[name], boxes[name], falls[name], places[name]) for name in other)
    counts, read = theirs["diagnostics"], verify_navigation(read_published(theirs, snapshot), snapshot)
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
        "ours": {"pool": len(falls), "A": approachable(list(falls.values())), "falls": Counter(falls.values())},
        "read_as_evidence": {
            "status": read.status,
            "reason": read.reason,
            "A": read.measurements["approachability"],
            "falls": read.measurements["targets"],
        },
        "both_judge": len(both),
        "alike": len(both) - len(other),
        "parted_by": {PARTED.get(rule, "unexplained"): count for rule, count in rules.items()},
    }


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("script", type=Path)
    parser.add_argument("trial", type=Path)
    chosen = parser.parse_args()
    report = compared(chosen.script, TrialFolder(chosen.trial))
    print(json.dumps(report, indent=1))
    sys.exit(report["status"] != "success" or "unexplained" in report["parted_by"])
