"""The scene graph that an agent writes for the planner, read and checked.

A graph is ``{"nodes": [...]}``. A node places one asset, or ``count`` copies of it in a ``layout``::

    {"id": "house", "asset": "townhouse_a", "at": [12, -4], "yaw_deg": 90, "scale": 1,
     "count": 6, "layout": {"kind": "row", "spacing_m": 9, "yaw_deg": 0},
     "on": "quay", "relation": {"kind": "next_to", "of": "well", "distance_m": 2}}

``at`` is metres from the plate's centre (X, Y, optionally Z of the bottom); without it ``relation`` or ``on``
decides, else the centre. ``on`` stands the copies on top of another node's first copy. Layout kinds: ``row``,
``grid``, ``ring``, ``scatter``. Relation kinds:
``next_to``, ``left_of``, ``right_of``, ``in_front_of``, ``behind``, ``around``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from c4s.records.pack import Asset

LAYOUTS = ("row", "grid", "ring", "scatter")
RELATIONS = ("next_to", "left_of", "right_of", "in_front_of", "behind", "around")
MAX_COPIES, MAX_ALL_COPIES = 2000, 5000
"""Copies of one node, and of a graph."""
MOST = 1.0e5
"""Largest number in a graph: 100 km, or that many degrees."""
LONGEST_ID = 190
FIELDS = frozenset({"id", "asset", "at", "yaw_deg", "scale", "count", "layout", "on", "relation"})


@dataclass(frozen=True)
class Layout:
    """How the copies of a node are arranged (metres, degrees)."""

    kind: str = "row"
    spacing_m: float = 0.0
    radius_m: float = 0.0
    yaw_deg: float = 0.0
    facing: str = "same"
    """``same`` keeps each copy's yaw; ``centre`` turns the copies of a ring to its centre."""


@dataclass(frozen=True)
class Node:
    """A checked node."""

    id: str
    asset: Asset
    at_m: tuple[float, float, float | None] | None
    yaw_deg: float
    scale: tuple[float, float, float]
    count: int
    layout: Layout
    on: str | None
    relation: tuple[str, str, float] | None
    """Kind, node id, distance in metres."""


@dataclass(frozen=True)
class Problem:
    """What is wrong with a node; ``drops`` says that the node will not survive."""

    node: str
    text: str
    drops: bool = True


def index_catalog(catalog: Sequence[Asset]) -> dict[str, Asset]:
    """Assets by id, path, spawn path, package path and name, lower case; the first of equal names wins."""
    found: dict[str, Asset] = {}
    for asset in catalog:
        for key in (asset.id, asset.path, asset.spawn_path, asset.path.split(".")[0], asset.name):
            found.setdefault(key.lower(), asset)
    return found


def read_graph(graph: Any, catalog: Sequence[Asset]) -> tuple[list[Node], list[Problem]]:
    """Checked nodes in order, and the problems found. A node with a dropping problem is left out."""
    if not isinstance(graph, Mapping) or not isinstance(graph.get("nodes"), list):
        return [], [Problem("graph", "a graph is an object with a list `nodes`")]
    assets = index_catalog(catalog)
    nodes: list[Node] = []
    problems: list[Problem] = []
    seen: set[str] = set()
    copies = 0
    for position, raw in enumerate(graph["nodes"]):
        name = str(raw.get("id") or f"node_{position + 1}") if isinstance(raw, Mapping) else f"node_{position + 1}"
        try:
            node, notes = _read_node(name, raw, assets, seen)
            if copies + node.count > MAX_ALL_COPIES:
                raise ValueError(f"the graph has more than {MAX_ALL_COPIES} copies: build it in parts")
        except ValueError as error:
            problems.append(Problem(name[:LONGEST_ID], str(error)))
            continue
        problems += [Problem(name, note, drops=False) for note in notes]
        nodes.append(node)
        copies += node.count
        seen.add(name)
    return nodes, problems


