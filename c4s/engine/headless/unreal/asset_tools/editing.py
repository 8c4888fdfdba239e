"""Blueprints as their editor sees them: those of packs, which are read-only."""

from __future__ import annotations

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.asset_tools.factories import NO_BLUEPRINTS
from c4s.engine.headless.unreal.assets import Blueprint
from c4s.engine.headless.unreal.core import Class, Object, api, public
from c4s.engine.headless.version import ENGINE_VERSION


def _blueprint_of(found: Class) -> Blueprint | None:
    made: Blueprint | None = world().find(found._blueprint) if found._blueprint else None
    return made


@public
class BlueprintEditorLibrary(Object):
    """Reading Blueprints. None is made or changed here."""

    _class_module = "BlueprintEditorLibrary"

    @classmethod
    @api
    def generated_class(cls, blueprint_obj: Blueprint) -> Class:
        """The class whose actors a Blueprint makes."""
        return blueprint_obj.generated_class()

    @classmethod
    @api
    def get_blueprint_asset(cls, object: Object) -> Blueprint | None:
        """The Blueprint that an object is, or that it is made by; None for any other."""
        return object if isinstance(object, Blueprint) else _blueprint_of(object.get_class())

    @classmethod
    @api
    def get_blueprint_for_class(cls, class_: Class | type) -> tuple[Blueprint | None, bool]:
        """The Blueprint of a class, and whether there is one."""
        found = _blueprint_of(class_) if isinstance(class_, Class) else None
        return found, found is not None

    @classmethod
    @api
    def compile_blueprint(cls, blueprint: Blueprint) -> None:
        """Those of packs are compiled."""

    @classmethod
    @api
    def get_current_engine_version(cls) -> str:
        """Version of the engine."""
        return ENGINE_VERSION

    @classmethod
    @api
    def create_blueprint_asset_with_parent(cls, asset_path: str, parent_class: Class | type) -> Blueprint | None:
        """None: no Blueprints are made here."""
        world().log.error(f"CreateBlueprintAssetWithParent: '{asset_path}': {NO_BLUEPRINTS}")
        return None
