"""Physics roles of actors (scorer facts 4): who is scored for penetration, and who only limits others.

An actor is told by names: its label, class, tags and the last parts of its asset paths; folders count only where a
rule says so. Words are split at capitals and punctuation. What a name says must agree with the size.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from c4s.protocol.rules import GROUND_SPAN_CM, PROXY_HUGE_CM, PROXY_ORIGINS, PROXY_RATIO, PROXY_SHARE, PROXY_SPAN_CM
from c4s.verify.actors.measured import measured_vector

Role = Literal["non_solid", "unresolved", "support_surface", "environment_proxy", "scored_solid"]

EFFECT_WORDS = frozenset({"emitter", "fire", "flame", "fxsystem", "niagara", "particle", "particles", "vfx"})
"""As a whole word in any of an actor's strings, folders and materials included."""
CLASS_WORDS = EFFECT_WORDS | {
    "atmosphere",
    "camera",
    "fog",
    "light",
    "navmesh",
    "postprocess",
    "reflection",
    "sky",
    "volume",
}
"""As a whole word in the class of an actor or of one of its components."""
GROUND_WORDS = frozenset(
    {
        "baseplate",
        "cobblestone",
        "floor",
        "ground",
        "landscape",
        "pavement",
        "plaza",
        "road",
        "sidewalk",
        "street",
        "terrain",
    }
)
WATER = re.compile(r"(?<![a-z])(?:water(?:body|surface|plane)?\d*|ocean|sea|lake|river|canal|pond|pool)(?![a-z])", re.I)
ROUGH = re.compile(
    r"(?<![a-z0-9])(?:landscape|terrain|mountain|cliff|cave|island|bedrock|rockface|rock_?formation)"
    r"(?![a-z0-9])",
    re.I,
)
"""Ground whose box says nothing about its surface: a support surface of any shape."""
BACKDROP = re.compile(
    r"(?<![a-z0-9])(?:background|bedrock|cliff|hill|landscape|mountain|rockface|rock_?formation"
    r"|terrain)(?![a-z0-9])",
    re.I,
)
BASIC_SHAPE = re.compile(r"(?:^|/)engine/basicshapes/(?:cone|cube|cylinder|plane|sphere)(?:[./]|$)", re.I)

Boxes = NDArray[np.float64]
_HUMP = re.compile(r"([a-z0-9])([A-Z])")


@lru_cache(maxsize=1 << 16)
def words(text: str) -> tuple[str, ...]:
    """Lower-case words of a name, split at capitals and punctuation; digits stay with their word."""
    return tuple(re.findall(r"[a-z0-9]+", _HUMP.sub(r"\1 \2", text).lower()))


def _variants(texts: Iterable[str]) -> set[str]:
    """Words of names, also without their digits: ``Floor01`` is a floor."""
    return {part for text in texts for word in words(text) for part in (word, *re.findall(r"[a-z]+", word))}


def _texts(values: Iterable[Any]) -> list[str]:
    return [str(value) for value in values if value is not None]


def _leaf(path: Any) -> str | None:
    return None if path is None else str(path).replace("\\", "/").rpartition("/")[2]


def _many(actor: Mapping[str, Any], field: str) -> list[Any]:
    found = actor.get(field)
    return found if isinstance(found, list) else []


def _component_classes(actor: Mapping[str, Any]) -> list[Any]:
    diagnostics = actor.get("export_diagnostics")
    return _many(diagnostics, "component_classes") if isinstance(diagnostics, Mapping) else []


def _titles(actor: Mapping[str, Any]) -> list[Any]:
    return [
        actor.get("label"),
        actor.get("asset_category"),
        actor.get("semantic_category"),
        *_many(actor, "actor_tags"),
    ]


def _paths(actor: Mapping[str, Any]) -> list[Any]:
    return [actor.get("asset_path"), *_many(actor, "component_asset_paths")]


def own_names(actor: Mapping[str, Any]) -> list[str]:
    """An actor's own names: of its assets only the last part counts."""
    return _texts([*_titles(actor), actor.get("class"), *map(_leaf, _paths(actor))])


def bounds_of(actor: Mapping[str, Any]) -> tuple[Boxes, Boxes] | None:
    """World box of an actor as (origin, half extent) in cm; None when it is not valid."""
    try:
        origin = np.array(measured_vector(actor.get("bounds"), "origin_cm"))
        extent = np.array(measured_vector(actor.get("bounds"), "extent_cm"))
    except ValueError:
        return None
    return origin, np.abs(extent)


def _no_body(actor: Mapping[str, Any]) -> bool:
    """Collision off, an effect, a group, or a class of light, sky, camera or volume."""
    collision = actor.get("collision")
    if any(actor.get(field) is False for field in ("collision_enabled", "has_collision", "collidable")) or (
        isinstance(collision, Mapping) and collision.get("collision_enabled") is False
    ):
        return True
    classes = _texts([actor.get("class"), *_component_classes(actor)])
    texts = _texts([*_titles(actor), *_paths(actor), *_many(actor, "material_paths")]) + classes
    return any(map(_names_effect_or_group, texts)) or any(not CLASS_WORDS.isdisjoint(words(name)) for name in classes)


