"""Which asset is the ground of a scene: how a ground is made, what it is called, and how well it fits the text."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from c4s.records.pack import Asset
from c4s.toolbox.catalog import CatalogEntry, document_of
from c4s.toolbox.refusal import ToolRefused
from c4s.toolbox.search import sentence_model, stems_of

INDOORS = frozenset(stems_of("floor flooring carpet parquet plank laminate linoleum"))
OUTDOORS = frozenset(
    stems_of(
        "road street plaza paving pavement cobble cobblestone flagstone grass lawn meadow field soil earth dirt mud "
        "sand snow gravel asphalt terrain landscape yard"
    )
)
NEITHER = frozenset(stems_of("ground tile plane concrete deck dock"))
"""Words that grounds are called by: those of buildings, those of open places, and those of both."""
GENERIC = NEITHER | frozenset(stems_of("floor flooring terrain landscape"))
"""Words that say nothing of the material."""
NO_GROUND = frozenset(
    stems_of(
        "rug mat doormat blanket towel ceiling roof wall partition door window pond pool puddle lake river sea water "
        "canal lamp light panel table bed bench sign picture poster board screen mirror stage bridge ramp stairs "
        "border curb kerb trim corner angle bump hatch manhole newspaper"
    )
)
"""What is called by one of these is no ground, whatever else it is called."""
LEAST_SIDE_M, MOST_HEIGHT_M, FLATNESS = 1.0, 0.6, 0.1
LEAST_COVER = 0.95
"""Share of its rectangle that a tile's collision must cover: what has gaps or round edges does not tile."""
NAMED, MIXED, ASTRAY = 0.1, 0.2, 0.3
"""Weights: of a material that the text names; of each further material of a tile, which shows as a pattern when it is
laid side by side; of a floor of buildings in an open place, and the other way round."""
INSIDE, OUTSIDE = "indoors: a room inside a building", "outdoors: an open place under the sky"
CLEAR = 0.15
"""From this difference of its cosines with the two on, a text is clearly of one of them."""
LEAST_FIT = {True: 0.1, None: 0.25, False: 0.5}
"""The cosine with the text or a clause that a ground needs: of the text's own side, of no clear one, of the other."""
TOLD = 4
_CLAUSE = re.compile(r"[.;:,\n]")


@dataclass(frozen=True)
class GroundChoice:
    """What is laid: the entry, why, and the other grounds of the catalog, best first."""

    entry: CatalogEntry
    why: str
    others: list[str]


def choose_ground(scene_text: str, entries: Sequence[CatalogEntry]) -> GroundChoice:
    """The ground that fits a text best. Refused where the catalog has none, or none that fits."""
    flat = [entry for entry in entries if is_flat(entry.asset)]
    grounds = [entry for entry in flat if is_ground(entry.asset) and is_solid(entry)]
    if not grounds:
        told = f": {', '.join(entry.asset.id for entry in flat[:TOLD])} lie flat and are none" if flat else ""
        raise _refused(f"the catalog has no asset that is a ground{told}")
    clauses = [clause.strip() for clause in _CLAUSE.split(scene_text) if stems_of(clause)]
    if not clauses:
        raise ToolRefused("the scene text says nothing of what the place is", todo="give the scene in words")
    texts = [scene_text, INSIDE, OUTSIDE, *clauses]
    said = dict(zip(texts, sentence_model().vectors(texts), strict=True))
    fits = [_fit(entry.asset, scene_text, clauses, said) for entry in grounds]
    ranked = sorted(zip(fits, grounds, strict=True), key=lambda row: (-row[0].score, row[1].asset.id))
    best, entry = ranked[0]
    others = [row[1].asset.id for row in ranked[1:]]
    if best.nearest < LEAST_FIT[best.own_side]:
        told = f"the nearest is {entry.asset.id}; others: {', '.join(others[:TOLD]) or 'none'}"
        raise _refused(f"no ground of the catalog fits this scene ({told})")
    why = f"of {len(grounds)} grounds in the catalog it fits the text best, by {best.clause!r}"
    return GroundChoice(entry, why, others)


@dataclass(frozen=True)
class _Fit:
    """How a ground fits a text. ``own_side``: whether both are of buildings or both of open places, None if unclear."""

    score: float
    nearest: float
    clause: str
    own_side: bool | None


def _fit(asset: Asset, scene_text: str, clauses: Sequence[str], said: dict[str, NDArray[np.float32]]) -> _Fit:
    """The text's opening clause says what the place is, all of it what it is like, one clause what its ground is."""
    line, description = sentence_model().vectors([document_of(asset).line, asset.description or asset.name])
    whole, parts = said[scene_text], np.array([said[clause] for clause in clauses])
    near = np.maximum(parts @ line, parts @ description)
    best = int(near.argmax())
    name = set(stems_of(asset.name))
    indoors = float(whole @ said[INSIDE] - whole @ said[OUTSIDE])
    side = bool(name & INDOORS) - bool(name & OUTDOORS)
    own_side = None if abs(indoors) < CLEAR or not side else (side > 0) == (indoors > 0)
    material = (name & (INDOORS | OUTDOORS) & set(stems_of(scene_text))) - GENERIC
    score = float(parts[0] @ line + whole @ line + near[best]) + NAMED * bool(material)
    score -= MIXED * max(0, len(asset.slots) - 1) + ASTRAY * (own_side is False)
    told = next((clause for clause in clauses if material & set(stems_of(clause))), clauses[best])
    return _Fit(round(score, 4), float(max(near[best], whole @ line)), told, own_side)


def _refused(what: str) -> ToolRefused:
    return ToolRefused(
        what, todo="lay tiles of your choice with build_tier, or let setup_environment add a plain ground"
    )


def is_flat(asset: Asset) -> bool:
    """Whether a mesh is far lower than wide."""
    width, depth, height = asset.size_m
    side = min(width, depth)
    return asset.kind == "static_mesh" and side >= LEAST_SIDE_M and height <= min(MOST_HEIGHT_M, FLATNESS * side)


def is_ground(asset: Asset) -> bool:
    """Whether an asset is called a ground: its name decides, else its category and tags."""
    for text in (asset.name, f"{asset.category} {' '.join(asset.tags)}"):
        stems = set(stems_of(text))
        if stems & NO_GROUND:
            return False
        if stems & (INDOORS | OUTDOORS | NEITHER):
            return True
    return False


def is_solid(entry: CatalogEntry) -> bool:
    """Whether a tile holds what stands on it, up to its edges, and is not seen through."""
    asset = entry.asset
    clear = {material.path for material in entry.pack.materials if material.opacity < 1 or material.alpha != "opaque"}
    return not any(slot.material in clear for slot in asset.slots) and cover(asset) >= LEAST_COVER


def cover(asset: Asset) -> float:
    """Share of an asset's rectangle that its collision bodies cover, seen from above (turned boxes as if straight)."""
    from shapely import MultiPoint, box, union_all

    shadows = []
    for body in asset.collision:
        if body.kind == "box":
            (x, y, _), (half_x, half_y, _) = body.center, body.half_extent
            shadows.append(box(x - half_x, y - half_y, x + half_x, y + half_y))
        elif body.kind == "hull":
            shadows.append(MultiPoint([(x, y) for x, y, _ in body.vertices]).convex_hull)
    width, depth, _ = (100 * side for side in asset.size_m)
    return float(union_all(shadows).area) / (width * depth)
