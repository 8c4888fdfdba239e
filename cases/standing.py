"""What stands and fits in a scene: which of its actors have no fault of support and of penetration of their own."""

from __future__ import annotations

import copy
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from c4s.engine import DEFAULT_ENGINE
from c4s.evidence import export_level
from c4s.files import read_json
from c4s.packs.store import PackStore
from c4s.records.folder import EvidenceFolder
from c4s.records.level import Level
from c4s.verify.physics.verdict import verify_physics

ASIDE_CM = 1e7


def snapshot_of(level: Level, packs: Sequence[Path]) -> dict[str, Any]:
    """The level as a clean engine exports it; ``MachineryFault`` when it cannot."""
    with tempfile.TemporaryDirectory(prefix="c4s-scene-") as folder:
        document, out = Path(folder) / "scene.level.json", EvidenceFolder(Path(folder)).snapshot
        level.write(document)
        export_level(engine=DEFAULT_ENGINE, packs=packs, level=document, out=out)
        snapshot: dict[str, Any] = read_json(out)
    return snapshot


def unsound(snapshot: dict[str, Any]) -> set[str]:
    """Names and labels of actors that float, cannot be told to stand, or sink into others, were each of them edited.

    What stands is told by the bodies near an actor.
    """
    return _faulty(snapshot, ("near_bodies",))


def losing(snapshot: dict[str, Any], store: PackStore | None = None) -> set[str]:
    """Those that would lose points if they were edited: also what the published rule of support calls floating.

    With the packs of the scene that rule looks at triangles, as a trial's does; else at collision bodies.
    """
    return _faulty(snapshot, ("floating", "near_bodies"), store)


def _faulty(snapshot: dict[str, Any], tellers: Sequence[str], store: PackStore | None = None) -> set[str]:
    measured = _alone(snapshot, store)
    leaves = {leaf["leaf_id"]: leaf for leaf in (*measured["leaf_results"], *measured["diagnostic_leaves"])}
    return {
        *(
            name
            for leaf in tellers
            for state in ("floating_actors", "unresolved_actors")
            for name in leaves[leaf][state]
        ),
        *(row["actor"] for row in leaves["solid_penetration"]["actors"] if row["state"] != "clean"),
    }


def unscored(snapshot: dict[str, Any]) -> set[str]:
    """Names and labels of actors that physics does not score: a repair of these alone has no physics to win."""
    return {name for name, role in _alone(snapshot)["roles"].items() if role != "scored_solid"}


def _alone(snapshot: dict[str, Any], store: PackStore | None = None) -> dict[str, Any]:
    """What physics measures of each actor as if it alone were edited."""
    aside = copy.deepcopy(snapshot)
    for actor in aside["actors"]:
        actor["transform"]["location_cm"][0] += ASIDE_CM
    measured: dict[str, Any] = verify_physics(
        "image-to-scene/indoor", snapshot, aside, meshes=None if store is None else store.recorded_mesh, alone=True
    ).measurements
    return measured


def settled(authored: Level, disturbed: Level, export: Callable[[Level], dict[str, Any]]) -> Level:
    """The disturbed level, with those actors as they were authored that neither stand nor fit as they are now.

    ``export`` gives the snapshot of a level.
    """
    was = {actor.name: actor for actor in authored.actors}
    touched = {actor.name for actor in disturbed.actors if actor != was[actor.name]}
    level = disturbed
    while touched:
        bad = unsound(export(level)) & touched
        if not bad:
            break
        touched -= bad
        kept = [was[actor.name] if actor.name in bad else actor for actor in level.actors]
        level = level.model_copy(update={"actors": kept})
    return level
