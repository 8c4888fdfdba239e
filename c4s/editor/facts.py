"""What the snapshot asks about actors and their components. Runs inside an engine: stdlib and ``unreal`` only.

Centimetres and degrees; rotations are [pitch, yaw, roll], quaternions x, y, z, w.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import unreal


class Part(NamedTuple):
    """A scene component."""

    name: str
    kind: str
    """Path of its class."""
    primitive: bool
    collides: bool
    mesh: Any
    """The static or skeletal mesh that it shows, or None."""
    slots: list[tuple[str | None, str | None]]
    """Path of the material and of the material's class, slot by slot; empty without a mesh."""
    place: dict[str, Any]
    instances: list[dict[str, Any]] | None


class Stand(NamedTuple):
    """What an actor is and where it stands, without its components."""

    name: str
    kind: str
    """Path of its class."""
    label: str
    path: str
    guid: str
    tags: list[str]
    parent: tuple[str, str] | None
    """Path and label of the actor that it is attached to."""
    location: list[float]
    rotation: list[float]
    quaternion: list[float]
    scale: list[float]
    origin: list[float]
    extent: list[float]


def row(value: Any) -> list[float]:
    """A vector as a row."""
    return [value.x, value.y, value.z]


def angles(rotator: Any) -> list[float]:
    """A rotator as [pitch, yaw, roll]."""
    return [rotator.pitch, rotator.yaw, rotator.roll]


def place(transform: Any) -> dict[str, Any]:
    """A world transform with its quaternion."""
    quat = transform.rotation
    return {
        "location_cm": row(transform.translation),
        "rotation_deg": angles(quat.rotator()),
        "quaternion_xyzw": [quat.x, quat.y, quat.z, quat.w],
        "scale": row(transform.scale3d),
    }


def mesh_of(component: Any) -> Any:
    """The static or skeletal mesh of a component, or None."""
    for name in ("static_mesh", "skeletal_mesh_asset", "skeletal_mesh"):
        try:
            mesh = component.get_editor_property(name)
        except Exception:  # Unreal raises a bare Exception for a property that the class does not have
            continue
        if mesh is not None:
            return mesh
    return None


class Paths(dict[Any, str]):
    """Object paths, each asked for once an export: thousands of components share few classes and assets."""

    def __missing__(self, thing: Any) -> str:
        path = self[thing] = str(thing.get_path_name())
        return path


class Reader:
    """Reads through Unreal's Python. Its memory of paths is good for one export."""

    def __init__(self) -> None:
        self.paths = Paths()

    def parts(self, actor: Any) -> list[Any]:
        """The scene components of an actor."""
        return list(actor.get_components_by_class(unreal.SceneComponent))

    def part(self, component: Any) -> Part:
        """One of them."""
        primitive = isinstance(component, unreal.PrimitiveComponent)
        mesh = mesh_of(component) if primitive else None
        instances = None
        if isinstance(component, unreal.InstancedStaticMeshComponent):
            instances = [
                place(component.get_instance_transform(i, True)) for i in range(component.get_instance_count())
            ]
        return Part(
            component.get_name(),
            self.paths[component.get_class()],
            primitive,
            primitive and component.get_collision_enabled() != unreal.CollisionEnabled.NO_COLLISION,
            mesh,
            self._slots(component) if mesh is not None else [],
            place(component.get_world_transform()),
            instances,
        )

    def _slots(self, component: Any) -> list[tuple[str | None, str | None]]:
        return [self.material(component.get_material(i)) for i in range(component.get_num_materials())]

    def material(self, material: Any) -> tuple[str | None, str | None]:
        """Path of a material and of its class."""
        return (None, None) if material is None else (self.paths[material], self.paths[material.get_class()])

    def stand(self, actor: Any) -> Stand:
        """An actor without its components."""
        transform = actor.get_actor_transform()
        origin, extent = actor.get_actor_bounds(False)
        parent = actor.get_attach_parent_actor()
        quat = transform.rotation
        return Stand(
            actor.get_name(),
            self.paths[actor.get_class()],
            actor.get_actor_label(),
            actor.get_path_name(),
            actor.get_editor_property("actor_guid").to_string(),
            [str(tag) for tag in actor.get_editor_property("tags")],
            (parent.get_path_name(), parent.get_actor_label()) if parent is not None else None,
            row(transform.translation),
            angles(actor.get_actor_rotation()),
            [quat.x, quat.y, quat.z, quat.w],
            row(transform.scale3d),
            row(origin),
            row(extent),
        )
