"""A scene from a prompt and its palette, without a model: what the prose names, as often as it says so.

Of all that the prose says of where things are, it reads what stands *on* something and what stands *near* something
(``prose``). What belongs together is nested (``nesting``) and laid out as rigid blocks (``grouping``, ``regions``),
which go near each other or where there is room (``arranging``), indoors within ``walls``. Deterministic.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from c4s.agents.baselines.blocks import Block, Piece, in_grid, joined, single, tiled
from c4s.agents.baselines.naming import FLAT_SHARE, is_flat
from c4s.agents.baselines.nesting import Forest, forest
from c4s.agents.baselines.palette import PaletteItem, description, palette, singular
from c4s.agents.baselines.prose import read
from c4s.agents.baselines.regions import Regions
from c4s.agents.baselines.walls import HOLES, enclosed, is_thin, walled

MOST_PIECES = 700
LARGEST_SHARE = 0.6
"""Of the plate: what is longer is left out."""
REACH_SHARE = 0.48
GAP_M, INDOOR_GAP_M = 2.5, 0.8
LEAST_FLOOR_M2 = 1.0
TILE_M, TILE_HEIGHT_M = 1.0, 0.12
LEAST_NAMED = 2
RING_GAP_M, LEAST_RING_M = 2.0, 2.0
RING = re.compile(
    r"\b(?:enclos\w*|surround\w*|encircl\w*|ring|ringed|fortified)\b[^.;]{0,90}\bwalls?\b"
    r"|\bwalled (?:town|city|village|garden|compound|yard)\b"
)
MOST_UNNAMED = 40


def compose(prompt: str, plate_m: float) -> dict[str, Any]:
    """A scene graph for the planner, in metres, within the plate."""
    reading = read(prompt)
    items = [item for item in palette(prompt) if max(item.width, item.depth) <= LARGEST_SHARE * plate_m]
    usable = set(items)
    for named in reading.named:
        named.items = tuple(item for item in named.items if item in usable)
    reading.named = [named for named in reading.named if named.items or named.is_place]
    known = set(reading.named)
    reading.links = [link for link in reading.links if {link.thing, link.other} <= known]
    if sum(bool(named.items) for named in reading.named) < LEAST_NAMED:
        return _graph_of(_all_of(items, plate_m))
    found = forest(reading, description(prompt))
    whole = Regions(found, items, REACH_SHARE * plate_m).laid(found.roots, INDOOR_GAP_M if found.indoors else GAP_M)
    if not found.indoors and (wall := _ring_of(description(prompt), items)):
        ringed = enclosed(whole.grown(RING_GAP_M).move_to(0.0, 0.0), [wall])
        whole = ringed if max(ringed.width, ringed.depth) <= plate_m else whole
    if found.indoors:
        whole = _house(whole, found, items, reading.size_m or (0.0, 0.0))
    return _graph_of(whole)


def _ring_of(text: str, items: Sequence[PaletteItem]) -> PaletteItem | None:
    """The wall that the text draws around everything: the largest plain piece of one that can stand in a row."""
    if not RING.search(text.lower()):
        return None
    named = (item for item in items if "wall" in map(singular, item.name.lower().split()))
    walls = [item for item in named if is_thin(item) and item.height >= LEAST_RING_M]
    plain = [item for item in walls if not item.words & HOLES] or walls
    return max(plain, key=lambda item: item.height * max(item.width, item.depth), default=None)


def _house(inner: Block, found: Forest, items: Sequence[PaletteItem], least: tuple[float, float]) -> Block:
    """Walls around what stands in all rooms, and one floor: the named one, else one of the palette."""
    whole = walled(inner, least, items)
    named = sorted(found.shell, key=lambda one: one.noun in ("floor", "wall"))
    floors = [item for one in named if one.noun != "ceiling" for item in one.items]
    floors += [item for item in items if "floor" in item.words]
    floor = next((item for item in floors if is_flat(item) and item.area >= LEAST_FLOOR_M2), None)
    if floor is None:
        return whole
    return joined([tiled(floor, whole.rect, most=120), whole.raise_by(floor.height)])


def _all_of(items: Sequence[PaletteItem], plate_m: float) -> Block:
    """Where the prose names nothing: each asset that stands on its own once, in a grid that fits."""
    chosen = [item for item in items if not is_flat(item)][:MOST_UNNAMED]
    while chosen:
        block = in_grid([single(item) for item in chosen], max(1, round(len(chosen) ** 0.5)), 2.0)
        if max(block.width, block.depth) < 0.95 * plate_m:
            return block
        chosen.remove(max(chosen, key=lambda item: item.area))
    return Block()


def _graph_of(whole: Block) -> dict[str, Any]:
    """The planner's graph of a block: one node a piece."""
    ids: dict[Piece, str] = {}
    nodes: list[dict[str, Any]] = []
    carried = [piece for piece in whole.pieces if piece.on is not None]
    for piece in [*(piece for piece in whole.pieces if piece.on is None), *carried][:MOST_PIECES]:
        if piece.on is not None and piece.on not in ids:
            continue
        ids[piece] = name = f"{piece.item.id}_{len(nodes) + 1}"
        node: dict[str, Any] = {"id": name, "asset": piece.item.path, "yaw_deg": float(piece.yaw)}
        node["at"] = [round(piece.x, 3), round(piece.y, 3)]
        if piece.on is not None:
            node["on"] = ids[piece.on]
        else:
            node["at"].append(round(piece.z + (piece.item.height if _is_tile(piece) else 0.0), 3))
        if piece.scale != 1.0:
            node["scale"] = [piece.scale, piece.scale, 1.0]
        nodes.append(node)
    return {"nodes": nodes}


def _is_tile(piece: Piece) -> bool:
    """Whether the planner takes a piece for ground, whose height is that of its top."""
    width = 2 * min(piece.half)
    return width >= TILE_M and piece.item.height <= max(FLAT_SHARE * width, TILE_HEIGHT_M)
