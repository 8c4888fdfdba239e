"""What a component's collision is: profile, object type, answers to channels, and what its own moves ignore."""

from __future__ import annotations

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)
from typing import Any

from c4s.engine.headless.editor import world
from c4s.engine.headless.queries.channels import BLOCK_ALL, Channel, Profile, profile
from c4s.engine.headless.unreal.components.scene import SceneComponent
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Object, Prop, api
from c4s.engine.headless.unreal.enums import CollisionEnabled
from c4s.engine.headless.unreal.hits.enums import CollisionChannel, CollisionResponseType

CUSTOM = "Custom"
_QUERIED = (CollisionEnabled.QUERY_ONLY, CollisionEnabled.QUERY_AND_PHYSICS, CollisionEnabled.QUERY_AND_PROBE)
_SIMULATED = (CollisionEnabled.PHYSICS_ONLY, CollisionEnabled.QUERY_AND_PHYSICS)


class CollisionState(SceneComponent):
    """The collision settings of a component. A profile decides until a script sets one of them by hand."""

    _declares = {
        "collision_enabled": Prop(
            "CollisionEnabled", CollisionEnabled.QUERY_AND_PHYSICS, attribute=False, scripts=False
        ),
        "collision_profile_name": Prop("Name", Name("BlockAllDynamic"), attribute=False, scripts=False),
        "collision_object_type": Prop("int", -1, attribute=False, scripts=False),
        "collision_responses": Prop("Sequence[int]", lambda: Array._of("int", []), attribute=False, scripts=False),
    }

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._move_ignores: dict[Any, None] = {}

    def _own(self, name: str) -> Any:
        """Value of a property that scripts reach by methods only."""
        return self._read(name, type(self)._properties[name])

    def _put(self, name: str, value: Any) -> None:
        """Set a property that scripts reach by methods only."""
        self._write(name, type(self)._properties[name], value)

    def _collides(self) -> bool:
        owner = self._outer
        if owner is not None and not owner._values.get("actor_enable_collision", True):
            return False
        return bool(self._own("collision_enabled") is not CollisionEnabled.NO_COLLISION)

    def _queries(self) -> bool:
        """Whether traces and overlaps can meet it."""
        return self._collides() and self._own("collision_enabled") in _QUERIED

    def _profile_name(self) -> str:
        """The profile that was set, else that of its kind: the mesh of a static mesh actor blocks as static."""
        owner: Any = self._outer
        if (
            "collision_profile_name" not in self._values
            and type(owner).__name__ == "StaticMeshActor"
            and owner._blueprint is None
            and owner._components[0] is self
        ):
            return "BlockAll"
        return str(self._own("collision_profile_name"))

    def _profile(self) -> Profile:
        return profile(self._profile_name()) or BLOCK_ALL

    def _channel(self) -> Channel:
        """Its object type."""
        own = int(self._own("collision_object_type"))
        return Channel(own) if own >= 0 else self._profile().channel

    def _answers(self, channel: Channel) -> int:
        """Its answer to a channel: 0 ignore, 1 overlap, 2 block."""
        own = self._own("collision_responses")
        return int(own[channel]) if len(own) else int(self._profile().response(channel))

    def _customise(self) -> None:
        """Write down what the profile decided, and have none from now on."""
        kind, answers = self._channel(), [self._answers(channel) for channel in Channel]
        self._put("collision_object_type", int(kind))
        self._put("collision_responses", answers)
        self._put("collision_profile_name", CUSTOM)

    @api
    def get_collision_enabled(self) -> CollisionEnabled:
        """What the collision takes part in."""
        found: CollisionEnabled = self._own("collision_enabled")
        return found if self._collides() else CollisionEnabled.NO_COLLISION

    @api
    def set_collision_enabled(self, new_type: CollisionEnabled) -> None:
        """Set what the collision takes part in; from then on it has a custom profile, as in Unreal."""
        if self._own("collision_enabled") is not new_type:
            self._customise()
            self._put("collision_enabled", new_type)

    @api
    def is_collision_enabled(self) -> bool:
        """Whether there is any collision."""
        return self._collides()

    @api
    def is_query_collision_enabled(self) -> bool:
        """Whether traces and overlaps can meet it."""
        return self._queries()

    @api
    def is_physics_collision_enabled(self) -> bool:
        """Whether simulated bodies would meet it."""
        return self._collides() and self._own("collision_enabled") in _SIMULATED

    @api
    def get_collision_profile_name(self) -> Name:
        """Name of the collision profile."""
        return Name(self._profile_name())

    @api
    def set_collision_profile_name(self, collision_profile_name: Name | str, update_overlaps: bool = True) -> None:
        """Set the profile: object type, answers and what the collision takes part in."""
        name = str(collision_profile_name)
        found = profile(name)
        if found is None:
            world().log.warning(f"COLLISION PROFILE [{name}] is not found")
            self._customise()
            return
        self._put("collision_profile_name", name)
        self._put("collision_enabled", CollisionEnabled[found.enabled])
        self._values.pop("collision_object_type", None)
        self._values.pop("collision_responses", None)

    @api
    def get_collision_object_type(self) -> CollisionChannel:
        """Its object type."""
        return CollisionChannel(int(self._channel()))

    @api
    def set_collision_object_type(self, channel: CollisionChannel) -> None:
        """Set its object type."""
        self._customise()
        self._put("collision_object_type", int(channel.value))

    @api
    def get_collision_response_to_channel(self, channel: CollisionChannel) -> CollisionResponseType:
        """Its answer to a channel."""
        return CollisionResponseType(self._answers(Channel(channel.value)))

    @api
    def set_collision_response_to_channel(self, channel: CollisionChannel, new_response: CollisionResponseType) -> None:
        """Set its answer to a channel."""
        self._customise()
        answers = [int(answer) for answer in self._own("collision_responses")]
        answers[channel.value] = new_response.value
        self._put("collision_responses", answers)

    @api
    def set_collision_response_to_all_channels(self, new_response: CollisionResponseType) -> None:
        """Set its answer to all channels."""
        self._customise()
        self._put("collision_responses", [new_response.value] * len(Channel))

    # what its swept moves pass through

    def _ignore(self, thing: Any, should_ignore: bool) -> None:
        if thing is not None and should_ignore:
            self._move_ignores[thing] = None
        else:
            self._move_ignores.pop(thing, None)

    def _ignored(self, actors: bool) -> list[Any]:
        return [thing for thing in self._move_ignores if hasattr(thing, "_components") is actors and not thing._dead]

    @api
    def copy_array_of_move_ignore_components(self) -> Array:
        """The components that its swept moves pass through."""
        return Array._of("PrimitiveComponent", self._ignored(False))

    @api
    def copy_array_of_move_ignore_actors(self) -> Array:
        """The actors that its swept moves pass through."""
        return Array._of("Actor", self._ignored(True))

    @api
    def get_move_ignore_actors(self) -> Array:
        """The actors that its swept moves pass through."""
        return Array._of("Actor", self._ignored(True))

    @api
    def clear_move_ignore_components(self) -> None:
        """Pass through no component any more."""
        for thing in self._ignored(False):
            self._move_ignores.pop(thing)

    @api
    def clear_move_ignore_actors(self) -> None:
        """Pass through no actor any more."""
        for thing in self._ignored(True):
            self._move_ignores.pop(thing)
