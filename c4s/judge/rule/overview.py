"""The rule judge's overview dimensions. Each is a mean of named parts; what cannot be decided is worth 0."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from c4s.geometry.transform import WORLD_CM
from c4s.protocol.bundle import Entity
from c4s.protocol.numbers import mean
from c4s.semantics.boxes import Boxes, Flags, holds_to_any
from c4s.semantics.decision import Decision
from c4s.semantics.inventory import Thing
from c4s.semantics.quantities import bearable, needed
from c4s.semantics.relations import on
from c4s.semantics.state import StateDecider
from c4s.semantics.substance import is_flat_lying
from c4s.semantics.views import Views

LOOKS_TYPES = frozenset({"attribute", "material"})
SEEN_LOOKS = frozenset({"color", "material"})
"""Kinds of qualifiers that assets and pixels tell of; of others (modern, two-storey) nothing here can."""
PRESENCE_TYPES = frozenset({"existence", "presence", "set", "logic"})
SPATIAL_TYPES = frozenset({"spatial_relation", "distribution"})
STRETCH = 4.0
"""A thing is stretched out of shape when its largest scale factor exceeds its smallest by more than this factor."""
FLAT_CM = 0.1
"""A thing is flattened when two of its sides are not longer than this."""
PLACED = 0.25
"""What an object is worth that is there, but not in the number and place that the prompt asks for."""
FLOOR_CM = 30.0
"""What begins this close over another thing's top stands on it."""


@dataclass(frozen=True)
class DimensionPart:
    """One part of a dimension: its value in [0, 1] (0 when unknown) and what it rests on."""

    name: str
    value: float
    known: bool
    detail: dict[str, Any]


def dimensions(judge: StateDecider, views: Views) -> dict[str, list[DimensionPart]]:
    """The parts of the four prompt dimensions, by dimension name."""
    seen = views.seen(judge.things)
    objects = [entity for entity in judge.requirements.entities.values() if entity.is_object]
    counts = _seen_counts(judge, seen, objects)
    fits = _fits(judge, counts, objects)
    arranged = _arranged(judge, bool(seen))
    realised = _realised(judge, fits, arranged.value if arranged.detail["requirements"] else 1.0)
    return {
        "global_prompt_alignment": [_objects(realised, counts)],
        "composition_and_layout": [arranged],
        "style_atmosphere_coherence": [_looks(judge, realised), arranged],
        "completeness_and_polish": [_counts(fits), _visible(judge, seen, objects), _floor(judge, seen, objects)],
    }


def structural_integrity(things: Sequence[Thing]) -> DimensionPart:
    """Share of things that are finite, not flattened to nothing and not stretched; 0 in an empty scene."""
    if not things:
        return DimensionPart("undistorted", 0.0, False, {"things": 0, "distorted": []})
    scale = np.abs([thing.scale for thing in things])
    low, high = (np.array([getattr(thing, side) for thing in things]) for side in ("low", "high"))
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        sound = (
            (np.maximum(np.abs(low), np.abs(high)).max(axis=1) < WORLD_CM)
            & (np.sort(high - low, axis=1)[:, 1] > FLAT_CM)
            & (scale.min(axis=1) > 0)
            & (scale.max(axis=1) / scale.min(axis=1) <= STRETCH)
        )
    distorted = [things[place].actor for place in np.flatnonzero(~sound).tolist()]
    return DimensionPart(
        "undistorted", int(sound.sum()) / len(things), True, {"things": len(things), "distorted": distorted[:50]}
    )


def _seen_counts(judge: StateDecider, seen: Sequence[Thing], objects: Sequence[Entity]) -> dict[str, int]:
    """How many clearly visible things each named object has."""
    visible = set(seen)
    known: dict[int, int] = {}
    counts = {}
    for entity in objects:
        things = judge.ground(entity.id)
        if id(things) not in known:
            known[id(things)] = sum(thing in visible for thing in things)
        counts[entity.id] = known[id(things)]
    return counts


def _realised(judge: StateDecider, fits: Mapping[str, float], arranged: float) -> dict[str, float]:
    """How far each named object is as asked: as far as its visible count is, and within that by the number and place
    that the prompt asks of it; where it asks none, by how far the scene is arranged as asked."""
    asked: dict[str, list[float]] = {}
    for node in judge.requirements.scored:
        predicate = judge.requirements.predicates[node]
        if judge.measurable(predicate) and predicate.type not in PRESENCE_TYPES:
            for subject in predicate.subjects:
                asked.setdefault(subject, []).append(judge.decide(node).score)
    return {
        key: fit * (PLACED + (1 - PLACED) * (mean(asked[key]) if key in asked else arranged))
        for key, fit in fits.items()
    }


def _objects(realised: Mapping[str, float], counts: Mapping[str, int]) -> DimensionPart:
    """Mean over the prompt's named objects of how far each is as asked."""
    return DimensionPart(
        "realised_objects",
        mean(realised.values()) if realised else 0.0,
        bool(realised),
        {"objects": len(realised), "missing": [key for key, count in counts.items() if not count]},
    )


