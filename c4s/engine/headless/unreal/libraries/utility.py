"""Objects of scripts of their own: the older base of editor utilities, and the decorators that make classes known."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.asset_tools.operations import rename_loaded_asset
from c4s.engine.headless.unreal.asset_tools.paths import package_of
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.containers.items import initial
from c4s.engine.headless.unreal.core import Object, Prop, api, public
from c4s.engine.headless.unreal.libraries.filters import EditorUtilityLibrary
from c4s.engine.headless.unreal.structs import Vector

_T = TypeVar("_T", bound=type)


@public
class GlobalEditorUtilityBase(Object):
    """What scripts derive from to reach the selection."""

    _class_module = "Blutility"
    _declares = {"help_text": Prop("str", ""), "auto_run_default_action": Prop("bool", False, writable=False)}

    @api
    def get_selection_set(self) -> Array:
        """Selected actors."""
        return EditorUtilityLibrary.get_selection_set()

    @api
    def get_selection_bounds(self) -> tuple[Vector, Vector, float]:
        """World AABB of the selected actors (centre, half extent) and its sphere's radius, in cm."""
        return EditorUtilityLibrary.get_selection_bounds()

    @api
    def get_selected_assets(self) -> Array:
        """There is no content browser to select in."""
        return EditorUtilityLibrary.get_selected_assets()

    @api
    def get_actor_reference(self, path_to_actor: str) -> Actor | None:
        """The actor of a path, or None."""
        return EditorUtilityLibrary.get_actor_reference(path_to_actor)

    @api
    def clear_actor_selection_set(self) -> None:
        """Select no actor."""
        world().selection = []

    @api
    def select_nothing(self) -> None:
        """Select nothing."""
        world().selection = []

    @api
    def set_actor_selection_state(self, actor: Actor, should_be_selected: bool) -> None:
        """Select an actor too, or not any more."""
        others = [each for each in world().selection if each is not actor]
        world().selection = [*others, actor] if should_be_selected else others

    @api
    def rename_asset(self, asset: Object, new_name: str) -> None:
        """Give a created asset another name in its folder."""
        folder = package_of(asset.get_path_name()).rpartition("/")[0]
        rename_loaded_asset(asset, f"{folder}/{new_name}")


class _Declared:
    """A property that a class of a script declares."""

    def __init__(self, kind: str) -> None:
        self.kind = kind


def uclass() -> Callable[[_T], _T]:
    """Make a class that derives from one of Unreal's known: its declared properties become properties."""

    def known(cls: _T) -> _T:
        if not issubclass(cls, Object):
            raise Exception(f"{cls.__name__}: a class must derive from one of Unreal's classes")
        rows = {name: Prop(row.kind, _zero(row.kind)) for name, row in vars(cls).items() if isinstance(row, _Declared)}
        for name in rows:
            delattr(cls, name)
        cls._declares = rows
        cls._declared = cls._properties = {**cls._declared, **rows}
        return cls

    return known


def uproperty(type: Any, meta: Any = None, getter: Any = None, setter: Any = None) -> Any:
    """A property of a class that ``uclass`` makes known: ``name = unreal.uproperty(float)``."""
    plain = type in (bool, int, float, str)
    name = type.__name__ if isinstance(type, _TYPE) else str(type)
    return _Declared(name if plain or not (isinstance(type, _TYPE) and issubclass(type, Object)) else f"{name} | None")


def ufunction(
    meta: Any = None,
    ret: Any = None,
    params: Any = None,
    override: Any = None,
    static: Any = None,
    pure: Any = None,
    getter: Any = None,
    setter: Any = None,
) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Make a method known: a static one is called without an object, any other stays as it is."""

    def known(function: Callable[..., Any]) -> Callable[..., Any]:
        return staticmethod(function) if static else function

    return known


_TYPE = type


def _zero(kind: str) -> Any:
    plain: dict[str, Any] = {"float": 0.0, "int": 0, "bool": False, "str": ""}
    if kind in plain or kind.endswith(" | None"):
        return plain.get(kind)
    return lambda: initial(kind)
