"""Support of edited actors as the published in-editor probe measures it (scorer fact 4, support model
``ground_or_lateral_v1``).

Lines go straight down through an actor's vertices, from just above its box. A vertex rests where the first surface on
its line lies within 5 cm of it, above or below. Where the resting vertices span an area in plan, the actor stands.
Without vertices nine places of its box are tested instead, and one that rests within 5 cm of the box's underside is
enough. An actor that does not stand can still be a panel that something larger holds (``c4s.verify.physics.panels``).

A line stops at the first surface: what is no solid, or was edited in the same group, holds nothing and hides what is
behind it.
"""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal, NamedTuple

import numpy as np

from c4s.collision import NOISE_CM
from c4s.collision.mesh_body import Array, triple
from c4s.protocol.rules import GAP_CM, PROBE_ABOVE_CM, PROBE_BELOW_CM, PROBE_CROWD, PROBE_GROUP, PROBE_VERTICES
from c4s.verify.actors.roles import bounds_of, is_non_solid
from c4s.verify.physics.panels import LINES, Lateral, Panel, held_sideways, panel_lines, panel_of
from c4s.verify.physics.surfaces import Component, FirstHits, Surfaces, read_component

Mode = Literal["ground", "lateral", "none"]
Method = Literal["vertices", "box"]

HOLLOW_WORDS = frozenset(
    {
        "water",
        "ocean",
        "sea",
        "lake",
        "river",
        "canal",
        "pond",
        "pool",
        "sky",
        "atmosphere",
        "postprocess",
        "reflection",
        "navmesh",
        "particle",
        "particles",
        "niagara",
        "emitter",
        "vfx",
        "fxsystem",
    }
)
HOLLOW_CLASSES = (
    "light",
    "camera",
    "fog",
    "atmosphere",
    "volume",
    "reflectioncapture",
    "groupactor",
    "emitter",
    "niagaraactor",
)
_LISTS = ("actor_tags", "component_asset_paths")
NO_AREA_CM2 = 1e-9
"""Rounding of points on one line."""
_PLACES = (0.0, 0.0), *((x, y) for x in (-0.65, 0.0, 0.65) for y in (-0.65, 0.0, 0.65) if x or y)
"""Of the half extents of a box: its middle, and the rest of a 3 x 3 grid."""


@dataclass(frozen=True)
class Footing:
    """What was found under and beside one edited actor."""

    state: Literal["supported", "floating", "unresolved"]
    mode: Mode = "none"
    method: Method | None = None
    gap_cm: float | None = None
    """How far the surface below is from the nearest vertex (from the underside without vertices); negative where the
    actor reaches into it. None: nothing is below."""
    lateral: Lateral | None = None
    holders: list[int] = field(default_factory=list)
    """Actors that hold it."""
    reason: str = ""


class _Probe(NamedTuple):
    actor: int
    low: Array
    high: Array
    components: list[Component]
    vertices: Array
    """In the world; none where the actor has no mesh that is known."""
    plan: Array
    """Where the lines go down."""
    line_of: list[int]
    """Line of each vertex."""


def groups_of(order: Sequence[int]) -> dict[int, frozenset[int]]:
    """For each edited actor those that do not support it, from the order in which they are measured."""
    size = PROBE_GROUP if len(order) < PROBE_CROWD else 1
    return {
        actor: frozenset(order[first : first + size])
        for first in range(0, len(order), size)
        for actor in order[first : first + size]
    }


def holds_nothing(actor: Mapping[str, Any]) -> bool:
    """A surface that is no solid to the probe: by the words of the actor's own names, or by the end of its class."""
    kind = str(actor.get("class") or "").rpartition(".")[2].lower()
    tags, paths = (found if isinstance(found := actor.get(key), list) else [] for key in _LISTS)
    meshes = [str(path).replace("\\", "/").rpartition("/")[2].rpartition(".")[2] for path in paths]
    names = " ".join(map(str, [actor.get("label"), actor.get("name"), kind, *tags, *meshes])).lower()
    return not HOLLOW_WORDS.isdisjoint(re.findall(r"[a-z0-9]+", names)) or kind.endswith(HOLLOW_CLASSES)


