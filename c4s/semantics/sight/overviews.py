"""The four overview views (paper, Overview Alignment: a scene-graph and clearance-aware camera plan).

Cameras around the whole content are looked through first. Where walls, roofs or ceilings hide objects from all of them,
or objects are small in all of them, cameras around these are added: they stand nearer, or inside, in the room. Of all,
four are chosen one after the other by how much more of the objects they show; the first always shows the whole.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from c4s.evidence.shots import Glimpse, Probe, Shots
from c4s.protocol.rules import OVERVIEW_VIEWS
from c4s.records.captures import OVERVIEW
from c4s.semantics.inventory import Array, Thing, inventory, landscapes
from c4s.semantics.sight.candidates import Eye, angle_deg, around, directions, outside
from c4s.semantics.sight.clearance import corners_of
from c4s.semantics.sight.scene import SightScene
from c4s.semantics.views import SEEN_SHARE

SIZE_PX = (960, 540)
"""Of an overview picture."""
PROBE_PX = (192, 108)
INNER_PROBE_PX = (128, 72)
CLEAR_SHARE = 4e-4
"""An object counts wholly from this share of a view's pixels on (207 of 960 x 540), by the square root below it."""
WEAK, WEAK_WEIGHT = 0.5, 0.05
"""Where more than this share of the objects, by weight, is shown less clearly than that by all views of the whole,
cameras go nearer, and inside."""
CLOSED_WEIGHT = 0.5
"""A scene of which more than this is hidden from outside is closed, and looked at from outside once."""
WHOLE_VIEWS = 2
"""Of an open scene that has to be looked into."""
APART_DEG = 30.0
APART_CM = 300.0
"""Two overview views differ by at least this angle; nearer ones look at places at least this far apart."""
_OUTER = directions(8, (22.0, 42.0, 68.0))
_INNER = directions(8, (12.0, 28.0, 50.0))
_PLACES, _EYES_OF_A_PLACE = 6, 5
"""Groups of weakly shown objects that are looked into, and how many eyes a group is looked at through."""
_GRID = 4
_LEAST_PLACE_CM = 300.0
_TIE = 1e-3


@dataclass(frozen=True)
class Candidate:
    """An eye with what it would see."""

    eye: Eye
    shares: Array
    """Share of the picture's pixels of each weighed actor."""
    worth: Array
    """How clearly it shows each of them, 0 to 1."""
    inner: bool
    glimpse: Glimpse


def overview_plan(snapshot: Mapping[str, Any], probe: Probe) -> Shots:
    """The four overview cameras of a snapshot, as ``c4s.evidence`` takes a plan."""
    things = inventory(snapshot, {})
    chosen = choose_overview(SightScene.of(things, landscapes(snapshot)), things, probe)
    return Shots(overview_cameras([candidate.eye for candidate in chosen]))


def overview_cameras(eyes: Sequence[Eye]) -> list[dict[str, Any]]:
    """The cameras ``overview-1`` and on of eyes."""
    return [{**eye.camera(f"overview-{n}", *SIZE_PX), "purpose": OVERVIEW} for n, eye in enumerate(eyes, 1)]


def choose_overview(scene: SightScene, things: Sequence[Thing], probe: Probe) -> list[Candidate]:
    """The four views, the first of the whole content."""
    weights = _weights(scene, things)
    names = list(weights)
    weight = np.array([weights[name] for name in names])
    points = scene.framed()
    eyes = around(points, _OUTER, scene.boxes, scene.content, scene.ground_cm)
    eyes = eyes or outside(points, _OUTER, scene.boxes)
    outer = _looked(eyes, PROBE_PX, names, probe, inner=False)
    chosen = _greedy(outer, outer, weight, OVERVIEW_VIEWS)
    weak = np.max([candidate.worth for candidate in chosen], axis=0) < WEAK
    if weight[weak].sum() <= WEAK_WEIGHT * weight.sum():
        return chosen
    wanted = {name for name, is_weak in zip(names, weak.tolist(), strict=True) if is_weak}
    inner = _looked(_eyes_inside(scene, wanted, weights), INNER_PROBE_PX, names, probe, inner=True)
    unseen = np.max([candidate.shares for candidate in chosen], axis=0) < SEEN_SHARE
    closed = weight[unseen].sum() >= CLOSED_WEIGHT * weight.sum()
    return _greedy(outer, [*outer, *inner], weight, 1 if closed else WHOLE_VIEWS)