def _arranged(judge: StateDecider, anything: bool) -> DimensionPart:
    """Mean score of the relations and distributions that geometry measures; what it leaves open counts 0."""
    predicates = (judge.requirements.predicates[node] for node in judge.requirements.scored)
    decisions = [judge.decide(p.id) for p in predicates if p.type in SPATIAL_TYPES and judge.measurable(p)]
    return _part("arranged_as_asked", [found.score if anything else 0.0 for found in decisions], decisions)


def _looks(judge: StateDecider, realised: Mapping[str, float]) -> DimensionPart:
    """Mean score of the colours and materials of the prompt, each as far as its object is as asked (a region as far
    as all are); what nothing decides counts 0."""
    asked = (judge.requirements.predicates[node] for node in judge.requirements.scored)
    predicates = [p for p in asked if p.type in LOOKS_TYPES and any(kind in SEEN_LOOKS for kind, _ in p.qualifiers)]
    decisions = [judge.decide(predicate.id) for predicate in predicates]
    region = mean(realised.values()) if realised else 0.0
    values = [
        found.score * max((realised.get(subject, region) for subject in predicate.subjects), default=0.0)
        for predicate, found in zip(predicates, decisions, strict=True)
    ]
    return _part("looks_as_asked", values, decisions)


def _part(name: str, values: Sequence[float], decisions: Sequence[Decision]) -> DimensionPart:
    return DimensionPart(
        name,
        mean(values) if values else 0.0,
        any(found.status != "UNKNOWN" for found in decisions),
        {"requirements": len(values), "unknown": sum(found.status == "UNKNOWN" for found in decisions)},
    )


def _visible(judge: StateDecider, seen: Sequence[Thing], objects: Sequence[Entity]) -> DimensionPart:
    """Share of what is placed of the named objects that counts and is clearly visible."""
    names = [entity.id for entity in objects]
    counted, aside = set().union(*map(judge.ground, names)), judge.grounding.set_aside(names)
    visible = sum(thing in counted for thing in seen)
    return DimensionPart(
        "visible_things",
        visible / (len(counted) + aside) if visible else 0.0,
        bool(counted or aside),
        {"things": len(counted) + aside, "seen": visible, "set_aside": aside},
    )


def _floor(judge: StateDecider, seen: Sequence[Thing], objects: Sequence[Entity]) -> DimensionPart:
    """Share of the visible named things that something is under: a floor, a table, a landscape."""
    named = set().union(*(judge.ground(entity.id) for entity in objects))
    standing = [thing for thing in seen if thing in named and not is_flat_lying(thing)]
    if not standing:
        return DimensionPart("on_a_floor", 0.0, False, {"things": 0})
    flat = [thing for thing in judge.things if is_flat_lying(thing)]
    under = holds_to_any(standing, flat, _is_over) | on(standing, judge.things)
    low, high = (np.array([getattr(thing, side) for thing in standing]) for side in ("low", "high"))
    for least, most in judge.grounding.landscapes:
        under |= ((low[:, :2] >= least[:2]) & (high[:, :2] <= most[:2])).all(axis=1) & (low[:, 2] <= most[2] + FLOOR_CM)
    return DimensionPart("on_a_floor", float(under.mean()), True, {"things": len(standing), "floors": len(flat)})


def _is_over(subject: Boxes, least: Boxes, most: Boxes) -> Flags:
    """Whether the subject stands on a floor, or in one."""
    meets = np.all((least.low[:, :2] <= subject.high[:, :2]) & (most.high[:, :2] >= subject.low[:, :2]), axis=1)
    return np.asarray(
        meets & (most.high[:, 2] >= subject.low[:, 2] - FLOOR_CM) & (least.high[:, 2] <= subject.high[:, 2])
    )


def _fits(judge: StateDecider, counts: Mapping[str, int], objects: Sequence[Entity]) -> dict[str, float]:
    """The visible count of each named object against the count asked for, at most 1; too many count too."""
    quantities = {
        subject: predicate.quantity
        for predicate in judge.requirements.predicates.values()
        if predicate.quantity
        for subject in predicate.subjects
    }
    ratios = {}
    for entity in objects:
        least = needed(quantities.get(entity.id), collection=entity.collection)
        most = bearable(quantities.get(entity.id), collection=entity.collection)
        ratios[entity.id] = min(1.0, counts[entity.id] / least, most / max(counts[entity.id], 1))
    return ratios


def _counts(fits: Mapping[str, float]) -> DimensionPart:
    """Mean over the named objects of how far their visible count is the one asked for."""
    short = [key for key, fit in fits.items() if fit < 1]
    return DimensionPart("object_counts", mean(fits.values()) if fits else 0.0, bool(fits), {"short": short})