@lru_cache(maxsize=1 << 16)
def _names_effect_or_group(text: str) -> bool:
    return not EFFECT_WORDS.isdisjoint(words(text)) or "groupactor" in re.sub(r"[^a-z0-9]+", "", text.lower())


def _is_water(actor: Mapping[str, Any], box: tuple[Boxes, Boxes] | None) -> bool:
    """Named like water; by its materials and components only where it is thin enough to be the surface itself."""
    named = _texts([*_titles(actor), actor.get("class"), actor.get("asset_path")])
    parts = _texts(
        [*_many(actor, "material_paths"), *_many(actor, "component_asset_paths"), *_component_classes(actor)]
    )
    thin = box is not None and float(box[1][2]) <= GROUND_SPAN_CM / 2
    return any(map(WATER.search, named)) or (thin and any(map(WATER.search, parts)))


def is_non_solid(actor: Mapping[str, Any]) -> bool:
    """Nothing to bump into: collision off, effects, lights, cameras, volumes, groups, water."""
    return _no_body(actor) or _is_water(actor, bounds_of(actor))


def _broad_and_thin(extent: Boxes) -> bool:
    return 2 * float(extent[:2].min()) >= GROUND_SPAN_CM and 2 * float(extent[2]) <= GROUND_SPAN_CM


def is_ground(actor: Mapping[str, Any], extent: Boxes) -> bool:
    """A broad thin surface named like ground, or rough terrain of any shape.

    Its materials may tell too, by a word of their own (``M_Floor01``); its role only by the plain word.
    """
    names = own_names(actor)
    if any(map(ROUGH.search, names)):
        return True
    role, materials = actor.get("actor_role"), _texts(map(_leaf, _many(actor, "material_paths")))
    told = (
        _variants(names)
        | set(words(str(role or "")))
        | {word.rstrip("0123456789") for text in materials for word in words(text)}
    )
    return not GROUND_WORDS.isdisjoint(told) and _broad_and_thin(extent)


def needs_no_support(actor: Mapping[str, Any]) -> bool:
    """Whether an edited actor is left out of the support test in image-to-scene: no body, water surface, or ground.

    Narrower than the roles: the folder of a class says nothing, thick water and rough terrain are tested, and a
    material tells ground only on an engine's basic shape.
    """
    if _no_body(actor):
        return True
    box = bounds_of(actor)
    if box is None:
        return False
    extent = box[1]
    if (
        float(extent[2]) <= GROUND_SPAN_CM / 2
        and 2 * float(extent[:2].min()) >= GROUND_SPAN_CM
        and _is_water(actor, box)
    ):
        return True
    told = _variants(_texts([*_titles(actor), _leaf(actor.get("class")), *map(_leaf, _paths(actor))]))
    if GROUND_WORDS.isdisjoint(told) and any(map(BASIC_SHAPE.search, _texts([actor.get("class"), *_paths(actor)]))):
        told = _variants(_texts(map(_leaf, _many(actor, "material_paths"))))
    return not GROUND_WORDS.isdisjoint(told) and _broad_and_thin(extent)


def roles(actors: Sequence[Mapping[str, Any]]) -> list[Role]:
    """The role of every actor of a scene, in scene order."""
    result: list[Role] = ["scored_solid"] * len(actors)
    solids: dict[int, tuple[Boxes, Boxes] | None] = {}
    grounds: set[int] = set()
    for index, actor in enumerate(actors):
        box = bounds_of(actor)
        if is_non_solid(actor):
            result[index] = "non_solid"
            continue
        solids[index] = box
        if box is None:
            result[index] = "unresolved"
        elif any("landscape" in name.lower() for name in own_names(actor)):
            result[index] = "support_surface"
        elif is_ground(actor, box[1]):
            result[index] = "support_surface"
            if 2 * float(box[1][2]) > GROUND_SPAN_CM:
                grounds.add(index)
    candidates = [index for index in solids if result[index] == "scored_solid" or index in grounds]
    for index in _proxies(actors, solids, candidates):
        result[index] = "environment_proxy"
    return result


def _proxies(
    actors: Sequence[Mapping[str, Any]], solids: Mapping[int, tuple[Boxes, Boxes] | None], candidates: Sequence[int]
) -> Iterable[int]:
    """Solids that are a scene's shell: far larger than the rest, backdrop-like, and around many others."""
    boxes = {index: box for index, box in solids.items() if box is not None}
    if not boxes:
        return
    origins = np.array([origin for origin, _ in boxes.values()])
    median = float(np.median([2 * float(extent.max()) for _, extent in boxes.values()]))
    needed = max(PROXY_ORIGINS, math.ceil(PROXY_SHARE * (len(solids) - 1)))
    for index in candidates:
        origin, extent = boxes[index]
        span = 2 * float(extent.max())
        if span <= PROXY_SPAN_CM or (span < PROXY_HUGE_CM and not 0 < PROXY_RATIO * median <= span):
            continue
        inside = int(((origins >= origin - extent) & (origins <= origin + extent)).all(axis=1).sum()) - 1
        paths = [path.replace("\\", "/") for path in _texts(_paths(actors[index]))]
        if inside >= needed and (
            any(map(BACKDROP.search, own_names(actors[index]))) or any(map(BASIC_SHAPE.search, paths))
        ):
            yield index
