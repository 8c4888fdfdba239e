"""Actors that show meshes."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from c4s.engine.headless.unreal.actors.base import Actor
from c4s.engine.headless.unreal.components import StaticMeshComponent
from c4s.engine.headless.unreal.core import Prop, api, public
from c4s.engine.headless.unreal.enums import ComponentMobility


@public
class StaticMeshActor(Actor):
    """An actor that shows one mesh."""

    _parts = (("StaticMeshComponent0", StaticMeshComponent),)
    _declares = {"static_mesh_component": Prop("StaticMeshComponent", get="_get_root", writable=False, saved=False)}

    @api
    def set_mobility(self, mobility: ComponentMobility) -> None:
        """Set whether it may move in play."""
        self._root().set_mobility(mobility)
