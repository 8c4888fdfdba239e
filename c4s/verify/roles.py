"""Physics roles of actors (scorer facts 4): who is scored for penetration, and who only limits others.

Words are read from an actor's own names (label, object name, class, last part of its asset paths), never from folders,
and are split at capitals, digits and punctuation.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from c4s.verify.support import measured_vector

Role = Literal["non_solid", "unresolved", "support_surface", "environment_proxy", "scored_solid"]

EFFECT_WORDS = frozenset({"emitter", "fire", "flame", "fxsystem", "niagara", "particle", "particles", "vfx"})
CLASS_WORDS = ("atmosphere", "camera", "fog", "light", "navmesh", "postprocess", "reflection", "sky", "volume")
GROUND_WORDS = frozenset({"ground", "floor", "flooring", "road", "street", "pavement", "sidewalk", "walkway", "path",
                          "plaza", "tile", "tiles", "grass", "lawn", "terrain", "plate"})
TERRAIN_WORDS = frozenset({"terrain", "landscape", "heightfield"})
BACKDROP_WORDS = TERRAIN_WORDS | {"environment", "backdrop", "background", "mountain", "mountains", "horizon", "dome"}
GROUND_SPAN_CM = 200.0
"""A ground surface spans at least this much and is at most this high."""
PROXY_SPAN_CM = 3000.0
PROXY_HUGE_CM = 30_000.0
PROXY_RATIO = 10.0
PROXY_ORIGINS, PROXY_SHARE = 3, 0.05
"""A proxy holds the origins of at least three other solids, and of at least 5 % of them."""

Boxes = NDArray[np.float64]
_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")


def words(text: str) -> set[str]:
    """Lower-case words of a name, split at capitals, digits and punctuation."""
    return {part.lower() for part in _WORD.findall(text)}


def _leaf(path: object) -> str:
    return re.split(r"[./:]", str(path).rstrip("'"))[-1] if path else ""


def own_words(actor: Mapping[str, Any]) -> set[str]:
    """Words of an actor's own names."""
    names = [actor.get("label"), actor.get("name"), _leaf(actor.get("class")), _leaf(actor.get("asset_path"))]
    names += [_leaf(path) for path in actor.get("component_asset_paths") or []]
    return words(" ".join(str(name) for name in names if name))


def _class_names(actor: Mapping[str, Any]) -> list[str]:
    diagnostics = actor.get("export_diagnostics") or {}
    own = actor.get("c4s") or {}
    classes = [actor.get("class"), *(diagnostics.get("component_classes") or []),
               *(component.get("class") for component in own.get("components") or [])]
    return [_leaf(path).lower() for path in classes if path]


def bounds_of(actor: Mapping[str, Any]) -> tuple[Boxes, Boxes] | None:
    """World box of an actor as (origin, half extent) in cm; None when it is not valid."""
    try:
        origin = np.array(measured_vector(actor.get("bounds"), "origin_cm"))
        extent = np.array(measured_vector(actor.get("bounds"), "extent_cm"))
    except ValueError:
        return None
    return (origin, extent) if (extent >= 0).all() else None


def is_non_solid(actor: Mapping[str, Any]) -> bool:
    """Collision off, water, effects, lights, cameras, volumes and groups."""
    if (actor.get("collision") or {}).get("collision_enabled") is False:
        return True
    names, classes = own_words(actor), _class_names(actor)
    return bool("water" in names or names & EFFECT_WORDS or "groupactor" in classes
                or any(word in name for name in classes for word in CLASS_WORDS)
                or any(word in name for name in classes for word in EFFECT_WORDS - {"fire"}))


def is_ground(actor: Mapping[str, Any], extent: Boxes) -> bool:
    """A broad thin ground surface, or a terrain."""
    names = own_words(actor)
    broad = 2 * float(extent[:2].max()) >= GROUND_SPAN_CM and 2 * float(extent[2]) <= GROUND_SPAN_CM
    return bool(names & TERRAIN_WORDS) or (broad and bool(names & GROUND_WORDS))


def _may_be_backdrop(actor: Mapping[str, Any]) -> bool:
    paths = [actor.get("asset_path"), *(actor.get("component_asset_paths") or [])]
    return bool(own_words(actor) & BACKDROP_WORDS) or any(
        str(path).lower().startswith("/engine/basicshapes/") for path in paths if path)


def roles(actors: Sequence[Mapping[str, Any]]) -> list[Role]:
    """The role of every actor of a scene, in scene order."""
    result: list[Role] = ["scored_solid"] * len(actors)
    boxes: dict[int, tuple[Boxes, Boxes]] = {}
    for index, actor in enumerate(actors):
        box = bounds_of(actor)
        if is_non_solid(actor):
            result[index] = "non_solid"
        elif box is None:
            result[index] = "unresolved"
        elif is_ground(actor, box[1]):
            result[index] = "support_surface"
        else:
            boxes[index] = box
    for index in _proxies(actors, boxes):
        result[index] = "environment_proxy"
    return result


def _proxies(actors: Sequence[Mapping[str, Any]], boxes: Mapping[int, tuple[Boxes, Boxes]]) -> Iterable[int]:
    """Solids that are a scene's shell: far larger than the rest, backdrop-like, and around many others."""
    if not boxes:
        return
    origins = np.array([origin for origin, _ in boxes.values()])
    spans = np.array([2 * float(extent.max()) for _, extent in boxes.values()])
    median = float(np.median(spans))
    needed = max(PROXY_ORIGINS, PROXY_SHARE * (len(boxes) - 1))
    for (index, (origin, extent)), span in zip(boxes.items(), spans.tolist(), strict=True):
        if span <= PROXY_SPAN_CM or (span < PROXY_HUGE_CM and span < PROXY_RATIO * median):
            continue
        inside = int((np.abs(origins - origin) <= extent).all(axis=1).sum()) - 1
        if _may_be_backdrop(actors[index]) and inside >= needed:
            yield index
