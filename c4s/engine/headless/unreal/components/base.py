"""What all components have."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from typing import Any

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Class, Object, Prop, api, public

ABSTRACT_COMPONENTS = frozenset(
    {
        "ActorComponent",
        "LightComponent",
        "LightComponentBase",
        "LocalLightComponent",
        "MeshComponent",
        "PrimitiveComponent",
        "SceneCaptureComponent",
        "ShapeComponent",
    }
)
"""Component classes that no actor can have: they are there for what is derived from them."""


@public
class ActorComponent(Object):
    """Base of components."""

    _declares = {
        "component_tags": Prop("Sequence[Name]", lambda: Array._of("Name", [])),
        "is_editor_only": Prop("bool", False),
    }

    def __init__(self, outer: Object | None = None, name: str | Name = "None") -> None:
        super().__init__(outer, name)
        owner = outer._name if outer is not None else "no actor"
        world().log.warning(
            f"{self._name}: a component made so is no part of {owner} and is not saved; SubobjectDataSubsystem adds one"
        )

    @classmethod
    def _abstract(cls) -> bool:
        return cls.__name__ in ABSTRACT_COMPONENTS

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._by_script = False

    @api
    def get_owner(self) -> Any:
        """The actor."""
        return self._outer

    @api
    def component_has_tag(self, tag: Name | str) -> bool:
        """Whether a component tag is set."""
        return Name(str(tag)) in self.get_editor_property("component_tags")

    def _changed(self, name: str) -> None:
        owner = self._outer
        if owner is not None:
            owner._changed(name)

    @api
    def destroy_component(self, object: Object | None) -> None:
        """Remove this component from its actor."""
        owner = self._outer
        if owner is not None:
            owner._drop(self)


def of_class(components: list[Any], wanted: Class | type) -> list[Any]:
    """Those components that are of a class."""
    kind = _python_type(wanted)
    return [c for c in components if isinstance(c, kind)]


def _python_type(wanted: Class | type) -> type[Object]:
    found: type[Object] = wanted._python_type if isinstance(wanted, Class) else wanted
    return found