def edited_footing(
    actors: Sequence[Mapping[str, Any]],
    tested: Sequence[int],
    excluded: Mapping[int, Collection[int]],
    surfaces: Surfaces,
) -> dict[int, Footing]:
    """What holds each tested actor (an index).

    Args:
        actors: all actors of the scene.
        tested: the edited actors to look at.
        excluded: for each of them the actors that do not support it.
        surfaces: what lines meet. Near an actor whose surfaces are not known a missing support proves nothing.
    """
    boxes = [bounds_of(actor) for actor in actors]
    extents = [None if box is None else box[1] for box in boxes]
    hollow = [holds_nothing(actor) for actor in actors]
    found: dict[int, Footing] = {}
    probes = []
    for index in tested:
        box = boxes[index]
        if index in surfaces.unknown or box is None:
            found[index] = Footing("unresolved", reason=surfaces.unknown.get(index, "no valid world box"))
            continue
        try:
            probes.append(_probe(index, actors[index], box[0] - box[1], box[0] + box[1], surfaces))
        except ValueError as error:
            found[index] = Footing("unresolved", reason=str(error))
    below = _below(probes, surfaces)
    leaning: list[tuple[_Probe, Footing, Panel | None]] = []
    for probe, hits in zip(probes, below, strict=True):
        solid = [k >= 0 and not hollow[k] and k not in excluded[probe.actor] for k in hits.actor.tolist()]
        footing = _standing(probe, hits, solid)
        if footing.state == "supported":
            found[probe.actor] = footing
        else:
            leaning.append((probe, footing, _largest_panel(probe, surfaces)))
    sideways = _sideways([(probe, panel) for probe, _, panel in leaning if panel is not None], surfaces)
    unknown = _unknown_boxes(actors, boxes, surfaces)
    for probe, footing, panel in leaning:
        if panel is None:
            found[probe.actor] = _or_unresolved(footing, probe, unknown)
            continue
        hits = sideways[probe.actor]
        solid = [k >= 0 and not hollow[k] and k not in excluded[probe.actor] for k in hits.actor.tolist()]
        lateral = held_sideways(panel, hits, extents, solid)
        if lateral.held:
            found[probe.actor] = Footing(
                "supported", "lateral", footing.method, footing.gap_cm, lateral, lateral.holders
            )
        else:
            left = Footing("floating", "none", footing.method, footing.gap_cm, lateral)
            found[probe.actor] = _or_unresolved(left, probe, unknown)
    return {index: found[index] for index in tested}


def _probe(index: int, actor: Mapping[str, Any], low: Array, high: Array, surfaces: Surfaces) -> _Probe:
    own = actor.get("c4s")
    listed = own.get("components") if isinstance(own, Mapping) else None
    read = [read_component(part) for part in listed or []]
    components = [part for part in read if part is not None and part.static]
    vertices = _vertices(components, surfaces)
    if len(vertices):
        lines: dict[tuple[float, float], int] = {}
        keys = [(round(x, 1), round(y, 1)) for x, y in vertices[:, :2].tolist()]
        starts = [row for row, key in enumerate(keys) if lines.setdefault(key, row) == row]
        number = {row: line for line, row in enumerate(starts)}
        return _Probe(
            index, low, high, components, vertices, vertices[starts, :2], [number[lines[key]] for key in keys]
        )
    plan = (low + high)[:2] / 2 + np.array(_PLACES) * (high - low)[:2] / 2
    return _Probe(index, low, high, components, vertices, plan, [])


def _vertices(components: Sequence[Component], surfaces: Surfaces) -> Array:
    """Evenly picked vertices of the meshes in the world; a component's instances are not looked at."""
    picked: list[Array] = []
    left = PROBE_VERTICES
    for component in components:
        mesh = surfaces.mesh(component.mesh)
        if mesh is not None and left > 0:
            local = np.asarray(mesh.vertices, dtype=np.float64)[:: max(1, math.ceil(len(mesh.vertices) / left))]
            picked.append(local @ component.pose[:3, :3].T + component.pose[:3, 3])
            left -= len(local)
    return np.concatenate(picked) if picked else np.zeros((0, 3))


def _below(probes: Sequence[_Probe], surfaces: Surfaces) -> list[FirstHits]:
    """What the lines of each probe meet on their way down."""
    counts = [len(probe.plan) for probe in probes]
    plan = np.concatenate([np.zeros((0, 2)), *(probe.plan for probe in probes)])
    top = np.repeat([probe.high[2] + PROBE_ABOVE_CM for probe in probes], counts)
    end = np.repeat([probe.low[2] - PROBE_BELOW_CM for probe in probes], counts)
    own = np.repeat(np.array([probe.actor for probe in probes], dtype=np.int64), counts)
    step = np.column_stack([np.zeros((len(plan), 2)), end - top])
    return _split(surfaces.first(np.column_stack([plan, top]), step, own), counts)


