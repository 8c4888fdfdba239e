"""Words, decals and clouds. They are kept and saved; the headless renderer draws none of them."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from enum import unique

from c4s.engine.headless.unreal.assets import MaterialInterface
from c4s.engine.headless.unreal.components.scene import SceneComponent
from c4s.engine.headless.unreal.containers import Text
from c4s.engine.headless.unreal.core import EnumBase, Prop, api, public
from c4s.engine.headless.unreal.structs import Color, LinearColor, Vector


@public
@unique
class HorizTextAligment(EnumBase):
    """Where a text begins."""

    EHTA_LEFT = 0
    EHTA_CENTER = 1
    EHTA_RIGHT = 2


@public
@unique
class VerticalTextAligment(EnumBase):
    """Where a text stands."""

    EVRTA_TEXT_TOP = 0
    EVRTA_TEXT_CENTER = 1
    EVRTA_TEXT_BOTTOM = 2
    EVRTA_QUAD_TOP = 3


@public
class TextRenderComponent(SceneComponent):
    """Words in the world; ``world_size`` is the height of a letter in cm."""

    _declares = {
        "text": Prop("Text", lambda: Text("Text")),
        "world_size": Prop("float", 26.0),
        "text_render_color": Prop("Color", lambda: Color(255, 255, 255, 255)),
        "horizontal_alignment": Prop("HorizTextAligment", HorizTextAligment.EHTA_LEFT),
        "vertical_alignment": Prop("VerticalTextAligment", VerticalTextAligment.EVRTA_TEXT_BOTTOM),
        "x_scale": Prop("float", 1.0),
        "y_scale": Prop("float", 1.0),
    }

    @api
    def set_text(self, value: Text | str) -> None:
        """Set the words."""
        self.set_editor_property("text", value)

    @api
    def set_world_size(self, value: float) -> None:
        """Set the height of a letter in cm."""
        self.set_editor_property("world_size", value)

    @api
    def set_text_render_color(self, value: Color) -> None:
        """Set the colour."""
        self.set_editor_property("text_render_color", value)

    @api
    def set_horizontal_alignment(self, value: HorizTextAligment) -> None:
        """Set where the text begins."""
        self.set_editor_property("horizontal_alignment", value)

    @api
    def set_vertical_alignment(self, value: VerticalTextAligment) -> None:
        """Set where the text stands."""
        self.set_editor_property("vertical_alignment", value)


@public
class DecalComponent(SceneComponent):
    """A picture on what lies in its box (half size in cm)."""

    _declares = {
        "decal_size": Prop("Vector", lambda: Vector(128, 256, 256)),
        "decal_material": Prop("MaterialInterface | None", None),
        "decal_color": Prop("LinearColor", lambda: LinearColor(1, 1, 1, 1)),
        "sort_order": Prop("int", 0),
    }

    @api
    def set_decal_material(self, new_decal_material: MaterialInterface | None) -> None:
        """Set the material."""
        self.set_editor_property("decal_material", new_decal_material)

    @api
    def get_decal_material(self) -> MaterialInterface | None:
        """The material."""
        found: MaterialInterface | None = self.get_editor_property("decal_material")
        return found

    @api
    def set_sort_order(self, value: int) -> None:
        """Set which decal lies above others."""
        self.set_editor_property("sort_order", value)


@public
class VolumetricCloudComponent(SceneComponent):
    """Clouds between two heights in km."""

    _declares = {
        "layer_bottom_altitude": Prop("float", 5.0),
        "layer_height": Prop("float", 10.0),
        "planet_radius": Prop("float", 6360.0),
    }

    @api
    def set_layer_bottom_altitude(self, new_value: float) -> None:
        """Set the lower height in km."""
        self.set_editor_property("layer_bottom_altitude", new_value)

    @api
    def set_layer_height(self, new_value: float) -> None:
        """Set the thickness in km."""
        self.set_editor_property("layer_height", new_value)