def _read_node(name: str, raw: Any, assets: Mapping[str, Asset], seen: set[str]) -> tuple[Node, list[str]]:
    if not isinstance(raw, Mapping):
        raise ValueError("a node is an object")
    if len(name) > LONGEST_ID or not name.isprintable():
        raise ValueError(f"an id has at most {LONGEST_ID} characters, all printable")
    if name in seen:
        raise ValueError("this id is used twice")
    asset = assets.get(str(raw.get("asset", "")).lower())
    if asset is None:
        raise ValueError(
            f"asset {str(raw.get('asset'))[:LONGEST_ID]!r} is not in the catalog: find ids with search_assets"
        )
    count = _number(raw.get("count", 1), "count")
    if count != int(count) or not 1 <= count <= MAX_COPIES:
        raise ValueError(f"count must be a whole number from 1 to {MAX_COPIES}")
    notes = [f"field {str(key)[:LONGEST_ID]!r} is not known and is ignored" for key in sorted(set(raw) - FIELDS)]
    if raw.get("on") is not None and (not isinstance(raw["on"], str) or raw["on"] not in seen):
        raise ValueError(f"'on' names {str(raw['on'])[:LONGEST_ID]!r}, which is no earlier node that survives")
    scale = raw.get("scale", 1.0)
    factors = _vector(scale, "scale", 3) if isinstance(scale, list | tuple) else (_number(scale, "scale"),) * 3
    if any(factor == 0 for factor in factors):
        raise ValueError("scale must not be zero")
    return Node(
        id=name,
        asset=asset,
        at_m=_place(raw.get("at")),
        yaw_deg=_number(raw.get("yaw_deg", 0.0), "yaw_deg"),
        scale=(factors[0], factors[1], factors[2]),
        count=int(count),
        layout=_layout(raw.get("layout")),
        on=raw.get("on"),
        relation=_relation(raw.get("relation"), seen),
    ), notes


def _layout(raw: Any) -> Layout:
    if raw is None:
        return Layout()
    if not isinstance(raw, Mapping) or raw.get("kind", "row") not in LAYOUTS:
        raise ValueError(f"layout kind must be one of {', '.join(LAYOUTS)}")
    return Layout(
        kind=raw.get("kind", "row"),
        spacing_m=_number(raw.get("spacing_m", 0.0), "layout.spacing_m"),
        radius_m=_number(raw.get("radius_m", 0.0), "layout.radius_m"),
        yaw_deg=_number(raw.get("yaw_deg", 0.0), "layout.yaw_deg"),
        facing="centre" if raw.get("facing") in ("centre", "center") else "same",
    )


def _relation(raw: Any, seen: set[str]) -> tuple[str, str, float] | None:
    if raw is None:
        return None
    if not isinstance(raw, Mapping) or raw.get("kind") not in RELATIONS:
        raise ValueError(f"relation kind must be one of {', '.join(RELATIONS)}")
    if not isinstance(raw.get("of"), str) or raw["of"] not in seen:
        raise ValueError(f"relation names {str(raw.get('of'))[:LONGEST_ID]!r}, which is no earlier node that survives")
    return str(raw["kind"]), str(raw["of"]), _number(raw.get("distance_m", 0.5), "relation.distance_m")


def _place(raw: Any) -> tuple[float, float, float | None] | None:
    if raw is None:
        return None
    values = _vector(raw, "at", len(raw) if isinstance(raw, list | tuple) else 0)
    if len(values) not in (2, 3):
        raise ValueError("at must be [x, y] or [x, y, z] in metres")
    return values[0], values[1], values[2] if len(values) == 3 else None


def _vector(raw: Any, name: str, length: int) -> tuple[float, ...]:
    if not isinstance(raw, list | tuple) or len(raw) != length:
        raise ValueError(f"{name} must be a list of {length} numbers")
    return tuple(_number(value, name) for value in raw)


def _number(raw: Any, name: str) -> float:
    if isinstance(raw, bool) or not isinstance(raw, int | float) or not -MOST <= raw <= MOST:
        raise ValueError(f"{name} must be a number from {-MOST:g} to {MOST:g}")
    return float(raw)