def _weights(scene: SightScene, things: Sequence[Thing]) -> dict[str, float]:
    """The actors that count, and how much: those of an asset together as the square root of their number."""
    asset = {things[row].actor: things[row].kind.asset for row in np.flatnonzero(scene.objects).tolist()}
    number = Counter(asset.values())
    return {actor: number[asset[actor]] ** -0.5 for actor in sorted(asset)}


def _looked(
    eyes: Sequence[Eye], size: tuple[int, int], names: Sequence[str], probe: Probe, *, inner: bool
) -> list[Candidate]:
    seen = probe([eye.camera(f"probe-{number}", *size) for number, eye in enumerate(eyes)])
    found = []
    for eye, glimpse in zip(eyes, seen, strict=True):
        visible = glimpse["visible"]
        shares = np.array([visible.get(name, 0) for name in names], dtype=float) / (size[0] * size[1])
        open_ = 1.0 - min(1.0, 2.0 * glimpse["near_share"])
        found.append(Candidate(eye, shares, open_ * np.sqrt(np.minimum(shares / CLEAR_SHARE, 1.0)), inner, glimpse))
    return found


def _greedy(whole: Sequence[Candidate], all_: Sequence[Candidate], weight: Array, first: int) -> list[Candidate]:
    """Four candidates that show most together, each next adding most: the first so many are of the whole."""
    chosen: list[Candidate] = []
    shown = np.zeros(len(weight))
    while len(chosen) < OVERVIEW_VIEWS:
        pool = all_ if len(chosen) >= first else whole
        far = [candidate for candidate in pool if all(_differ(candidate, other) for other in chosen)]
        pool = far or [candidate for candidate in pool if not any(candidate is other for other in chosen)] or pool
        gains = [
            float(weight @ np.maximum(candidate.worth - shown, 0.0))
            + _TIE * weight.sum() * float(weight @ candidate.worth) / max(weight.sum(), 1e-9)
            + _TIE * min([angle_deg(candidate.eye, other.eye) / 180 for other in chosen], default=0.0)
            for candidate in pool
        ]
        best = pool[int(np.argmax(np.round(gains, 9)))]
        chosen.append(best)
        shown = np.maximum(shown, best.worth)
    return chosen


def _differ(one: Candidate, other: Candidate) -> bool:
    if one is other:
        return False
    if one.inner and other.inner:
        return bool(np.linalg.norm(np.subtract(one.eye.target, other.eye.target)) >= APART_CM)
    return one.inner != other.inner or angle_deg(one.eye, other.eye) >= APART_DEG


def _eyes_inside(scene: SightScene, wanted: set[str], weights: Mapping[str, float]) -> list[Eye]:
    """Eyes around the places where most of what is wanted lies."""
    rows = np.array([row for row in np.flatnonzero(scene.objects).tolist() if scene.actors[row] in wanted])
    centre = scene.boxes.centre[rows]
    cell = max(float(np.ptp(centre[:, :2], axis=0).max()) / _GRID, _LEAST_PLACE_CM)
    keys = np.floor((centre - centre.min(axis=0)) / cell).astype(np.int64)
    groups: dict[tuple[int, ...], list[int]] = {}
    for row, key in zip(rows.tolist(), map(tuple, keys.tolist()), strict=True):
        groups.setdefault(key, []).append(row)
    heaviest = sorted(groups.items(), key=lambda group: (-sum(weights[scene.actors[r]] for r in group[1]), group[0]))
    eyes = []
    for key, members in heaviest[:_PLACES]:
        own = np.zeros(len(scene.boxes), dtype=bool)
        own[members] = True
        close = scene.boxes.take(own).corners()
        wide = centre.min(axis=0) + cell * corners_of(np.array(key), np.array(key) + 1.0)
        wide[:, 2] = np.clip(wide[:, 2], close[:, 2].min(), close[:, 2].max())
        for points in (close, np.concatenate([close, wide])):
            eyes += around(points, _INNER, scene.boxes, own, scene.ground_cm, _EYES_OF_A_PLACE)
    return eyes
