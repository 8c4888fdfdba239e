"""Held-out cameras of a repair: they see what was changed, from other sides than the agent's reference pictures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from c4s.evidence.shots import Camera, Probe
from c4s.semantics.boxes import Flags
from c4s.semantics.inventory import Array, Thing
from c4s.semantics.sight.candidates import Eye, around, directions, outside
from c4s.semantics.sight.clearance import Solids
from c4s.semantics.sight.looks import Sighting, choose, qualities
from c4s.semantics.sight.needs import Need
from c4s.semantics.sight.scene import SightScene

SIZE_PX = (960, 540)
PROBE_PX = (128, 72)
MOST_VIEWS = 4
HELD_OUT_DEG = 25.0
"""A held-out camera looks at the targets from a direction at least this far from every reference camera's."""
TOGETHER_CM = 500.0
"""Targets whose middles are linked by steps of at most this are looked at together."""
_PAD_CM = 60.0
"""Around a target, so that its surroundings tell where it stands."""
_WAYS = directions(12, (14.0, 30.0, 52.0), 15.0)
_EYES = 16


@dataclass(frozen=True)
class Target:
    """Something that was changed: its box in the original or in the corrupted scene."""

    low: tuple[float, float, float]
    high: tuple[float, float, float]


def target_cameras(
    things: Sequence[Thing], targets: Sequence[Target], references: Sequence[Camera], probe: Probe
) -> list[dict[str, Any]]:
    """Two to four cameras ``target-1`` and on that see the targets in the original; none where there is no target.

    Args:
        things: of the original scene.
        targets: what was changed; in no order.
        references: the agent's cameras (``location_cm``).
        probe: of the original scene.
    """
    if not targets or not things:
        return []
    scene = SightScene.of(things)
    low, high = (np.array([getattr(target, side) for target in targets]) for side in ("low", "high"))
    rows = _nearest(scene, (low + high) / 2)
    needs, looks, centres = [], [], []
    for members in _groups((low + high) / 2):
        frame = Solids(low[members] - _PAD_CM, high[members] + _PAD_CM)
        own = np.zeros(len(scene.boxes), dtype=bool)
        own[rows[members]] = True
        needs.append(Need("sides", sorted(set(rows[members].tolist()))))
        centres.append(frame.corners().mean(axis=0))
        looks += _looked(_held_out(frame, scene, own, references), probe)
    centre = np.array(centres)
    quality = qualities(looks, needs, things)
    choice = choose(looks, quality, centre, [0] * len(needs), MOST_VIEWS)
    return [looks[number].eye.camera(f"target-{place}", *SIZE_PX) for place, number in enumerate(choice.taken, 1)]


def _nearest(scene: SightScene, centres: Array) -> Any:
    """For each target the thing of the original whose middle is nearest: itself, where it is there."""
    ways = np.linalg.norm(scene.boxes.centre[None] - centres[:, None], axis=2)
    return np.argmin(np.round(ways, 3), axis=1)


def _groups(centres: Array) -> list[Any]:
    """Rows of targets that stand together, those with most first; at most as many groups as there are views."""
    if len(centres) == 1:
        return [np.array([0])]
    from scipy.cluster.hierarchy import fcluster, linkage

    labels = fcluster(linkage(centres, "single"), TOGETHER_CM, "distance")
    groups = [np.flatnonzero(labels == label) for label in np.unique(labels)]
    return sorted(groups, key=lambda rows: (-len(rows), int(rows[0])))[:MOST_VIEWS]


def _held_out(frame: Solids, scene: SightScene, own: Flags, references: Sequence[Camera]) -> list[Eye]:
    """Eyes around the frame that look from other directions than the references; all, where none does."""
    points = frame.corners()
    found = around(points, _WAYS, scene.boxes, own, scene.ground_cm) or outside(points, _WAYS, scene.boxes)
    centre = points.mean(axis=0)

    def aside(eye: Eye) -> float:
        ways = centre - np.array([camera["location_cm"] for camera in references], dtype=float).reshape(-1, 3)
        ways /= np.maximum(np.linalg.norm(ways, axis=1, keepdims=True), 1e-9)
        own_way = centre - np.array(eye.place)
        own_way /= max(float(np.linalg.norm(own_way)), 1e-9)
        return float(np.degrees(np.arccos(np.clip(ways @ own_way, -1.0, 1.0))).min(initial=180.0))

    apart = [eye for eye in found if aside(eye) >= HELD_OUT_DEG]
    return (apart or found)[:_EYES]


def _looked(eyes: Sequence[Eye], probe: Probe) -> list[Sighting]:
    seen = probe([eye.camera(f"probe-{number}", *PROBE_PX) for number, eye in enumerate(eyes)])
    return [Sighting(eye, PROBE_PX[0] * PROBE_PX[1], glimpse) for eye, glimpse in zip(eyes, seen, strict=True)]
