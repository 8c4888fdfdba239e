"""The rule judge's overview dimensions. Each is a mean of named parts; what cannot be decided is worth 0."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from c4s.geometry.transform import WORLD_CM
from c4s.judge.rule.judge import RuleJudge
from c4s.protocol.bundle import Entity
from c4s.protocol.numbers import mean
from c4s.semantics.boxes import Boxes, Flags, holds_to_any
from c4s.semantics.inventory import Thing
from c4s.semantics.quantities import needed
from c4s.semantics.views import Views

STYLE_TYPES = frozenset({"attribute", "material", "style_bundle", "environment", "atmosphere", "scene_identity"})
SPATIAL_TYPES = frozenset({"spatial_relation", "distribution", "composition", "boundary"})
STRETCH = 4.0
"""A thing is stretched out of shape when its largest scale factor exceeds its smallest by more than this factor."""
FLAT_CM = 0.1
"""A thing is flattened when two of its sides are not longer than this."""
BURIED = 0.5
LIKE_SIZE = 8.0
"""A thing is swallowed when another's box, of up to 8 times its volume, holds more than half of its own box.
What is much larger is a room or a yard that things may stand in."""
GRID = 4
"""Occupancy is counted over a grid of this many cells a side."""


@dataclass(frozen=True)
class DimensionPart:
    """One part of a dimension: its value in [0, 1] (0 when unknown) and what it rests on."""

    name: str
    value: float
    known: bool
    detail: dict[str, Any]


def dimensions(judge: RuleJudge, views: Views) -> dict[str, list[DimensionPart]]:
    """The parts of the four prompt dimensions, by dimension name."""
    seen = views.seen(judge.things)
    objects = [entity for entity in judge.requirements.entities.values() if entity.is_object]
    counts = _seen_counts(judge, seen, objects)
    return {
        "global_prompt_alignment": [_named_objects(counts)],
        "composition_and_layout": [
            _requirements("spatial_requirements", judge, SPATIAL_TYPES, bool(seen)),
            _occupancy(seen),
            _unswallowed(seen),
        ],
        "style_atmosphere_coherence": [_requirements("style_requirements", judge, STYLE_TYPES, bool(seen))],
        "completeness_and_polish": [_counts(judge, counts, objects), _visible(judge.things, seen)],
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


def _seen_counts(judge: RuleJudge, seen: Sequence[Thing], objects: Sequence[Entity]) -> dict[str, int]:
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


def _named_objects(counts: Mapping[str, int]) -> DimensionPart:
    """Share of the prompt's named objects of which at least one is placed and clearly visible."""
    return DimensionPart(
        "visible_named_objects",
        sum(count > 0 for count in counts.values()) / len(counts) if counts else 0.0,
        bool(counts),
        {"objects": len(counts), "missing": [key for key, count in counts.items() if not count]},
    )


def _requirements(name: str, judge: RuleJudge, types: frozenset[str], anything: bool) -> DimensionPart:
    """Mean decision score of the bundle's requirements of some types; unknown ones count 0."""
    nodes = [node for node in judge.requirements.scored if judge.requirements.predicates[node].type in types]
    decisions = [judge.decide(node) for node in nodes]
    value = mean(d.score for d in decisions) if nodes and anything else 0.0
    return DimensionPart(
        name,
        value,
        any(d.status != "UNKNOWN" for d in decisions),
        {"requirements": len(nodes), "unknown": sum(d.status == "UNKNOWN" for d in decisions)},
    )


def _occupancy(things: Sequence[Thing]) -> DimensionPart:
    """How evenly things fill their common plan: the entropy of their cells, against the most they could fill."""
    if len(things) < 2:
        return DimensionPart("plan_occupancy", 0.0, bool(things), {"things": len(things)})
    points = np.array([thing.centre[:2] for thing in things])
    span = np.maximum(np.ptp(points, axis=0), 1.0)
    cells = np.minimum(((points - points.min(axis=0)) / span.max() * GRID).astype(int), GRID - 1)
    shares = np.unique(cells, axis=0, return_counts=True)[1] / len(things)
    most = math.log(min(len(things), GRID * GRID))
    return DimensionPart("plan_occupancy", float(-(shares * np.log(shares)).sum() / most), True, {"cells": len(shares)})


def _unswallowed(things: Sequence[Thing]) -> DimensionPart:
    """Share of things of which no other thing of like size (up to 8 times its volume) holds more than half."""
    if not things:
        return DimensionPart("unswallowed", 0.0, False, {"things": 0})
    buried = holds_to_any(things, things, _is_swallowed)
    swallowed = [things[place].actor for place in np.flatnonzero(buried).tolist()]
    return DimensionPart("unswallowed", 1 - len(swallowed) / len(things), True, {"swallowed": swallowed[:50]})


def _is_swallowed(subject: Boxes, least: Boxes, most: Boxes) -> Flags:
    """Whether another actor's box of like size holds more than half of the subject's."""
    common = np.maximum(np.minimum(most.high, subject.high) - np.maximum(least.low, subject.low), 0.0)
    return np.asarray(
        (most.volume >= subject.volume)
        & (least.volume <= LIKE_SIZE * subject.volume)
        & ((least.owner < subject.owner) | (most.owner > subject.owner))
        & (common[:, 0] * common[:, 1] * common[:, 2] > BURIED * subject.volume)
    )


def _counts(judge: RuleJudge, counts: Mapping[str, int], objects: Sequence[Entity]) -> DimensionPart:
    """Mean over the named objects of visible count / needed count, at most 1 each."""
    quantities = {
        subject: predicate.quantity
        for predicate in judge.requirements.predicates.values()
        if predicate.quantity
        for subject in predicate.subjects
    }
    ratios = {}
    for entity in objects:
        ratios[entity.id] = min(
            1.0, counts[entity.id] / needed(quantities.get(entity.id), collection=entity.collection)
        )
    return DimensionPart(
        "object_counts",
        mean(ratios.values()) if ratios else 0.0,
        bool(ratios),
        {"short": [key for key, ratio in ratios.items() if ratio < 1]},
    )


def _visible(things: Sequence[Thing], seen: Sequence[Thing]) -> DimensionPart:
    """Share of the placed things that are clearly visible in a view."""
    return DimensionPart(
        "visible_things",
        len(seen) / len(things) if things else 0.0,
        bool(things),
        {"things": len(things), "seen": len(seen)},
    )
