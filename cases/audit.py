"""What a suite gives away: Repair F1 of guesses that are made without a picture.

Each trick of the baseline ``blind`` is tried on each repair, alone (its likeliest guesses, and all of them at once) and
together with all others. The best any of these ways reaches over the suite must stay near nothing: a case that can be
repaired without looking at it measures nothing.
"""

from __future__ import annotations

import copy
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c4s.agents.baselines.blind import Guess, SeenActor, SeenLevel, chosen, guesses
from c4s.editor.identity import ID_TAG, ORIGIN_TAG
from c4s.errors import BadInput
from c4s.files import read_json
from c4s.protocol.settings import is_construction
from c4s.records.level import Level, LevelActor, Transform
from c4s.records.pack import MANIFEST, Pack
from c4s.records.suite import SuiteFolder, WithheldFolder
from c4s.verify.repair import repair_verdict
from cases.boxes import Boxes, boxes_of, world_box
from cases.corruption import STATIC_MESH_ACTOR, id_of

MOST_F1 = 0.03
"""Mean over a suite's repairs that the best blind way may reach."""
TOGETHER = "all tricks together"


@dataclass(frozen=True)
class CaseAudit:
    """Repair F1 of each blind way on one repair; 0 for a way that guesses nothing."""

    case_id: str
    f1: Mapping[str, float]

    @property
    def best(self) -> tuple[str, float]:
        """The best way and its F1; of nothing when none changes anything."""
        way = max(self.f1, key=lambda name: self.f1[name], default="")
        return way, self.f1.get(way, 0.0)


def audit(suite: SuiteFolder, packs_root: Path) -> Iterator[CaseAudit]:
    """Try every blind way on every repair of a built suite, in the suite's order."""
    boxes: dict[str, Boxes] = {}
    for case in suite.suite().cases:
        if is_construction(case.setting):
            continue
        agent = suite.agent_case(case.alias)
        for pack in agent.packs:
            if pack.pack_id not in boxes:
                boxes[pack.pack_id] = boxes_of(Pack.read(packs_root / pack.pack_id / MANIFEST).assets)
        known = {path: box for pack in agent.packs for path, box in boxes[pack.pack_id].items()}
        start = Level.read(suite.agent(case.alias) / "start.level.json")
        withheld = WithheldFolder(suite.withheld(case.case_id))
        snapshots = read_json(withheld.input_snapshot), read_json(withheld.truth_snapshot)
        yield audit_repair(case.case_id, start, *snapshots, known)


def audit_repair(
    case_id: str, start: Level, input_snapshot: Mapping[str, Any], truth: Mapping[str, Any], boxes: Boxes
) -> CaseAudit:
    """Try every blind way on one repair: its start level, and the snapshots of that and of the original."""
    scene = seen(start, boxes)
    actors = {actor.name: actor for actor in start.actors}
    changed = _changed(input_snapshot, truth)
    scores: dict[tuple[Guess, ...], float] = {}
    f1: dict[str, float] = {}
    for way, made in _ways(scene):
        key = tuple(made)
        if not any(guess.actor in changed or guess.edit == "copy" or guess.location for guess in made):
            scores[key] = 0.0
        elif key not in scores:
            candidate = _guessed(input_snapshot, made, actors, boxes)
            scores[key] = float(repair_verdict(input_snapshot, truth, candidate).score or 0.0)
        f1[way] = scores[key]
    return CaseAudit(case_id, f1)


def mean_f1(rows: Sequence[CaseAudit]) -> dict[str, float]:
    """Mean Repair F1 of each way over all repairs, the best first; 0 where a way changes nothing."""
    sums: dict[str, float] = defaultdict(float)
    for row in rows:
        for way, value in row.f1.items():
            sums[way] += value
    return {way: total / len(rows) for way, total in sorted(sums.items(), key=lambda item: -item[1])}


def check_blind(rows: Sequence[CaseAudit]) -> None:
    """``BadInput`` where the best blind way is above ``MOST_F1``, with the cases that it repairs."""
    for way, value in mean_f1(rows).items():
        if value > MOST_F1:
            given = ", ".join(f"{row.case_id} {row.f1[way]:.2f}" for row in rows if row.f1.get(way))
            raise BadInput(
                f"{way!r} reaches a mean Repair F1 of {value:.3f} without a look at a picture; "
                f"at most {MOST_F1} is allowed",
                where=given,
                todo="change other actors in these cases (another --seed), or have more that is alike (docs/cheats.md)",
            )


