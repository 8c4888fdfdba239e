"""Why a repair cannot be used although it scores what it should, each with the number that was measured.

Every change must be there to be seen in a reference view, and of a thing (paper, ``app:case-construction-details``:
stable, actor-level, visible enough).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from c4s.protocol.settings import Setting
from c4s.records.level import Level, LevelActor
from c4s.verify.actors.roles import roles, words
from cases.admissible.looked import Looked
from cases.admissible.refusal import Refusal, RefusalKind
from cases.corruption import id_of, meshes
from cases.model import RepairCase
from cases.recipe import Operation, RemoveActor, SetStaticMesh, SetTransform, SpawnActor
from cases.standing import unsound

Snapshot = dict[str, Any]

LEAST_PIXELS = 400
"""Of 1280 x 720 (0.043 %): a target that no view shows with more cannot be told from noise."""
LEAST_DISPLACED, LEAST_CHANGED = 0.12, 0.03
"""Share of a target's pixels that show it only before or after a move; that look different where it stays in place."""
GROUND_SIDE_CM, GROUND_FLAT = 250.0, 0.05
"""What is larger than this both ways, and so much flatter than it is wide, is ground."""
STRUCTURE = frozenset({"ceiling", "floor", "foundation", "ground", "roof", "room", "wall", "walls"})
"""What a thing is called by the last word of its name that is part of a building."""
MOST_SHARE = 0.34
"""Of the scene's width or depth: what is larger is ground, structure or backdrop."""
VIEWS: Mapping[Setting, int] = {"image-to-scene/indoor": 2, "image-to-scene/outdoor": 1}
"""Reference views of a case (paper, benchmark suite)."""
_IN_PLACE = frozenset({"turned", "mirrored", "with another mesh"})


@dataclass(frozen=True)
class TargetSighting:
    """How well a changed actor can be seen, each in the view that shows it best; pixels are of 1280 x 720.

    ``pixels`` show the actor in the original, or in the start scene where it was added; ``changed_share`` of its own
    pixels show what was done to it, None for what is in one of the two scenes alone.
    """

    actor: str
    done: tuple[str, ...]
    pixels: int
    changed_share: float | None
    changed_pixels: int | None


def sight_refusals(
    case: RepairCase,
    operations: Sequence[Operation],
    truth: Level,
    start: Level,
    truth_snapshot: Snapshot,
    start_snapshot: Snapshot,
    seen: Sequence[TargetSighting],
    names: Mapping[str, str],
) -> list[Refusal]:
    """Reasons against a built repair that do not show in its scores.

    Args:
        case: its definition.
        operations: those that made ``start`` of ``truth``.
        truth, start: the levels.
        truth_snapshot, start_snapshot: what a clean engine exported of them.
        seen: how well each changed actor can be seen.
        names: what the author calls the actors of both levels.
    """
    before = {id_of(actor): actor for actor in truth.actors}
    after = {id_of(actor): actor for actor in start.actors}
    fit = _fit(operations, before, after, truth_snapshot, start_snapshot, names)
    hanging = _left_hanging(operations, before, truth_snapshot, start_snapshot, names)
    told: list[tuple[RefusalKind, str]] = [
        *(("views", reason) for reason in _views(case)),
        *(("seen", reason) for sighting in seen for reason in _unseen(sighting)),
        *(("thing", reason) for reason in fit),
        *(("hanging", reason) for reason in hanging),
    ]
    return [Refusal(case.case_id, kind, reason) for kind, reason in told]


def _views(case: RepairCase) -> list[str]:
    wanted = VIEWS[case.setting]
    if len(case.views) == wanted:
        return []
    return [f"it has {len(case.views)} reference views; a case of {case.setting} has {wanted}"]


