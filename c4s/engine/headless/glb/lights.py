"""Lights and cameras of the open level as glTF has them (``KHR_lights_punctual``).

Both look along -Z there and along +X in Unreal. A rectangle light becomes a spot as wide as a half space, which is the
nearest that glTF has. Sky lights have no counterpart.

**Units.** Suns are in lux, local lights in candela, in both. But people light levels by eye: with automatic exposure a
clear day is a sun of 3 to 10 "lux", while a real noon has 100,000, and a program without automatic exposure takes such
a file for night. So where no sun of a level is as bright as a real overcast day, its numbers are taken for radiometric
ones (W/m2 of a sun, W/sr of a lamp) and written as the light that they are at 683 lm/W, which Blender divides by when
it reads a file and multiplies by when it writes one. The proportions of all lights stay. The factor stands in
``asset.extras`` as ``light_factor``; ``c4s suite import-scene`` divides by it.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from c4s.engine.headless.glb.nodes import Leaf, NodeTree
from c4s.engine.headless.pictures.lights import candela_of, light_colour
from c4s.engine.headless.unreal.lights import CameraComponent

if TYPE_CHECKING:
    from c4s.engine.headless.unreal.actors import Actor
    from c4s.engine.headless.world.world import LightSource, World

EXTENSION = "KHR_lights_punctual"
LIGHT_FACTOR = "light_factor"
"""Key in ``asset.extras``."""
_LUMENS_PER_WATT = 683.0
"""Of glTF's and Blender's conversion between photometric and radiometric units (green light of 555 nm)."""
_DAYLIGHT_LUX = 1000.0
"""An overcast day: a sun from here on is in real lux."""
_KINDS = {
    "DirectionalLightComponent": "directional",
    "PointLightComponent": "point",
    "SpotLightComponent": "spot",
    "RectLightComponent": "spot",
}
_TURN = (0.0, -math.sqrt(0.5), 0.0, math.sqrt(0.5))
"""Turns -Z towards +X about Y."""
_NEAR_M = 0.01
_LEAST_CONE_STEP = 1e-4
_METRE_CM = 100.0

Json = dict[str, Any]


class LightsAndCameras:
    """The records of a level's lights and cameras; their nodes are added to a tree."""

    def __init__(self, world: World, tree: NodeTree) -> None:
        self.lights: list[Json] = []
        self.cameras: list[Json] = []
        self.left_out: list[str] = []
        """Labels of lights that glTF cannot hold."""
        self._tree = tree
        sources = list(world.light_sources())
        self.factor = factor_of(sources)
        """Written intensities are so many times the level's own."""
        for source in sources:
            if source.kind in _KINDS:
                self._add_light(source)
            elif source.kind == "SkyLightComponent":
                self.left_out.append(source.actor.get_actor_label())
        for actor in world.actor_list():
            for camera in [each for each in actor._components if isinstance(each, CameraComponent)]:
                self._add_camera(actor, camera)

    def _add_light(self, source: LightSource) -> None:
        if not source.properties["affects_world"]:
            return
        label, kind = source.actor.get_actor_label(), _KINDS[source.kind]
        red, green, blue = light_colour(source)
        strong = max(red, green, blue)
        sun = kind == "directional"
        level = float(source.properties["intensity"]) if sun else candela_of(source)
        light: Json = {
            "type": kind,
            "name": label,
            "intensity": max(0.0, level * strong * self.factor),
            "color": [part / strong for part in (red, green, blue)] if strong > 0 else [0.0, 0.0, 0.0],
        }
        reach = float(source.properties["attenuation_radius"]) if not sun else 0.0
        if reach > 0:
            light["range"] = reach / _METRE_CM
        if kind == "spot":
            light["spot"] = _cone(source)
        holds = {"extensions": {EXTENSION: {"light": len(self.lights)}}}
        self._tree.add(source.actor, Leaf(source.name, source.pose, holds, _TURN))
        self.lights.append(light)

    def _add_camera(self, actor: Actor, camera: CameraComponent) -> None:
        label = actor.get_actor_label()
        aspect = float(camera.get_editor_property("aspect_ratio"))
        wide = math.radians(float(camera.get_editor_property("field_of_view")))
        if not (0 < wide < math.pi and aspect > 0):
            self.left_out.append(label)
            return
        holds = {"camera": len(self.cameras)}
        self._tree.add(actor, Leaf(camera.get_name(), camera._world_pose(), holds, _TURN))
        self.cameras.append(
            {
                "type": "perspective",
                "name": label,
                "perspective": {
                    "aspectRatio": aspect,
                    "yfov": 2 * math.atan(math.tan(wide / 2) / aspect),
                    "znear": _NEAR_M,
                },
            }
        )

    def add_to(self, tree: Json) -> None:
        """Put the records into a glTF document."""
        if self.cameras:
            tree["cameras"] = self.cameras
        if self.lights:
            tree["asset"]["extras"] = {LIGHT_FACTOR: self.factor}
            tree["extensionsUsed"] = [*tree.get("extensionsUsed", []), EXTENSION]
            tree["extensions"] = {**tree.get("extensions", {}), EXTENSION: {"lights": self.lights}}


def factor_of(sources: list[LightSource]) -> float:
    """What a level's intensities are multiplied by: 1 where its sun is in real lux, else 683."""
    suns = [float(s.properties["intensity"]) for s in sources if s.kind == "DirectionalLightComponent"]
    return 1.0 if max(suns, default=0.0) >= _DAYLIGHT_LUX else _LUMENS_PER_WATT


def _cone(source: LightSource) -> Json:
    """Half angles of a spot in radians, the inner below the outer, as glTF asks for."""
    if source.kind == "RectLightComponent":
        return {"innerConeAngle": 0.0, "outerConeAngle": math.pi / 2}
    inner, outer = (math.radians(float(source.properties[f"{part}_cone_angle"])) for part in ("inner", "outer"))
    outer = min(max(outer, _LEAST_CONE_STEP), math.pi / 2)
    return {"innerConeAngle": min(max(inner, 0.0), outer - _LEAST_CONE_STEP), "outerConeAngle": outer}
