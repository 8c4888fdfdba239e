"""Which actors a body should be able to walk up to: the target pool and its footprints (paper, EU07 to EU12).

Categories and labels are words of whoever built the scene, so words alone make nothing a surface: it must lie flat.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Final, Literal

import numpy as np

from c4s.collision.mesh_body import Array, triple
from c4s.collision.scene import SceneBodies
from c4s.protocol.words import tokens, word_set

Left = Literal["no_collision", "kind", "effect", "surface", ""]
"""Why an actor is no target; empty for one that is."""

KINDS: Final = word_set("""
    light camera fog atmosphere volume capture brush note trigger emitter niagara particle sky settings start
    landscape decal group navmesh""")
"""Words in the class of actors that are no content: lights, fog, captures, sky, cameras, bookkeeping."""
EFFECTS: Final = word_set("navmesh reflection postprocess atmosphere sky particles particle niagara emitter vfx fx")
"""Words in the names of actors that stand for an effect."""
SURFACES: Final = word_set("""
    floor flooring ground road street sidewalk pavement paving plaza path footpath walkway lawn grass terrain landscape
    baseplate cobblestone cobble flagstone paver slab tile parquet plank boardwalk crossing crosswalk lane parking
    asphalt gravel dirt soil mud sand snow turf meadow field carpet rug water river lake sea ocean pond""")
"""Words for what one walks on, or over."""
FLAT: Final = 0.25
LEAST_SPAN_CM: Final = 100.0
"""A surface spans at least this much both ways, and is at most this share of it high; else its name nearly misses."""
_DIGITS = re.compile(r"\d+")


@dataclass(frozen=True)
class WalkTarget:
    """An actor, and where it stands."""

    index: int
    """In the snapshot."""
    name: str
    label: str
    left: Left
    low: Array
    high: Array
    """World box (cm) of what collides of it; its pivot where that is not known."""
    hidden: bool = False
    named_out: bool = False
    """Whether a name, not its class or shape, makes it no target."""

    @property
    def base_cm(self) -> float:
        """How high it begins."""
        return float(self.low[2])


def targets_of(snapshot: Mapping[str, Any], scene: SceneBodies) -> list[WalkTarget]:
    """Every actor of a snapshot as a target or none, in scene order."""
    boxes: dict[int, tuple[Array, Array]] = {}
    for owner, body in zip(scene.owners, scene.bodies, strict=True):
        low, high = boxes.get(owner, (body.low, body.high))
        boxes[owner] = np.minimum(low, body.low), np.maximum(high, body.high)
    return [
        _target(index, actor, boxes.get(index), index in scene.unresolved)
        for index, actor in enumerate(snapshot.get("actors") or [])
    ]


def _target(index: int, actor: Mapping[str, Any], box: tuple[Array, Array] | None, unresolved: bool) -> WalkTarget:
    own = actor.get("c4s")
    low, high = box or (_pivot(actor),) * 2
    left = _left(actor, box, unresolved)
    return WalkTarget(
        index=index,
        name=str(actor.get("name") or index),
        label=str(actor.get("label") or ""),
        left=left,
        low=low,
        high=high,
        hidden=isinstance(own, Mapping) and own.get("hidden") is True,
        named_out=left == "effect" or (left == "surface" and not _is_broad(low, high)),
    )


def _left(actor: Mapping[str, Any], box: tuple[Array, Array] | None, unresolved: bool) -> Left:
    if not KINDS.isdisjoint(_tokens(_leaf(actor.get("class")))):
        return "kind"
    if box is None and not unresolved:
        return "no_collision"
    names = [actor.get("label"), _leaf(actor.get("asset_path")), actor.get("semantic_category")]
    names += [actor.get("asset_category"), *map(_leaf, _many(actor, "component_asset_paths"))]
    told = {word for name in names if name for word in _tokens(str(name))}
    if not EFFECTS.isdisjoint(told):
        return "effect"
    return "surface" if box is not None and not SURFACES.isdisjoint(told) and _is_flat(*box) else ""


@lru_cache(maxsize=1 << 14)
def _tokens(name: str) -> tuple[str, ...]:
    return tokens(_DIGITS.sub(" ", name))


def _leaf(path: Any) -> str:
    return str(path or "").replace("\\", "/").rpartition("/")[2].rpartition(".")[2]


def _many(actor: Mapping[str, Any], field: str) -> Iterable[Any]:
    found = actor.get(field)
    return found if isinstance(found, list) else []


def _is_flat(low: Array, high: Array) -> bool:
    span = high - low
    return bool(span[:2].min() >= LEAST_SPAN_CM and span[2] <= FLAT * span[:2].min())


def _is_broad(low: Array, high: Array) -> bool:
    """Whether its shape alone tells a surface: wider than nearly all furniture is."""
    return bool((high - low)[:2].min() >= 2 * LEAST_SPAN_CM)


def _pivot(actor: Mapping[str, Any]) -> Array:
    transform = actor.get("transform")
    try:
        return np.array(triple(transform.get("location_cm") if isinstance(transform, Mapping) else None))
    except ValueError:
        return np.zeros(3)


def pool(targets: Sequence[WalkTarget]) -> list[WalkTarget]:
    """Those that a body should be able to walk up to, before the floor-level band."""
    return [target for target in targets if not target.left]