def sightings(
    operations: Sequence[Operation], truth: Level, start: Level, looks: Sequence[Looked], names: Mapping[str, str]
) -> list[TargetSighting]:
    """How well each changed actor can be seen, in the order of the changes.

    ``looks``: what each reference camera sees; the other arguments are those of ``sight_refusals``.
    """
    before = {id_of(actor): actor for actor in truth.actors}
    after = {id_of(actor): actor for actor in start.actors}
    return [
        _sighting(
            [one for one in operations if _target(one) == target], before.get(target), after.get(target), looks, names
        )
        for target in dict.fromkeys(map(_target, operations))
    ]


def _sighting(
    operations: Sequence[Operation],
    was: LevelActor | None,
    now: LevelActor | None,
    looks: Sequence[Looked],
    names: Mapping[str, str],
) -> TargetSighting:
    if was is None:
        assert now is not None
        pixels = max((look.pixels(now.name, start=True) for look in looks), default=0)
        return TargetSighting(names.get(now.name, now.name), ("added",), pixels, None, None)
    pixels = max((look.pixels(was.name) for look in looks), default=0)
    if now is None:
        return TargetSighting(names.get(was.name, was.name), ("removed",), pixels, None, None)
    done = tuple(dict.fromkeys(_words(one, was) for one in operations))
    told = [_measure(done, look, was.name, now.name) for look in looks]
    share, changed = max(told, default=(0.0, 0))
    return TargetSighting(names.get(was.name, was.name), done, pixels, share, changed)


def _measure(done: Sequence[str], look: Looked, was: str, now: str) -> tuple[float, int]:
    """How much a view shows of what was done: by shape of what is turned or displaced, by colour of all else."""
    if set(done) == {"turned"}:
        return look.reshaped(was, now)
    return look.changed(was, now) if set(done) <= _IN_PLACE else look.displaced(was, now)


def _target(operation: Operation) -> str:
    return operation.stable_id if isinstance(operation, SpawnActor) else operation.target


def _unseen(sighting: TargetSighting) -> list[str]:
    """What keeps a change from being seen."""
    if sighting.pixels < LEAST_PIXELS:
        where = "the start scene" if sighting.done == ("added",) else "the reference views"
        return [
            f"{sighting.actor} has {sighting.pixels} of 1280x720 pixels in {where} at the most; "
            f"{LEAST_PIXELS} are needed"
        ]
    share, changed = sighting.changed_share, sighting.changed_pixels
    if share is None or changed is None:
        return []
    least = LEAST_CHANGED if set(sighting.done) <= _IN_PLACE else LEAST_DISPLACED
    if share < least or changed < LEAST_PIXELS:
        return [
            f"{sighting.actor} {' and '.join(sighting.done)} shows in {share:.1%} of its own pixels "
            f"({changed} of 1280x720) at the most; {least:.0%} and {LEAST_PIXELS} are needed"
        ]
    return []


def _words(operation: Operation, was: LevelActor) -> str:
    match operation:
        case SetStaticMesh():
            return "with another mesh"
        case SetTransform(scale=scale) if scale is not None:
            mirrored = any((a < 0) != (b < 0) for a, b in zip(scale, was.transform.scale, strict=True))
            return "mirrored" if mirrored else "rescaled"
        case SetTransform(rotation_deg=turned) if turned is not None:
            return "turned"
        case SetTransform():
            return "moved"
    return "changed"


def _fit(
    operations: Sequence[Operation],
    before: Mapping[str | None, LevelActor],
    after: Mapping[str | None, LevelActor],
    truth: Snapshot,
    start: Snapshot,
    names: Mapping[str, str],
) -> list[str]:
    """Ground, structure and backdrop are no targets."""
    told = []
    for snapshot, known in ((truth, before), (start, after)):
        actors = [actor for one in operations if (actor := known.get(_target(one))) is not None]
        for name, reasons in unfit(actors, snapshot).items():
            told += [f"{names.get(name, name)} {reason}" for reason in reasons]
    return list(dict.fromkeys(told))


