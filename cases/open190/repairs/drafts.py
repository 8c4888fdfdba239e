"""A draft of a repair: drawn changes of what a view shows, for a wanted group, chain and tier."""

from __future__ import annotations

import math
import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from c4s.geometry.transform import affine, look_at
from c4s.records.level import Vector
from cases.corruption import Author, Corruption
from cases.model import CaseView, Group, RepairCase
from cases.open190.repairs.changes import Changeable, Inside, joined
from cases.open190.repairs.lookouts import Lookout, second
from cases.open190.repairs.plan import WantedRepair
from cases.recipe import Kind, Operation, SpawnActor

KINDS: Final[Mapping[Group, Sequence[Sequence[Kind]]]] = {
    "Restore": (("removal",), ("removal",), ("removal", "move"), ("removal", "rotate"), ("removal",)),
    "Lifecycle": (
        ("insertion", "duplication", "replacement"),
        ("replacement", "duplication", "insertion"),
        ("duplication", "insertion", "removal"),
        ("replacement", "insertion"),
        ("insertion", "duplication"),
    ),
    "Layout": (("move",), ("move",), ("move", "rotate"), ("move",), ("move",)),
    "Symmetry": (
        ("mirror", "rotate", "move"),
        ("rotate", "mirror", "move"),
        ("move", "rotate", "mirror"),
        ("rotate", "removal"),
        ("move",),
    ),
    "Transform": (
        ("rotate", "rescale"),
        ("rescale", "rotate"),
        ("rotate", "rescale"),
        ("rescale", "move"),
        ("rotate",),
    ),
}
"""What each label of a chain may be, by the case's group; one of them is drawn, the others are for where it fails."""
TOGETHER: Final = {"easy": 0.0, "medium": 0.2, "hard": 0.4}
"""How often an entry changes several things of a set, by tier."""
MOST_TOGETHER = 3
ASKED = 12
"""So many things are asked for a change of a kind before another kind, or another view, is."""
TITLES: Final[Mapping[Group, str]] = {
    "Restore": "Bring back what is missing",
    "Lifecycle": "Undo what was added or exchanged",
    "Layout": "Put things back in their places",
    "Symmetry": "Mend a pattern",
    "Transform": "Turn and size things as they were",
}
SHOWN: Final[Mapping[Kind, int]] = {"rotate": 2400, "rescale": 1500, "mirror": 2400, "replacement": 1500}
"""Pixels of 1280 x 720 that a thing has at least of which only a part will look different."""
INSIDE = 0.86
"""A thing that is moved or added has its middle within this share of the picture, from the middle out."""


@dataclass(frozen=True)
class RepairDraft:
    """A repair before it was looked at."""

    case: RepairCase
    targets: tuple[str, ...]
    """Names of what is changed, or of what something is put beside."""
    related: int
    """How many of them stand in a relation to others."""


def draft(
    wanted: WantedRepair, scene: Changeable, pool: Sequence[Lookout], first: Lookout, chance: random.Random
) -> RepairDraft | None:
    """Draw a repair before a view; None where its things allow none.

    Args:
        wanted: what it is to be.
        scene: the original.
        pool: all views of it.
        first: the view that is to show what is changed.
        chance: where all is drawn from.
    """
    pattern = wanted.group == "Symmetry"
    left = [name for name in first.pixels if name in scene.things]
    views = [first]
    if wanted.environment == "indoor":
        other = second(first, pool, left, chance)
        if other is None:
            return None
        views.append(other)
        left = [name for name in left if name in other.pixels]
    chance.shuffle(left)
    author, taken, changes, names = scene.author(), set[str](), list[Corruption](), list[str]()
    looks = _Looks()
    inside = seen_from(first.view)
    for place in range(wanted.chain):
        kinds = list(KINDS[wanted.group][place])
        chance.shuffle(kinds)
        for kind in kinds:
            ready = [name for name in left if name not in taken and looks.allow(kind, scene.things[name].mesh)]
            ready = [name for name in ready if first.pixels[name] >= SHOWN.get(kind, 0)]
            if pattern and kind in ("move", "rotate", "removal"):
                ready = [name for name in ready if name in scene.mates or name in scene.alike]
            made = _entry(kind, ready, scene, author, chance, inside, TOGETHER[wanted.tier], set(left) - taken)
            if made is not None:
                change, changed = made
                taken |= {*changed}
                names += changed
                changes.append(change)
                looks.note(change, scene)
                break
        else:
            return None
    case = RepairCase(
        wanted.case_id,
        wanted.scene_id,
        TITLES[wanted.group],
        tuple(changes),
        wanted.group,
        wanted.tier,
        tuple(replace(one.view, name=f"view-{number:02d}") for number, one in enumerate(views, 1)),
        "image-to-scene/indoor" if wanted.environment == "indoor" else "image-to-scene/outdoor",
        visibility=wanted.visibility,
    )
    return RepairDraft(case, tuple(names), sum(name in scene.related for name in names))


def _entry(
    kind: Kind,
    ready: Sequence[str],
    scene: Changeable,
    author: Author,
    chance: random.Random,
    inside: Inside,
    together: float,
    seen: set[str],
) -> tuple[Corruption, list[str]] | None:
    """An entry of a chain and whom it changes: one thing, or some that were put together."""
    for name in ready[:ASKED]:
        change = scene.change(kind, name, author, chance, inside)
        if change is None:
            continue
        changes, names = [change], [name]
        if kind in ("removal", "move", "rotate") and chance.random() < together:
            for mate in scene.mates.get(name, ()):
                if mate in seen and len(names) < MOST_TOGETHER:
                    more = scene.change(kind, mate, author, chance, inside)
                    if more is not None:
                        changes.append(more)
                        names.append(mate)
        return joined(kind, changes), names
    return None


class _Looks:
    """Keeps a case from removing and adding things of one look, which the published rule would confuse."""

    def __init__(self) -> None:
        self.gone: set[str] = set()
        self.new: set[str] = set()

    def allow(self, kind: Kind, mesh: str) -> bool:
        """Whether a thing of a mesh may be changed so."""
        if kind == "removal":
            return mesh not in self.new
        return kind != "duplication" or mesh not in self.gone

    def note(self, change: Corruption, scene: Changeable) -> None:
        """Remember a change."""
        for operation in change.operations:
            if isinstance(operation, SpawnActor):
                self.new |= {*operation.source.values()}
        if change.kind == "removal":
            for operation in change.operations:
                self.gone |= {_mesh_of(operation, scene)}


def _mesh_of(operation: Operation, scene: Changeable) -> str:
    target = getattr(operation, "target", "")
    return next((thing.mesh for name, thing in scene.things.items() if scene.ids[name] == target), "")


def seen_from(view: CaseView) -> Inside:
    """A test of whether a place lies well within a view's picture; what stands before it is not asked."""
    turn = affine((0, 0, 0), look_at(view.location_cm, view.target_cm), (1, 1, 1))[:3, :3]
    wide = math.tan(math.radians(view.fov_deg) / 2)
    high = wide * view.height / view.width

    def inside(place: Vector) -> bool:
        ahead, right, up = (np.asarray(place) - view.location_cm) @ turn
        if ahead < 60:
            return False
        return bool(abs(right) < INSIDE * wide * ahead and abs(up) < INSIDE * high * ahead)

    return inside
