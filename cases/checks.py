"""What makes a case unusable, found before it is built."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from c4s.errors import BadInput
from c4s.geometry.transform import quat_angle_deg, quat_from_rotator
from c4s.records.level import Level, LevelActor
from cases.corruption import id_of, meshes
from cases.model import RepairCase, SourceScene, SuiteDefinition, TextCase
from cases.recipe import LONGEST_CHAIN, Operation, RemoveActor, SetTransform, SpawnActor

MOVE_CM, TURN_DEG, SCALE_REL = 5.0, 5.0, 0.05
"""A change within these acceptance limits of Repair F1 would count as repaired when nothing is done."""


def check_definition(definition: SuiteDefinition) -> None:
    """``BadInput`` for a suite whose cases do not fit together."""
    for what, names in (
        ("case", [case.case_id for case in definition.cases]),
        ("scene", [scene.scene_id for scene in definition.scenes]),
    ):
        repeated = [name for name, count in Counter(names).items() if count > 1]
        if repeated:
            raise BadInput(f"two cases or scenes have this {what} id", where=repeated[0])
    known = {scene.scene_id: scene for scene in definition.scenes}
    for case in definition.cases:
        if case.scene_id not in known:
            raise BadInput(f"no scene {case.scene_id!r}", where=case.case_id)
        if isinstance(case, TextCase):
            continue
        if len({view.name for view in case.views}) < len(case.views):
            raise BadInput("two views have one name", where=case.case_id)
        if case.setting != f"image-to-scene/{known[case.scene_id].environment}":
            raise BadInput(f"the setting {case.setting} does not fit the scene", where=case.case_id)


def check_scene(scene: SourceScene, assets: set[str]) -> None:
    """``BadInput`` for a scene with a repeated object name or a mesh that no pack holds."""
    repeated = [name for name, count in Counter(actor.name for actor in scene.level.actors).items() if count > 1]
    if repeated:
        raise BadInput(f"two actors are named {repeated[0]!r}", where=scene.scene_id)
    for actor in scene.level.actors:
        for mesh in meshes(actor):
            if mesh not in assets and not mesh.startswith("/Engine/"):
                raise BadInput(f"no pack holds {mesh}", where=f"{scene.scene_id} actor {actor.name}")


def check_repair(case: RepairCase, operations: Sequence[Operation], truth: Level, corrupted: Level) -> None:
    """``BadInput`` for a repair case that a perfect agent could not score fully, or that needs no repair.

    ``operations`` are those that made ``corrupted`` of ``truth``.
    """
    if not operations or not case.views:
        raise BadInput("a repair case needs at least one change and one view", where=case.case_id)
    if len(case.corruptions) > LONGEST_CHAIN:
        raise BadInput(f"a repair case has at most {LONGEST_CHAIN} changes; join some in one", where=case.case_id)
    original = {id_of(actor): actor for actor in truth.actors}
    corrupt = {id_of(actor): actor for actor in corrupted.actors}
    gone = {_look(original[o.target]) for o in operations if isinstance(o, RemoveActor)}
    for operation in operations:
        if isinstance(operation, SpawnActor) and _look(corrupt[operation.stable_id]) in gone:
            raise BadInput(
                "it removes and adds actors of one look: the published rule then takes the extra actor for "
                "the missing one, so a perfect repair cannot reach F1 1",
                where=case.case_id,
            )
        if isinstance(operation, SetTransform) and _same_pose(original[operation.target], corrupt[operation.target]):
            raise BadInput(
                f"the change of {original[operation.target].name} lies within the tolerance of Repair F1",
                where=case.case_id,
            )


def _look(actor: LevelActor) -> tuple[str, tuple[str, ...]]:
    return actor.class_path, tuple(sorted(set(meshes(actor))))


def _same_pose(a: LevelActor, b: LevelActor) -> bool:
    p, q = a.transform, b.transform
    distance = sum((x - y) ** 2 for x, y in zip(p.location_cm, q.location_cm, strict=True)) ** 0.5
    angle = quat_angle_deg(quat_from_rotator(p.rotation_deg), quat_from_rotator(q.rotation_deg))
    stretch = max(abs(x / y - 1) for x, y in zip(p.scale, q.scale, strict=True))
    return distance <= MOVE_CM and angle <= TURN_DEG and stretch <= SCALE_REL
