"""Points, notes, words, decals and clouds."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from c4s.engine.headless.unreal.actors.base import Actor, Info
from c4s.engine.headless.unreal.assets import MaterialInterface
from c4s.engine.headless.unreal.components.markers import DecalComponent, TextRenderComponent, VolumetricCloudComponent
from c4s.engine.headless.unreal.core import Prop, api, public


@public
class TargetPoint(Actor):
    """A place."""


@public
class Note(Actor):
    """A remark."""

    _declares = {"text": Prop("str", "")}


@public
class TextRenderActor(Actor):
    """Words in the world."""

    _parts = (("NewTextRenderComponent", TextRenderComponent),)
    _declares = {"text_render": Prop("TextRenderComponent", get="_get_root", writable=False, saved=False)}


@public
class DecalActor(Actor):
    """A picture on what lies in its box."""

    _parts = (("NewDecalComponent", DecalComponent),)
    _declares = {"decal": Prop("DecalComponent", get="_get_root", writable=False, saved=False)}

    @api
    def set_decal_material(self, new_decal_material: MaterialInterface | None) -> None:
        """Set the material."""
        self._root().set_editor_property("decal_material", new_decal_material)

    @api
    def get_decal_material(self) -> MaterialInterface | None:
        """The material."""
        found: MaterialInterface | None = self._root().get_editor_property("decal_material")
        return found


@public
class VolumetricCloud(Info):
    """Clouds."""

    _parts = (("VolumetricCloudComponent", VolumetricCloudComponent),)
    _declares = {
        "volumetric_cloud_component": Prop(
            "VolumetricCloudComponent", get="_get_root", writable=False, attribute=True, saved=False
        )
    }
