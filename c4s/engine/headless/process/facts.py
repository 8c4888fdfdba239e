"""What the snapshot asks, answered from the engine's own state: as through ``unreal``, without its checks."""

from __future__ import annotations

from typing import Any

from c4s.editor.facts import PartFacts, Reader, Stand
from c4s.engine.headless.pose import Pose, compose
from c4s.engine.headless.unreal.components import InstancedStaticMeshComponent, StaticMeshComponent
from c4s.engine.headless.world.state import world
from c4s.geometry.transform import rotator_from_quat


def _row(values: Any) -> list[float]:
    return [float(value) for value in values]


def _place(pose: Pose) -> dict[str, Any]:
    pitch, yaw, roll = rotator_from_quat(pose.quat)
    return {
        "location_cm": _row(pose.location),
        "rotation_deg": [pitch + 0.0, yaw + 0.0, roll + 0.0],
        "quaternion_xyzw": _row(pose.quat),
        "scale": _row(pose.scale),
    }


class DirectReader(Reader):
    """Reads actors and static mesh components directly, other components through ``unreal``."""

    def __init__(self) -> None:
        super().__init__()
        self._level = world().map_path()

    def parts(self, actor: Any) -> list[Any]:
        return list(actor._components)

    def part(self, component: Any) -> PartFacts:
        if not isinstance(component, StaticMeshComponent):
            return super().part(component)
        pose = component._world_pose()
        instances = None
        if isinstance(component, InstancedStaticMeshComponent):
            instances = [_place(compose(each, pose)) for each in component._instances]
        mesh = component._mesh
        slots = [self.material(component._material(i)) for i in range(component._slot_count())]
        return PartFacts(
            str(component._name),
            self.paths[component._class()],
            True,
            component._collides(),
            str(component.get_collision_enabled()),
            mesh,
            slots,
            component._shows(),
            _place(pose),
            instances,
        )

    def class_of(self, thing: Any) -> Any:
        return thing._class()

    def has(self, owner: Any, name: str) -> bool:
        prop = owner._properties.get(name)
        return prop is not None and prop.scripts

    def stand(self, actor: Any) -> Stand:
        pose = actor._pose()
        origin, extent = actor._bounds(False)
        above = actor._root()._parent
        parent = above._outer if above is not None else None
        return Stand(
            str(actor._name),
            self.paths[actor._class()],
            str(actor._label),
            f"{self._level}:PersistentLevel.{actor._name}",
            actor._guid.upper(),
            [str(tag) for tag in actor._values.get("tags", ())],
            actor._folder or "None",
            actor._hidden_ed,
            bool(actor._values.get("hidden")),
            (str(parent._path()), str(parent._label)) if parent is not None else None,
            _row(pose.location),
            _row(pose.rotation_deg),
            _row(pose.quat),
            _row(pose.scale),
            _row(origin),
            _row(extent),
        )