def seen(level: Level, boxes: Boxes) -> SeenLevel:
    """A level as agent code can read it: its actors that show a single static mesh."""
    things = [
        _thing(actor, order, boxes)
        for order, actor in enumerate(level.actors)
        if actor.class_path == STATIC_MESH_ACTOR and len(actor.components) == 1 and actor.components[0].static_mesh
    ]
    return SeenLevel(level.package, tuple(things))


def _thing(actor: LevelActor, order: int, boxes: Boxes) -> SeenActor:
    component = actor.components[0]
    low, high = world_box(actor, actor.transform, boxes)
    place = actor.transform
    flags = (str(actor.hidden), str(component.collision_enabled), str(sorted(component.properties)))
    return SeenActor(
        name=actor.name,
        label=actor.label,
        guid=actor.guid,
        stable_id=id_of(actor) or "",
        class_path=actor.class_path,
        mesh=component.static_mesh or "",
        component=(component.name, component.class_path, *flags, str(sorted(actor.properties))),
        materials=tuple(sorted(component.materials.items())),
        tags=frozenset(tag for tag in actor.tags if not tag.startswith((ID_TAG, ORIGIN_TAG))),
        folder=actor.folder,
        location=place.location_cm,
        rotation=place.rotation_deg,
        scale=place.scale,
        low=(low[0], low[1], low[2]),
        high=(high[0], high[1], high[2]),
        order=order,
    )


def _ways(scene: SeenLevel) -> Iterator[tuple[str, list[Guess]]]:
    """Names of ways and the guesses that each makes."""
    together = guesses(scene)
    for name, made in together.items():
        yield name, chosen(made)
        yield f"{name}, every guess", _one_each(made)
    yield TOGETHER, chosen([guess for made in together.values() for guess in made])


def _changed(start: Mapping[str, Any], truth: Mapping[str, Any]) -> set[str]:
    """Names of the start scene's actors that are not as in the truth: nothing else can be repaired where it stands."""
    same = ("asset_path", "transform", "component_material_slots")
    wanted = {record["stable_actor_id"]: [record[name] for name in same] for record in truth["actors"]}
    return {
        record["name"]
        for record in start["actors"]
        if wanted.get(record["stable_actor_id"]) != [record[name] for name in same]
    }


def _one_each(made: Sequence[Guess]) -> list[Guess]:
    """The likeliest guess of each actor."""
    best: dict[str, Guess] = {}
    for guess in sorted(made, key=lambda guess: -guess.chance):
        best.setdefault(guess.actor, guess)
    return list(best.values())


def _guessed(
    snapshot: Mapping[str, Any], made: Sequence[Guess], actors: Mapping[str, LevelActor], boxes: Boxes
) -> dict[str, Any]:
    """The start scene's snapshot as it would be exported after the guesses were made."""
    records = {record["name"]: record for record in snapshot["actors"]}
    by_mesh = {record["asset_path"]: record for record in snapshot["actors"]}
    for guess in made:
        record = copy.deepcopy(records[guess.actor])
        place = _place(record["transform"], guess)
        mesh = guess.mesh or record["asset_path"]
        if guess.edit == "delete":
            del records[guess.actor]
            continue
        if guess.edit == "mesh" and mesh in by_mesh:
            names = ("asset_path", "component_asset_paths", "material_paths", "component_material_slots")
            record |= {name: by_mesh[mesh][name] for name in names}
        record["transform"] = place.model_dump(mode="json")
        record["bounds"] = _bounds(actors[guess.actor], mesh, place, boxes) or record["bounds"]
        if guess.edit == "copy":
            name = f"{guess.actor}_copy"
            records[name] = record | {"name": name, "label": name, "actor_guid": "0" * 32, "stable_actor_id": name}
        else:
            records[guess.actor] = record
    return dict(snapshot) | {"actors": list(records.values()), "actor_count": len(records)}


def _place(now: Mapping[str, Any], guess: Guess) -> Transform:
    return Transform(
        location_cm=guess.location or tuple(now["location_cm"]),
        rotation_deg=guess.rotation or tuple(now["rotation_deg"]),
        scale=guess.scale or tuple(now["scale"]),
    )


def _bounds(actor: LevelActor, mesh: str, place: Transform, boxes: Boxes) -> dict[str, Any] | None:
    shown = actor.model_copy(update={"components": [actor.components[0].model_copy(update={"static_mesh": mesh})]})
    low, high = world_box(shown, place, boxes)
    if not (low <= high).all():
        return None
    return {"origin_cm": ((low + high) / 2).tolist(), "extent_cm": ((high - low) / 2).tolist()}
