"""A snapshot and what the checks derive from it, each thing once, however many checks ask."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from functools import cached_property
from typing import Any

import numpy as np

from c4s.collision import SceneBodies, gaps_below, scene_bodies
from c4s.geometry.transform import Array
from c4s.protocol.settings import Setting, is_construction
from c4s.records.verdict import Verdict
from c4s.verify.actors.roles import bounds_of, roles
from c4s.verify.physics.support import text_to_scene_support
from c4s.verify.physics.verdict import verify_physics


class MeasuredScene:
    """One state of the level.

    Args:
        setting: the setting whose physics rule counts.
        snapshot: the level as the engine exported it; nobody changes it.
    """

    def __init__(self, setting: Setting, snapshot: Mapping[str, Any]) -> None:
        self.setting, self.snapshot = setting, snapshot
        self.actors: list[Mapping[str, Any]] = snapshot["actors"]

    @cached_property
    def bodies(self) -> SceneBodies:
        """All collision bodies."""
        return scene_bodies(self.snapshot)

    @cached_property
    def whole_physics(self) -> Verdict:
        """The physics verdict over all actors, each as if it were the only edit: the input scene is not at hand."""
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
        leaf = self.whole_physics.measurements["leaf_results"][0]
        return frozenset(leaf["floating_actors"])

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
