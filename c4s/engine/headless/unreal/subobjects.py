"""SubobjectDataSubsystem: adding components to placed actors, and taking them away."""

from __future__ import annotations

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)
from collections.abc import Sequence
from typing import Any

from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.components import ABSTRACT_COMPONENTS, ActorComponent, SceneComponent
from c4s.engine.headless.unreal.containers import Array, Text
from c4s.engine.headless.unreal.core import Object, Prop, api, as_class, public
from c4s.engine.headless.unreal.structs import ClosedStruct, StructBase


@public
class SubobjectDataHandle(ClosedStruct):
    """Stands for an actor or one of its components."""

    _fields = {"target": Prop("Object | None", None, attribute=False, scripts=False)}
    _takes = 0

    def copy(self) -> Any:
        """A copy."""
        made = SubobjectDataHandle.__new__(SubobjectDataHandle)
        made.__dict__.update(self.__dict__)
        return made

    def to_tuple(self) -> tuple[Any, ...]:
        """Nothing is shown."""
        return (id(self.__dict__["target"]),)

    def __repr__(self) -> str:
        return "<Struct 'SubobjectDataHandle' {}>"


@public
class SubobjectData(ClosedStruct):
    """What a handle stands for."""

    _fields = {"handle": Prop("SubobjectDataHandle", SubobjectDataHandle, attribute=False, scripts=False)}
    _takes = 0


@public
class AddNewSubobjectParams(StructBase):
    """What to add, and under what."""

    _fields = {
        "parent_handle": Prop("SubobjectDataHandle", SubobjectDataHandle),
        "new_class": Prop("Class | None", None),
        "blueprint_context": Prop("Object | None", None),
        "skip_mark_blueprint_modified": Prop("bool", False),
        "conform_transform_to_parent": Prop("bool", True),
    }


def handle_of(target: Object) -> SubobjectDataHandle:
    """A handle."""
    made: SubobjectDataHandle = SubobjectDataHandle._of_fields(target)
    return made


def _data(handle: SubobjectDataHandle) -> SubobjectData:
    made: SubobjectData = SubobjectData._of_fields(handle)
    return made


def target_of(handle: SubobjectDataHandle) -> Object | None:
    """What a handle stands for."""
    found: Object | None = handle.__dict__["target"]
    return found


@public
class SubobjectDataSubsystem(Object):
    """Components of placed actors."""

    _class_module = "SubobjectDataInterface"

    @api
    def k2_gather_subobject_data_for_instance(self, context: Actor) -> Array:
        """Handles of an actor and its components, the actor first."""
        return Array._of("SubobjectDataHandle", [handle_of(o) for o in (context, *context._components)])

    @api
    def k2_find_subobject_data_from_handle(self, handle: SubobjectDataHandle) -> SubobjectData | None:
        """What a handle stands for, or None."""
        return _data(handle) if target_of(handle) is not None else None

    @api
    def add_new_subobject(self, params: AddNewSubobjectParams) -> tuple[SubobjectDataHandle, Text]:
        """Add a component; the handle is empty, and the text says why, when that is refused."""
        fields: Any = params
        parent = target_of(fields.parent_handle)
        wanted = as_class(fields.new_class) if fields.new_class is not None else None
        if parent is None or wanted is None or not issubclass(wanted._python_type, ActorComponent):
            return SubobjectDataHandle(), Text("a parent and a component class are needed")
        if wanted._python_type._absent:
            return SubobjectDataHandle(), Text(f"the headless engine has no components of class {wanted._path()}")
        if wanted._python_type.__name__ in ABSTRACT_COMPONENTS:
            return SubobjectDataHandle(), Text(f"{wanted._path()} is abstract")
        actor: Any = parent if isinstance(parent, Actor) else parent._outer
        stem = wanted._python_type.__name__.removesuffix("Component")
        taken, serial, name = {c._name for c in actor._components}, 1, stem
        while name in taken:
            name, serial = f"{stem}{serial}", serial + 1
        made = actor._add(wanted._python_type, name)
        made._by_script = True
        if isinstance(parent, SceneComponent) and isinstance(made, SceneComponent):
            made._attach(parent)
        actor._changed("components")
        return handle_of(made), Text()

    @api
    def k2_delete_subobjects_from_instance(
        self, context_handle: SubobjectDataHandle, subobjects_to_delete: Sequence[SubobjectDataHandle]
    ) -> int:
        """Take components away; returns how many."""
        gone = [t for t in map(target_of, subobjects_to_delete) if isinstance(t, ActorComponent)]
        for component in gone:
            component.destroy_component(None)
        return len(gone)


@public
class SubobjectDataBlueprintFunctionLibrary(Object):
    """Access to what handles stand for."""

    _class_module = "SubobjectDataInterface"

    @classmethod
    @api
    def get_data(cls, data_handle: SubobjectDataHandle) -> SubobjectData:
        """The data of a handle."""
        return _data(data_handle)

    @classmethod
    @api
    def get_object(cls, data: SubobjectData, even_if_pending_kill: bool = False) -> Any:
        """The actor or component."""
        return target_of(data.__dict__["handle"])

    @classmethod
    @api
    def get_associated_object(cls, data: SubobjectData) -> Any:
        """The actor or component."""
        return target_of(data.__dict__["handle"])

    @classmethod
    @api
    def is_handle_valid(cls, data_handle: SubobjectDataHandle) -> bool:
        """Whether a handle stands for anything."""
        return target_of(data_handle) is not None
