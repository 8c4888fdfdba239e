"""What the two physics leaves look at in a candidate scene: its population, roles and bodies, each found once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any, TypeAlias

from c4s.collision import SceneBodies, scene_bodies
from c4s.errors import BadInput
from c4s.protocol.settings import Setting, is_construction
from c4s.verify.actors.roles import Role, roles
from c4s.verify.physics.edited import CANDIDATE, edit_order

Actors: TypeAlias = Sequence[Mapping[str, Any]]


class PhysicsScene:
    """A candidate scene under one setting.

    Args:
        setting: ``text-to-scene`` (all actors), or an image-to-scene setting (actors that differ from the start).
        snapshot: the candidate scene.
        start: the start scene; needed by image-to-scene.

    Raises ``BadInput`` for a scene without an actor list, and for image-to-scene without a start scene.
    """

    def __init__(self, setting: Setting, snapshot: Mapping[str, Any], start: Mapping[str, Any] | None) -> None:
        self.setting, self.snapshot = setting, snapshot
        self.actors: Actors = _actors_of(snapshot, "snapshot")
        self.whole = is_construction(setting)
        self.order: list[int] = list(range(len(self.actors)))
        """Positions of the population, in the order in which it is measured."""
        self.fault = ""
        """Why the population is not known; then it is empty."""
        if not self.whole:
            if start is None:
                raise BadInput("the physics of a repair needs the input snapshot", where=setting)
            _actors_of(start, "input snapshot")
            try:
                self.order = edit_order(snapshot, start)
            except BadInput as error:
                if error.where != CANDIDATE:
                    raise
                self.order, self.fault = [], error.line()
        self.chosen = sorted(self.order)
        """The population, in scene order."""

    @cached_property
    def role(self) -> list[Role]:
        """The role of every actor."""
        return roles(self.actors)

    @cached_property
    def bodies(self) -> SceneBodies:
        """All collision bodies."""
        return scene_bodies(self.snapshot)


def _actors_of(snapshot: Mapping[str, Any], what: str) -> list[Mapping[str, Any]]:
    actors = snapshot.get("actors")
    if not isinstance(actors, list) or not all(isinstance(actor, Mapping) for actor in actors):
        raise BadInput(f"the {what} has no list of actors", todo="export the scene again")
    return actors


def actor_name(actor: Mapping[str, Any]) -> str:
    """The object name of an actor, else its label."""
    return str(actor.get("name") or actor.get("label"))
