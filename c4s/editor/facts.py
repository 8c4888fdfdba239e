"""What the snapshot asks about actors and their components. Runs inside an engine: stdlib and ``unreal`` only.

Centimetres and degrees; rotations are [pitch, yaw, roll], quaternions x, y, z, w.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import unreal

from c4s.editor.values import plain

RECORDED = (
    "intensity",
    "intensity_units",
    "light_color",
    "temperature",
    "use_temperature",
    "source_angle",
    "indirect_lighting_intensity",
    "volumetric_scattering_intensity",
    "fog_density",
    "fog_height_falloff",
    "start_distance",
    "sun_disk_scale",
    "cloud_opacity",
    "exposure_compensation",
    "min_brightness",
    "max_brightness",
    "white_temp",
    "color_saturation",
    "color_contrast",
    "color_gamma",
    "color_gain",
    "color_offset",
)
"""Editor properties that a snapshot records of an actor or its components, where one has a property of this very name.

Unreal has none called ``source_angle``, and the values of grading lie inside a volume's ``settings``: the published
exporter records neither, so neither counts as an edit.
"""


class PartFacts(NamedTuple):
    """A component."""

    name: str
    kind: str
    """Path of its class."""
    primitive: bool
    collides: bool
    collision: str
    """What its collision takes part in, in Unreal's words; empty when it is no primitive."""
    mesh: Any
    """The static or skeletal mesh that it shows, or None."""
    slots: list[tuple[str | None, str | None]]
    """Path of the material and of the material's class, slot by slot."""
    visible: bool
    """Whether pictures show it, as long as the actor is shown."""
    place: dict[str, Any] | None
    """Where it is; None for a component without a place."""
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
    folder: str
    """In the outliner; ``None`` when it lies in none."""
    hidden_in_editor: bool
    hidden: bool
    """Hidden in game, and so in pictures."""
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


class AssetPaths(dict[Any, str]):
    """Object paths, each asked for once an export: thousands of components share few classes and assets."""

    def __missing__(self, thing: Any) -> str:
        path = self[thing] = str(thing.get_path_name())
        return path


class Reader:
    """Reads through Unreal's Python. Its memory of paths, classes and materials is good for one export."""

    def __init__(self) -> None:
        self.paths = AssetPaths()
        self.materials: dict[str, Any] = {}
        """The materials that slots showed, by path."""
        self._recorded: dict[Any, list[str]] = {}

    def parts(self, actor: Any) -> list[Any]:
        """The components of an actor."""
        return list(actor.get_components_by_class(unreal.ActorComponent))

    def part(self, component: Any) -> PartFacts:
        """One of them."""
        primitive = isinstance(component, unreal.PrimitiveComponent)
        placed = isinstance(component, unreal.SceneComponent)
        instances = None
        if isinstance(component, unreal.InstancedStaticMeshComponent):
            instances = [
                place(component.get_instance_transform(i, True)) for i in range(component.get_instance_count())
            ]
        return PartFacts(
            component.get_name(),
            self.paths[component.get_class()],
            primitive,
            primitive and component.get_collision_enabled() != unreal.CollisionEnabled.NO_COLLISION,
            str(component.get_collision_enabled()) if primitive else "",
            mesh_of(component) if placed else None,
            self._slots(component),
            placed and component.get_editor_property("visible") and not component.get_editor_property("hidden_in_game"),
            place(component.get_world_transform()) if placed else None,
            instances,
        )

    def _slots(self, component: Any) -> list[tuple[str | None, str | None]]:
        if not hasattr(component, "get_num_materials"):
            return []
        return [self.material(component.get_material(i)) for i in range(component.get_num_materials())]

    def material(self, material: Any) -> tuple[str | None, str | None]:
        """Path of a material and of its class."""
        if material is None:
            return None, None
        path = self.paths[material]
        self.materials.setdefault(path, material)
        return path, self.paths[self.class_of(material)]

    def class_of(self, thing: Any) -> Any:
        """Its class."""
        return thing.get_class()

    def has(self, owner: Any, name: str) -> bool:
        """Whether it has an editor property."""
        try:
            owner.get_editor_property(name)
        except Exception:  # Unreal raises a bare Exception for a property that the class does not have
            return False
        return True

    def properties(self, owners: Iterable[Any]) -> dict[str, Any]:
        """What is recorded of an actor and its components, each value of the first that has one."""
        found: dict[str, Any] = {}
        for owner in owners:
            kind = self.class_of(owner)
            if kind not in self._recorded:
                self._recorded[kind] = [name for name in RECORDED if self.has(owner, name)]
            for name in self._recorded[kind]:
                if found.get(name) is None:
                    found[name] = plain(owner.get_editor_property(name))
        return {name: found[name] for name in RECORDED if found.get(name) is not None}

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
            str(actor.get_folder_path()),
            bool(actor.is_hidden_ed()),
            bool(actor.get_editor_property("hidden")),
            (parent.get_path_name(), parent.get_actor_label()) if parent is not None else None,
            row(transform.translation),
            angles(actor.get_actor_rotation()),
            [quat.x, quat.y, quat.z, quat.w],
            row(transform.scale3d),
            row(origin),
            row(extent),
        )
