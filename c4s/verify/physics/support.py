"""Support: which actors stand on something.

Text-to-scene uses the published box rule (scorer facts 3): an actor is supported when its bottom is at most 5 cm above
the world's ground plane z = 0, or when another evaluated actor's top lies 0 to 5 cm below its bottom and that actor's
plan box, widened by a quarter of the upper actor's own plan size, holds its pivot. Excluded actors support nothing.

Image-to-scene follows the published probe (``c4s.verify.physics.edited_support``). Here is the measure beside it that
has no weight: an edited actor is held when a collision body of any other actor lies within 5 cm straight below its
own, or within 5 cm sideways (paper, Physical Safety, read without the probe's shapes and groups).
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import shapely

from c4s.bounds import BOUNDS
from c4s.collision.contacts import CHUNK, MOST_HITS, MOST_PAIRS, DepthMeter
from c4s.collision.depth import BodyTable
from c4s.collision.scene import SceneBodies
from c4s.collision.shapes import Array, Body, box_body
from c4s.protocol.rules import GAP_CM, TINY_CM
from c4s.verify.actors.measured import measured_vector

EXCLUDED_CLASSES = frozenset(
    {
        "directionallight",
        "skylight",
        "skyatmosphere",
        "exponentialheightfog",
        "worldsettings",
        "playerstart",
        "cameraactor",
        "reflectioncapture",
        "brush",
        "navmeshboundingvolume",
        "postprocessvolume",
    }
)
EXCLUDED_PREFIXES = (
    "floor",
    "sky",
    "light",
    "atmo",
    "fog",
    "post",
    "sphere",
    "world",
    "brush",
    "default",
    "player",
    "gamemode",
    "nav",
    "levelbounds",
    "landscape",
    "volume",
    "note",
    "camera",
    "directional",
    "exponential",
    "exprunner",
    "arena_env",
    "ground_plane",
)

State = Literal["excluded", "supported", "floating"]
EditedState = Literal["supported", "floating", "unresolved"]


@dataclass(frozen=True)
class Support:
    """Outcome of the text-to-scene rule: one state an actor, in scene order."""

    per_actor: list[State]
    labels: list[Any]
    gaps_cm: list[float | None]
    """How far each supported actor is above what supports it: the ground plane (negative under it), else the nearest
    top that does; None for the others."""

    @property
    def evaluated(self) -> int:
        """Number of actors that were tested."""
        return sum(state != "excluded" for state in self.per_actor)

    @property
    def floating(self) -> int:
        """Number of tested actors without support."""
        return self.per_actor.count("floating")

    @property
    def floating_labels(self) -> list[Any]:
        """Labels of the floating actors, in scene order."""
        return [label for label, state in zip(self.labels, self.per_actor, strict=True) if state == "floating"]

    @property
    def rate(self) -> float | None:
        """Share of tested actors that float, rounded to 4 places; None when none was tested."""
        return round(self.floating / self.evaluated, 4) if self.evaluated else None


def _excluded_by_class(actor: Mapping[str, Any]) -> bool:
    kind = actor.get("class", "")
    return isinstance(kind, str) and kind.rsplit(".", 1)[-1].lower() in EXCLUDED_CLASSES


def excluded_by_label(actor: Mapping[str, Any]) -> bool:
    """Infrastructure by the start of its label, although its class is none."""
    label = str(actor.get("label", actor.get("name"))).lower()
    return label.startswith(EXCLUDED_PREFIXES) and not _excluded_by_class(actor)


def excluded_by_name(actor: Mapping[str, Any]) -> bool:
    """Infrastructure by class name (exact) or by the start of the label."""
    return _excluded_by_class(actor) or excluded_by_label(actor)


def text_to_scene_support(snapshot: Mapping[str, Any]) -> Support:
    """The text-to-scene rule on a snapshot.

    Raises ``ValueError`` for a snapshot without actor records, and for an actor that is not excluded by its names and
    lacks usable bounds or transform.
    """
    found = snapshot.get("actors")
    if not isinstance(found, list) or not all(isinstance(actor, Mapping) for actor in found):
        raise ValueError("the scene has no list of actors")
    actors: list[Mapping[str, Any]] = found
    states: list[State] = ["excluded"] * len(actors)
    evaluated: list[int] = []
    rows: list[tuple[float, ...]] = []
    for index, actor in enumerate(actors):
        if not isinstance(actor.get("class", ""), str):
            raise ValueError(f"actor {index}: the class is no text")
        if excluded_by_name(actor):
            continue
        try:
            origin = measured_vector(actor.get("bounds"), "origin_cm")
            extent = measured_vector(actor.get("bounds"), "extent_cm")
            pivot = measured_vector(actor.get("transform"), "location_cm")
        except ValueError as error:
            raise ValueError(f"actor {index} ({actor.get('label', actor.get('name'))}): {error}") from None
        if all(half < TINY_CM for half in extent):
            continue
        evaluated.append(index)
        rows.append((*origin, *extent, *pivot))
    table = np.array(rows, dtype=float).reshape(-1, 9)
    gaps: list[float | None] = [None] * len(actors)
    for index, gap in zip(evaluated, _gaps(table), strict=True):
        states[index], gaps[index] = "floating" if gap is None else "supported", gap
    return Support(states, [actor.get("label", actor.get("name")) for actor in actors], gaps)


def _gaps(table: Array) -> list[float | None]:
    """Gap in cm of each row (origin, half extent, pivot) to the ground plane or another row; None: it floats."""
    bottom, top = table[:, 2] - table[:, 5], table[:, 2] + table[:, 5]
    half = np.maximum(table[:, 3:5], TINY_CM)
    order = np.argsort(top, kind="stable")
    tops = top[order]
    gaps: list[float | None] = [height if height <= GAP_CM else None for height in bottom.tolist()]
    for i in np.flatnonzero(bottom > GAP_CM).tolist():
        slack = 1e-9 * (abs(bottom[i]) + GAP_CM)
        first = np.searchsorted(tops, bottom[i] - GAP_CM - slack)
        near = order[first : np.searchsorted(tops, bottom[i] + slack, side="right")]
        gap = bottom[i] - top[near]
        reach = np.abs(table[near, :2] - table[i, 6:8]) < 0.5 * half[i] + half[near]
        holds = (gap >= 0) & (gap <= GAP_CM) & reach.all(axis=1) & (near != i)
        gaps[i] = float(gap[holds].min()) if holds.any() else None
    return gaps


DIRECTIONS = np.array([(0, 0, -1)] + [(math.cos(a), math.sin(a), 0) for a in np.arange(8) * math.pi / 4])
"""Straight down, then eight sideways directions."""
TOUCH_CM = 1e-3
"""The step goes this far beyond the inclusive gap: rounding of flush faces is nothing."""
OVERLAP_CM = TOUCH_CM / 2
"""Two bodies meet where they overlap by more than this."""


def held_by_bodies(
    scene: SceneBodies,
    edited: Sequence[int],
    solid: Collection[int],
    unknown_boxes: Sequence[tuple[Array, Array]],
    boxes: Mapping[int, tuple[Array, Array]],
) -> dict[int, EditedState]:
    """Which edited actors (indices) collision bodies hold.

    Args:
        scene: the bodies of the candidate scene.
        edited: the actors to test.
        solid: the actors that can give support.
        unknown_boxes: world boxes (low, high in cm) of solid actors whose bodies are not known: near one of them a
            missing support proves nothing.
        boxes: world boxes (low, high) of the edited actors: the stand-in for one whose meshes have no collision body.

    Raises ``BadInput`` for a scene so crowded that it is beyond ``box_pairs`` or ``measured_pairs``.
    """
    own: dict[int, list[Body]] = {}
    holders = [i for i, owner in enumerate(scene.owners) if owner in solid]
    for body, owner in zip(scene.bodies, scene.owners, strict=True):
        own.setdefault(owner, []).append(body)
    bodies, owners = [scene.bodies[i] for i in holders], [scene.owners[i] for i in holders]
    tree = shapely.STRtree([shapely.box(*body.low[:2], *body.high[:2]) for body in bodies])
    tested = {
        index: own.get(index) or ([box_body(*boxes[index])] if index in boxes else [])
        for index in edited
        if index not in scene.unresolved
    }
    effort = _Effort()
    standing = _standing_on(tested, bodies, owners, tree, effort)
    meter = DepthMeter()
    states: dict[int, EditedState] = {}
    for index in edited:
        mine = tested.get(index)
        if not mine:
            states[index] = "unresolved"
        elif index in standing or any(_held(body, bodies, owners, index, tree, meter, effort) for body in mine):
            states[index] = "supported"
        else:
            blocked = any(
                bool(np.all(body.low - GAP_CM <= high) and np.all(body.high + GAP_CM >= low))
                for body in mine
                for low, high in unknown_boxes
            )
            states[index] = "unresolved" if blocked else "floating"
    return states


class _Effort:
    """How much was looked at, held to the bounds of a scene."""

    def __init__(self) -> None:
        self._boxes = self._pairs = 0

    def boxes(self, count: int) -> None:
        """So many more bodies with boxes above or below one."""
        self._boxes += count
        BOUNDS["box_pairs"].hold(self._boxes, where="support")

    def pairs(self, count: int) -> None:
        """So many more pairs to measure."""
        self._pairs += count
        BOUNDS["measured_pairs"].hold(self._pairs, where="support")


def _standing_on(
    tested: Mapping[int, Sequence[Body]],
    others: Sequence[Body],
    owners: Sequence[int],
    tree: shapely.STRtree,
    effort: _Effort,
) -> set[int]:
    """Actors with a body that overlaps another actor's after the whole way down: nearly all of a sound scene."""
    down = DIRECTIONS[0] * (GAP_CM + TOUCH_CM)
    moved = [(index, body.moved(down)) for index, bodies in tested.items() for body in bodies]
    table = BodyTable([body for _, body in moved] + list(others))
    mine = np.array([index for index, _ in moved], dtype=np.int64)
    theirs, count = np.array(owners, dtype=np.int64), len(moved)
    held: set[int] = set()
    chunk = max(1, min(CHUNK, MOST_HITS // max(len(others), 1)))
    for start in range(0, count, chunk):
        part = np.arange(start, min(start + chunk, count))
        hit, j = tree.query(shapely.box(*table.low[part, :2].T, *table.high[part, :2].T))
        effort.boxes(len(hit))
        i = part[hit]
        keep = mine[i] != theirs[j]
        i, j = i[keep], j[keep] + count
        push_out = np.minimum(table.high[i] - table.low[j], table.high[j] - table.low[i]).min(axis=1)
        keep = push_out > OVERLAP_CM
        i, j, push_out = i[keep], j[keep], push_out[keep]
        for first in range(0, len(i), MOST_PAIRS):
            some = slice(first, first + MOST_PAIRS)
            open_pairs = ~np.isin(mine[i[some]], np.fromiter(held, np.int64, len(held)))
            a, b = i[some][open_pairs], j[some][open_pairs]
            effort.pairs(len(a))
            depth, _ = table.depths(a, b, push_out[some][open_pairs], OVERLAP_CM)
            held.update(mine[a[depth > 0]].tolist())
    return held


def _held(
    body: Body,
    others: Sequence[Body],
    owners: Sequence[int],
    owner: int,
    tree: shapely.STRtree,
    meter: DepthMeter,
    effort: _Effort,
) -> bool:
    """Whether a body meets a body of another actor on a way of 5 cm down or sideways."""
    margin = GAP_CM + TOUCH_CM
    plan = shapely.box(*(body.low[:2] - margin), *(body.high[:2] + margin))
    near = [others[i] for i in tree.query(plan).tolist() if owners[i] != owner]
    effort.boxes(len(near))
    if not near:
        return False
    ways = DIRECTIONS * margin
    low, high = body.low + np.minimum(ways, 0.0), body.high + np.maximum(ways, 0.0)
    push_out = np.minimum(
        high - np.array([other.low for other in near])[:, None], np.array([other.high for other in near])[:, None] - low
    ).min(axis=2)
    for other, way in np.argwhere(push_out > OVERLAP_CM).tolist():
        effort.pairs(1)
        if _meets(body, near[other], ways[way], meter):
            return True
    return False


def _meets(body: Body, other: Body, way: Array, meter: DepthMeter) -> bool:
    """Whether a body overlaps another one somewhere on a straight way, however thin both are.

    The signed distance of two convex bodies is a convex function of the way gone. Its slope at any place is the share
    of the normal in the way, so each place without an overlap rules out all that lies on its uphill side.
    """
    first, last = 0.0, 1.0
    place = last
    shortest = TOUCH_CM / 4 / float(np.linalg.norm(way))
    while last - first > shortest:
        moved = body.moved(place * way)
        distance, normal = meter.signed(moved, other)
        if distance < -OVERLAP_CM and meter(moved, other)[0] > OVERLAP_CM:
            return True
        slope = -float(normal @ way)
        missing = max(distance, -OVERLAP_CM) + OVERLAP_CM
        if slope < 0:
            first = max(first, place - missing / slope, place)
        elif slope > 0:
            last = min(last, place - missing / slope, place)
        else:
            return False
        place = (first + last) / 2
    return False