def _sideways(panels: Sequence[tuple[_Probe, Panel]], surfaces: Surfaces) -> dict[int, FirstHits]:
    """What the lines of each panel meet."""
    lines = [panel_lines(panel) for _, panel in panels]
    start, step = (np.concatenate([np.zeros((0, 3)), *(pair[k] for pair in lines)]) for k in (0, 1))
    own = np.repeat(np.array([probe.actor for probe, _ in panels], dtype=np.int64), LINES)
    hits = _split(surfaces.first(start, step, own), [LINES] * len(panels))
    return {probe.actor: part for (probe, _), part in zip(panels, hits, strict=True)}


def _split(hits: FirstHits, counts: Sequence[int]) -> list[FirstHits]:
    ends = np.cumsum([0, *counts]).tolist()
    return [hits.part(a, b) for a, b in itertools.pairwise(ends)]


def _standing(probe: _Probe, hits: FirstHits, solid: Sequence[bool]) -> Footing:
    met = np.array(solid, dtype=bool)
    if len(probe.vertices):
        lines = np.array(probe.line_of, dtype=np.int64)
        gaps = probe.vertices[:, 2] - hits.point[lines, 2]
    else:
        lines = np.arange(len(probe.plan))
        within = max(float(probe.high[2] - probe.low[2]), GAP_CM + 1)
        gaps = np.where(hits.inside, -within, probe.low[2] - hits.point[:, 2])
    gaps = np.where(met[lines], gaps, np.inf)
    rests = np.abs(gaps) <= GAP_CM + NOISE_CM
    method: Method = "vertices" if len(probe.vertices) else "box"
    stands = spans_area(probe.vertices[rests, :2].tolist()) if method == "vertices" else bool(rests.any())
    nearest = float(gaps[np.abs(gaps).argmin()]) if len(gaps) else np.inf
    gap = nearest if np.isfinite(nearest) else None
    if not stands:
        return Footing("floating", "none", method, gap)
    return Footing("supported", "ground", method, gap, None, sorted(set(hits.actor[lines[rests]].tolist())))


def spans_area(points: Collection[Sequence[float]]) -> bool:
    """Whether the convex hull of plan points, rounded to 4 places, has an area.

    Points on a slanting line have one by that rounding, as in the published measure.
    """
    places = sorted({(round(x, 4), round(y, 4)) for x, y in points})
    if len(places) < 3:
        return False
    (ax, ay), (bx, by) = places[0], places[-1]
    return any(abs((bx - ax) * (y - ay) - (by - ay) * (x - ax)) > NO_AREA_CM2 for x, y in places)


def _largest_panel(probe: _Probe, surfaces: Surfaces) -> Panel | None:
    """The panel with the largest face among the components; the first of equal ones."""
    panels = []
    for component in probe.components:
        facts = surfaces.facts.get(component.mesh)
        try:
            low, high = (triple((facts or {}).get(f"bounds_{end}_cm")) for end in ("min", "max"))
        except ValueError:
            continue
        panel = panel_of(low, high, component.pose)
        panels += [panel] if panel is not None else []
    return max(panels, key=lambda panel: panel.area_cm2, default=None)


def _unknown_boxes(
    actors: Sequence[Mapping[str, Any]], boxes: Sequence[tuple[Array, Array] | None], surfaces: Surfaces
) -> list[tuple[int, Array, Array]]:
    """World boxes of solid actors whose surfaces are not known; without bounds they may be anywhere."""
    found = []
    for index in surfaces.unknown:
        if not is_non_solid(actors[index]):
            box = boxes[index]
            middle, half = box if box is not None else (np.zeros(3), np.full(3, np.inf))
            found.append((index, middle - half, middle + half))
    return found


def _or_unresolved(footing: Footing, probe: _Probe, unknown: Sequence[tuple[int, Array, Array]]) -> Footing:
    near = any(
        index != probe.actor and bool(np.all(probe.low - GAP_CM <= high) and np.all(probe.high + GAP_CM >= low))
        for index, low, high in unknown
    )
    if not near:
        return footing
    return replace(footing, state="unresolved", reason="near an actor whose surfaces are not known")
