"""The actor."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from typing import Any, ClassVar

from c4s.engine.headless.editor import world
from c4s.engine.headless.queries.changes import note
from c4s.engine.headless.unreal.actors.placement import Placed
from c4s.engine.headless.unreal.components import ActorComponent, PrimitiveComponent, SceneComponent, of_class
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Class, Object, Prop, api, deprecated, public
from c4s.engine.headless.unreal.kept import KEPT
from c4s.engine.headless.unreal.structs import Guid, Vector

Parts = tuple[tuple[str, type[SceneComponent]], ...]


@public
class Actor(Placed):
    """Base of everything that is placed in a level."""

    _parts: ClassVar[Parts] = (("DefaultSceneRoot", SceneComponent),)
    """Default components by name; the first is the root."""

    _declares = {
        **KEPT["Actor"],
        "root_component": Prop("SceneComponent | None", get="_get_root", writable=False, saved=False),
        "tags": Prop("Sequence[Name]", lambda: Array._of("Name", []), saved=False),
        "actor_guid": Prop("Guid", get="_get_guid", writable=False, saved=False),
        "hidden": Prop("bool", False, saved=False),
        "actor_enable_collision": Prop("bool", True, attribute=False, scripts=False),
        "is_spatially_loaded": Prop("bool", True, saved=False),
        "custom_time_dilation": Prop("float", 1.0),
        "can_be_damaged": Prop("bool", True),
    }

    def __init__(self, outer: Object | None = None, name: str | Name = "None") -> None:
        super().__init__(outer, name)
        self._outer = None
        self._label = self._name
        world().log.warning(f"{self._name}: an actor made so is in no level; spawn one to have it saved")

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._label = ""
        self._guid = "0" * 32
        self._folder = ""
        self._hidden_ed = False
        self._blueprint: Class | None = None
        self._components: list[ActorComponent] = []
        for part_name, part in type(self)._parts:
            self._add(part, part_name)

    def _add(self, part: type[ActorComponent], name: str) -> Any:
        made = part._make(name, self)
        root = self._get_root()
        self._components.append(made)
        if root is not None and isinstance(made, SceneComponent):
            made._attach(root)
        return made

    def _drop(self, component: ActorComponent) -> None:
        if component is self._components[0]:
            raise Exception(f"{self._name}: the root component cannot be destroyed")
        if isinstance(component, SceneComponent):
            for child in list(component._children):
                child._attach(component._parent)
            component._attach(None)
        self._components = [each for each in self._components if each is not component]
        component._dead = True
        self._changed("components")

    def _changed(self, name: str) -> None:
        note(self)
        world().touch()

    def _placed(self) -> None:
        """A script has put it in a level."""

    def _kill(self) -> None:
        for component in self._components:
            component._dead = True
        self._dead = True

    def _class(self) -> Class:
        return self._blueprint or super()._class()

    def _path(self) -> str:
        if self._outer is None:
            return f"/Engine/Transient.{self._name}"
        return f"{world().map_path()}:PersistentLevel.{self._name}"

    def _get_guid(self) -> Guid:
        return Guid._of(self._guid)

    # identity

    @api
    def get_actor_label(self, create_if_none: bool = True) -> str:
        """What people read; not unique."""
        return str(self._label)

    @api
    def set_actor_label(self, new_actor_label: str, mark_dirty: bool = True) -> None:
        """Set the label."""
        world().relabel(self, str(new_actor_label).strip() or self._label)

    @api
    def rename(self, name: Name | str = "None", outer: Object | None = None) -> bool:
        """Change the object name; False when it is taken or not a name."""
        return world().rename(self, str(name)) if str(name) != "None" else False

    @api
    def get_folder_path(self) -> Name:
        """Folder in the outliner."""
        return Name(self._folder)

    @api
    def set_folder_path(self, new_folder_path: Name | str) -> None:
        """Set the folder in the outliner."""
        text = str(new_folder_path)
        self._folder = "" if text == "None" else text
        self._changed("folder")

    @api
    def actor_has_tag(self, tag: Name | str) -> bool:
        """Whether a tag is set."""
        return Name(str(tag)) in self.get_editor_property("tags")

    @deprecated("'has_tag' was renamed to 'actor_has_tag'.")
    @api
    def has_tag(self, tag: Name | str) -> bool:
        """Whether a tag is set."""
        return self.actor_has_tag(tag)

    @api
    def get_default_actor_label(self) -> str:
        """The label that an actor of this class starts with."""
        return str(self._class().get_name()).removesuffix("_C")

    @api
    def is_editable(self) -> bool:
        """Whether people may edit it."""
        return True

    @api
    def is_selectable(self) -> bool:
        """Whether people may select it."""
        return True

    @api
    def is_actor_being_destroyed(self) -> bool:
        """Whether it is going away (a destroyed actor refuses every call)."""
        return False

    @api
    def is_hidden_ed_at_startup(self) -> bool:
        """Whether the level hides it in the editor."""
        return False

    @api
    def is_hidden_ed(self) -> bool:
        """Whether the editor hides it."""
        return bool(self._hidden_ed)

    @api
    def set_is_temporarily_hidden_in_editor(self, is_hidden: bool) -> None:
        """Hide in the editor, for this session."""
        self._hidden_ed = bool(is_hidden)

    @api
    def is_temporarily_hidden_in_editor(self, include_parent: bool = False) -> bool:
        """Whether it is hidden in the editor for this session."""
        return bool(self._hidden_ed)

    @api
    def set_actor_hidden_in_game(self, new_hidden: bool) -> None:
        """Hide in the game and in pictures."""
        self.set_editor_property("hidden", new_hidden)

    @deprecated("'set_actor_hidden' was renamed to 'set_actor_hidden_in_game'.")
    @api
    def set_actor_hidden(self, new_hidden: bool) -> None:
        """Hide in the game and in pictures."""
        self.set_actor_hidden_in_game(new_hidden)

    @api
    def set_actor_enable_collision(self, new_actor_enable_collision: bool) -> None:
        """Switch the collision of all components."""
        self._values["actor_enable_collision"] = bool(new_actor_enable_collision)
        self._changed("actor_enable_collision")

    @api
    def get_actor_enable_collision(self) -> bool:
        """Whether collision is on."""
        return bool(self._values.get("actor_enable_collision", True))

    @api
    def destroy_actor(self) -> None:
        """Take the actor out of the level."""
        world().destroy(self)

    @api
    def get_level(self) -> Any:
        """The level."""
        return world().map.get_level()

    # components and bounds

    @api
    def get_components_by_class(self, component_class: Class | type | None = None) -> Array:
        """Components of a class; none without one."""
        return Array._of("ActorComponent", self._of_kind(component_class))

    @api
    def get_component_by_class(self, component_class: Class | type | None = None) -> Any:
        """The first component of a class, or None."""
        found = self._of_kind(component_class)
        return found[0] if found else None

    @api
    def find_component_by_tag(self, component_class: Class | type | None = None, tag: Name | str = "None") -> Any:
        """The first component of a class with a tag, or None."""
        found = [c for c in self._of_kind(component_class) if c.component_has_tag(tag)]
        return found[0] if found else None

    @api
    def get_components_by_tag(self, component_class: Class | type | None = None, tag: Name | str = "None") -> Array:
        """Components of a class with a tag."""
        return Array._of("ActorComponent", [c for c in self._of_kind(component_class) if c.component_has_tag(tag)])

    def _of_kind(self, component_class: Class | type | None) -> list[Any]:
        return of_class(self._components, component_class) if component_class is not None else []

    def _bounds(self, only_colliding: bool) -> tuple[tuple[float, ...], tuple[float, ...]]:
        low, high = [float("inf")] * 3, [float("-inf")] * 3
        found = False
        for component in self._components:
            if not isinstance(component, PrimitiveComponent) or (only_colliding and not component._collides()):
                continue
            local = component._local_bounds()
            if local is None:
                continue
            origin, extent = component._world_pose().box(*local)
            found = True
            for i in range(3):
                low[i] = min(low[i], origin[i] - extent[i])
                high[i] = max(high[i], origin[i] + extent[i])
        if not found:
            return self._pose().location, (0.0, 0.0, 0.0)
        return (
            tuple((a + b) / 2 for a, b in zip(low, high, strict=True)),
            tuple((b - a) / 2 for a, b in zip(low, high, strict=True)),
        )

    @api
    def get_actor_bounds(
        self, only_colliding_components: bool, include_from_child_actors: bool = False
    ) -> tuple[Vector, Vector]:
        """World AABB as centre and half extent (cm) over the components that have geometry."""
        origin, extent = self._bounds(bool(only_colliding_components))
        return Vector(*origin), Vector(*extent)


@public
class Info(Actor):
    """An actor without a body."""