def unfit(actors: Sequence[LevelActor], snapshot: Snapshot) -> dict[str, list[str]]:
    """Why actors of a level are no targets, by name, as its snapshot tells; nothing of those that may be."""
    role = dict(zip((actor["name"] for actor in snapshot["actors"]), roles(snapshot["actors"]), strict=True))
    size = {actor["name"]: actor["bounds"]["extent_cm"] for actor in snapshot["actors"]}
    whole = _whole(snapshot)
    found: dict[str, list[str]] = {}
    for actor in actors:
        if actor.name not in role:
            continue
        told = []
        if role[actor.name] in _NO_TARGET or _called(actor) in STRUCTURE:
            told.append(f"is {_NO_TARGET.get(role[actor.name], 'structure')}, which is no target")
        wide, deep, high = (2 * side for side in size[actor.name])
        if min(wide, deep) > GROUND_SIDE_CM and high < GROUND_FLAT * min(wide, deep):
            told.append(f"is {wide:.0f} x {deep:.0f} x {high:.0f} cm: ground, which is no target")
        share = max(2 * size[actor.name][axis] / whole[axis] for axis in (0, 1))
        if share > MOST_SHARE:
            told.append(f"takes {share:.0%} of the scene's side; at most {MOST_SHARE:.0%} is a thing")
        if told:
            found[actor.name] = told
    return found


_NO_TARGET = {"support_surface": "ground", "environment_proxy": "a backdrop or a structure around the scene"}


def _called(actor: LevelActor) -> str:
    """The last word of the name of an actor's mesh."""
    shown = next(iter(meshes(actor)), actor.label).rpartition(".")[2]
    return next((word for word in reversed(words(shown)) if word.isalpha() and len(word) > 1), "")


def _whole(snapshot: Snapshot) -> list[float]:
    """Width and depth (cm) of all that is shown."""
    boxes = [
        (actor["bounds"]["origin_cm"], actor["bounds"]["extent_cm"])
        for actor in snapshot["actors"]
        if max(actor["bounds"]["extent_cm"]) > 0
    ]
    return [
        max(1.0, max(o[axis] + e[axis] for o, e in boxes) - min(o[axis] - e[axis] for o, e in boxes)) for axis in (0, 1)
    ]


def _left_hanging(
    operations: Sequence[Operation],
    before: Mapping[str | None, LevelActor],
    truth: Snapshot,
    start: Snapshot,
    names: Mapping[str, str],
) -> list[str]:
    """What stood on something that a change took away: an agent that repairs nothing would have to answer for it."""
    taken = [one.target for one in operations if isinstance(one, RemoveActor | SetTransform | SetStaticMesh)]
    if not taken:
        return []
    edited = {before[target].name for target in taken if target in before}
    carried = _standing_near(truth, edited)
    if not carried:
        return []
    fine = carried - unsound(truth)
    hanging = sorted(names.get(name, name) for name in fine & unsound(start) - edited)
    if not hanging:
        return []
    more = f" and {len(hanging) - 3} more" if len(hanging) > 3 else ""
    return [f"{', '.join(hanging[:3])}{more} stand in the original and hang or sink in the start scene"]


def _standing_near(snapshot: Snapshot, supports: set[str]) -> set[str]:
    """Names of actors whose lower side lies at an upper side of one of some actors, over it."""
    boxes = {
        actor["name"]: (actor["bounds"]["origin_cm"], actor["bounds"]["extent_cm"]) for actor in snapshot["actors"]
    }
    found = set()
    for support in supports & set(boxes):
        origin, extent = boxes[support]
        top = origin[2] + extent[2]
        for name, (at, half) in boxes.items():
            over = all(abs(at[axis] - origin[axis]) < half[axis] + extent[axis] for axis in (0, 1))
            if name != support and over and origin[2] - extent[2] + 1 < at[2] - half[2] <= top + 5:
                found.add(name)
    return found
