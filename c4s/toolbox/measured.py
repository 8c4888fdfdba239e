"""A snapshot and what the checks derive from it, each thing once, however many checks ask."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from c4s.collision import SceneBodies, gaps_below, scene_bodies
from c4s.errors import BadInput
from c4s.geometry.transform import Array
from c4s.protocol.settings import Setting, is_construction
from c4s.records.verdict import Verdict
from c4s.verify.actors.roles import bounds_of, roles
from c4s.verify.physics.edited import edited_actors
from c4s.verify.physics.support import text_to_scene_support
from c4s.verify.physics.verdict import measure_support, verify_physics

NEAR_CM = 20.0
"""Boxes that are no further apart than this may hold each other."""


class MeasuredScene:
    """One state of the level.

    Args:
        setting: the setting whose physics rule counts.
        snapshot: the level as the engine exported it; nobody changes it.
        start: the level as it was given, in a repair.
    """

    def __init__(self, setting: Setting, snapshot: Mapping[str, Any], start: MeasuredScene | None = None) -> None:
        self.setting, self.snapshot, self.start = setting, snapshot, start
        self.actors: list[Mapping[str, Any]] = snapshot["actors"]

    @cached_property
    def changed(self) -> frozenset[int]:
        """Positions of the actors that are not as the start had them; all of them where that cannot be told."""
        if self.start is None:
            return frozenset(range(len(self.actors)))
        try:
            return frozenset(edited_actors(self.snapshot, self.start.snapshot))
        except BadInput:
            return frozenset(range(len(self.actors)))

    @property
    def removed(self) -> int:
        """How many actors of the start are gone."""
        return 0 if self.start is None else len(self.start.named.keys() - self.named.keys())

    @cached_property
    def positions(self) -> dict[str, int]:
        """Where each actor stands in the snapshot, by its object name."""
        return {str(actor.get("name")): index for index, actor in enumerate(self.actors)}

    def before(self, index: int) -> int | None:
        """Where the start has an actor that was not changed since."""
        if self.start is None or index in self.changed:
            return None
        return self.start.positions.get(str(self.actors[index].get("name")))

    @cached_property
    def physics(self) -> Verdict:
        """The verdict over the actors that the score counts: in a repair those that were changed."""
        if self.start is None:
            return self.whole_physics
        return verify_physics(self.setting, self.snapshot, self.start.snapshot, alone=True)

    @cached_property
    def bodies(self) -> SceneBodies:
        """All collision bodies."""
        return scene_bodies(self.snapshot)

    @cached_property
    def whole_physics(self) -> Verdict:
        """The physics verdict over all actors, each as if it were the only edit."""
        return verify_physics(self.setting, self.snapshot, {"actors": []}, alone=True)

    @cached_property
    def extent_cm(self) -> tuple[Array, Array] | None:
        """Lowest and highest corner of what is solid; None when nothing is."""
        boxes = [
            box
            for actor, role in zip(self.actors, roles(self.actors), strict=True)
            if role != "non_solid" and (box := bounds_of(actor)) is not None
        ]
        if not boxes:
            return None
        centres, halves = (np.array(column) for column in zip(*boxes, strict=True))
        return (centres - halves).min(axis=0), (centres + halves).max(axis=0)

    @cached_property
    def all_gaps_cm(self) -> dict[int, float | None]:
        """``gaps_below`` of every actor."""
        return self.gaps_cm(range(len(self.actors)))

    def gaps_cm(self, actors: Collection[int]) -> dict[int, float | None]:
        """``gaps_below`` of some actors (positions); text-to-scene has the ground plane besides."""
        return gaps_below(self.snapshot, self.bodies, set(actors), ground_plane=is_construction(self.setting))

    @cached_property
    def scored_as_floating(self) -> frozenset[str]:
        """Object names of the actors that the verdict counts as floating."""
        if is_construction(self.setting) and "whole_physics" not in self.__dict__:
            return self._floating_boxes()
        return floating_of(self.physics)

    @cached_property
    def unsettled(self) -> list[str]:
        """Object names of actors that were not changed and stood at the start, but float now: near to what was moved
        or taken away."""
        start = self.start
        if start is None:
            return []
        gone = [actor for name, actor in start.named.items() if self.positions.get(name, -1) not in self.same]
        same = [self.actors[index] for index in sorted(self.same)]
        beside = {str(same[position].get("name")) for position in _beside(same, gone)}
        return sorted(self._floating_among(beside) - start._floating_among(beside)) if beside else []

    @cached_property
    def same(self) -> frozenset[int]:
        """Positions of the actors that are as the start had them."""
        return frozenset(range(len(self.actors))) - self.changed

    @cached_property
    def named(self) -> dict[str, Mapping[str, Any]]:
        """The actors by their object names."""
        return {name: self.actors[index] for name, index in self.positions.items()}

    def _floating_among(self, names: Collection[str]) -> set[str]:
        """Which of these actors float by the rule of repairs, each as if it were the only edit."""
        others = [actor for name, actor in self.named.items() if name not in names]
        rows = measure_support(self.setting, self.snapshot, {"actors": others}, alone=True)["rows"]
        return {row["actor"] for row in rows if row["state"] == "floating"}

    def _floating_boxes(self) -> frozenset[str]:
        """The same by the rule of text-to-scene alone, which asks for nothing else of the verdict."""
        try:
            states = text_to_scene_support(self.snapshot).per_actor
        except ValueError:
            return frozenset()
        return frozenset(
            str(actor.get("name") or actor.get("label"))
            for actor, state in zip(self.actors, states, strict=True)
            if state == "floating"
        )


def floating_of(verdict: Verdict) -> frozenset[str]:
    """Object names of the actors that a verdict counts as floating."""
    return frozenset(verdict.measurements["leaf_results"][0]["floating_actors"])


def _beside(actors: Sequence[Mapping[str, Any]], others: Sequence[Mapping[str, Any]]) -> list[int]:
    """Positions of the actors whose box lies at one of the others'."""
    boxes = [box for box in map(bounds_of, others) if box is not None]
    if not boxes:
        return []
    middles, halves = (np.array(column) for column in zip(*boxes, strict=True))
    return [
        position
        for position, box in enumerate(map(bounds_of, actors))
        if box is not None and (np.abs(middles - box[0]) <= halves + box[1] + NEAR_CM).all(axis=1).any()
    ]
