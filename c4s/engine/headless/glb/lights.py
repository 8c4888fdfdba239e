"""Lights and cameras of the open level as glTF nodes (``KHR_lights_punctual``).

Both look along -Z there and along +X in Unreal. Suns are in lux, local lights in candela, in both. A rectangle light
becomes a spot as wide as a half space, which is the nearest that glTF has. Sky lights have no counterpart.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from c4s.engine.headless.pictures.lights import candela_of, light_colour
from c4s.engine.headless.unreal.lights import CameraComponent
from c4s.geometry.transform import quat_multiply

if TYPE_CHECKING:
    from c4s.engine.headless.pose import Pose
    from c4s.engine.headless.world.world import LightSource, World

EXTENSION = "KHR_lights_punctual"
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
    """The nodes of a level's lights and cameras, and the records that they name."""

    def __init__(self, world: World) -> None:
        self.nodes: list[Json] = []
        self.lights: list[Json] = []
        self.cameras: list[Json] = []
        self.left_out: list[str] = []
        """Labels of lights that glTF cannot hold."""
        for source in world.light_sources():
            if source.kind in _KINDS:
                self._add_light(source)
            elif source.kind == "SkyLightComponent":
                self.left_out.append(source.actor.get_actor_label())
        for actor in world.actor_list():
            for camera in [each for each in actor._components if isinstance(each, CameraComponent)]:
                self._add_camera(actor.get_actor_label(), camera)

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
            "intensity": max(0.0, level * strong),
            "color": [part / strong for part in (red, green, blue)] if strong > 0 else [0.0, 0.0, 0.0],
        }
        reach = float(source.properties["attenuation_radius"]) if not sun else 0.0
        if reach > 0:
            light["range"] = reach / _METRE_CM
        if kind == "spot":
            light["spot"] = _cone(source)
        self._node(label, source.pose, {"extensions": {EXTENSION: {"light": len(self.lights)}}})
        self.lights.append(light)

    def _add_camera(self, label: str, camera: CameraComponent) -> None:
        aspect = float(camera.get_editor_property("aspect_ratio"))
        wide = math.radians(float(camera.get_editor_property("field_of_view")))
        if not (0 < wide < math.pi and aspect > 0):
            self.left_out.append(label)
            return
        self._node(label, camera._world_pose(), {"camera": len(self.cameras)})
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

    def _node(self, label: str, pose: Pose, more: Json) -> None:
        x, y, z = pose.location
        qx, qy, qz, qw = pose.quat
        turned = quat_multiply((-qx, -qz, -qy, qw), _TURN)
        length = math.sqrt(sum(part * part for part in turned))
        self.nodes.append(
            {
                "name": label,
                "translation": [x / _METRE_CM, z / _METRE_CM, y / _METRE_CM],
                "rotation": [part / length for part in turned],
                **more,
            }
        )

    def add_to(self, tree: Json) -> None:
        """Put them into a glTF document, below its scene."""
        if not self.nodes:
            return
        first = len(tree["nodes"])
        tree["nodes"] += self.nodes
        tree["scenes"][tree.get("scene", 0)]["nodes"] += range(first, len(tree["nodes"]))
        if self.cameras:
            tree["cameras"] = self.cameras
        if self.lights:
            tree["extensionsUsed"] = [*tree.get("extensionsUsed", []), EXTENSION]
            tree["extensions"] = {**tree.get("extensions", {}), EXTENSION: {"lights": self.lights}}


def _cone(source: LightSource) -> Json:
    """Half angles of a spot in radians, the inner below the outer, as glTF asks for."""
    if source.kind == "RectLightComponent":
        return {"innerConeAngle": 0.0, "outerConeAngle": math.pi / 2}
    inner, outer = (math.radians(float(source.properties[f"{part}_cone_angle"])) for part in ("inner", "outer"))
    outer = min(max(outer, _LEAST_CONE_STEP), math.pi / 2)
    return {"innerConeAngle": min(max(inner, 0.0), outer - _LEAST_CONE_STEP), "outerConeAngle": outer}
