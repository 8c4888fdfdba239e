"""Places assets of packs in a level: frames, readable names, reproducible ids, lights.

Furniture faces +Y at yaw 0; yaw 90 turns it to face -X, -90 to face +X, 180 to face -Y.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from c4s.geometry.transform import affine
from c4s.records.level import Level, LevelComponent, Transform, Vector
from cases.corruption import STATIC_MESH_COMPONENT, with_identities
from cases.starter.stage import Stage, asset_path
from catalog.shapes import BlueprintSpec, PackSpec

SCENE_COMPONENT = "/Script/Engine.SceneComponent"
GAP = 0.1
"""Things stand this far (cm) above what carries them: sinking by rounding would count as unsupported."""


class LevelBuilder(Stage):
    """Collects the actors of one level.

    Args:
        scene_id: names the level; ids and GUIDs follow from it and the actors' names.
        packs: specifications of the packs whose assets are placed, by name without ``SM_`` and ``BP_``.
        floor_cm: height on which assets stand unless told otherwise.
    """

    def __init__(self, scene_id: str, packs: Sequence[PackSpec], floor_cm: float = 0.0) -> None:
        super().__init__(scene_id, {})
        self.floor = floor_cm
        self._blueprints: dict[str, BlueprintSpec] = {}
        for pack in packs:
            for asset in pack.assets:
                self.paths[asset.name] = asset_path(pack.content_folder, asset.category, asset.name)
            for blueprint in pack.blueprints:
                name = f"BP_{blueprint.name}"
                self.paths[blueprint.name] = f"/Game/{pack.content_folder}/Blueprints/{name}.{name}"
                self._blueprints[blueprint.name] = blueprint
        self._count: Counter[str] = Counter()
        self._frame: list[tuple[float, float, float]] = []

    @contextmanager
    def at(self, x: float, y: float, yaw: float = 0.0) -> Iterator[None]:
        """What is placed inside is placed in a frame at ``x, y`` (cm) turned by ``yaw`` (degrees)."""
        self._frame.append((x, y, yaw))
        try:
            yield
        finally:
            self._frame.pop()

    @contextmanager
    def folder(self, name: str) -> Iterator[None]:
        """What is placed inside lies in an outliner folder."""
        before, self.outliner_folder = self.outliner_folder, name
        try:
            yield
        finally:
            self.outliner_folder = before

    def place(
        self, asset: str, x: float, y: float, z: float | None = None, yaw: float = 0.0, scale: float | Vector = 1.0
    ) -> str:
        """Place an asset; ``z`` (cm) is above the floor of the level plus a small gap, 0 when left out.

        Returns the object name, ``<asset>_<number>``.
        """
        path = self.path(asset)
        height = self.floor if z is None else self.floor + z + GAP
        factors = (scale, scale, scale) if isinstance(scale, float | int) else scale
        location, turn = self._world(x, y, yaw)
        place = Transform(location_cm=(*location, round(height, 3)), rotation_deg=(0.0, turn, 0.0), scale=factors)
        name = self._name(asset)
        if asset in self._blueprints:
            return self.add_actor(name, f"{path}_C", place, self._parts(self._blueprints[asset]))
        return self.add_mesh(name, asset, place)

    def point_light(self, x: float, y: float, z: float, *, intensity: float = 3000.0, radius_cm: float = 700.0) -> str:
        """A warm point light; intensity in the engine's unitless measure."""
        location, _ = self._world(x, y, 0)
        return self.add_light(
            self._name("LightPoint"),
            "PointLight",
            Transform(location_cm=(*location, z)),
            intensity=intensity,
            attenuation_radius=radius_cm,
            light_color=[255, 238, 214, 255],
        )

    def daylight(self, *, yaw: float, pitch: float = -52.0, intensity: float = 4.0) -> None:
        """A sun that shines along ``yaw`` and ``pitch`` (degrees), the light of the sky, air and thin fog."""
        self.add_light(
            self._name("LightSun"),
            "DirectionalLight",
            Transform(location_cm=(0.0, 0.0, 600.0), rotation_deg=(pitch, yaw, 0.0)),
            intensity=intensity,
            light_source_angle=2.0,
        )
        self.add_light(self._name("LightSky"), "SkyLight", Transform(location_cm=(0.0, 0.0, 650.0)), intensity=1.0)
        self.add_air()

    def level(self) -> Level:
        """The level, with a stable-id tag on every actor."""
        bare = Level(package=f"/Game/C4SScenes/{self.scene_id}", actors=self.actors)
        return with_identities(bare, self.scene_id)

    def _world(self, x: float, y: float, yaw: float) -> tuple[tuple[float, float], float]:
        for fx, fy, turn in reversed(self._frame):
            moved = affine((fx, fy, 0), (0, turn, 0), (1, 1, 1)) @ (x, y, 0, 1)
            x, y, yaw = float(moved[0]), float(moved[1]), yaw + turn
        return (round(x, 3), round(y, 3)), (yaw + 180.0) % 360.0 - 180.0 if abs(yaw) > 180 else float(yaw)

    def _name(self, stem: str) -> str:
        self._count[stem] += 1
        return f"{stem}_{self._count[stem]:02d}"

    def _parts(self, spec: BlueprintSpec) -> list[LevelComponent]:
        root = LevelComponent(name="DefaultSceneRoot", class_path=SCENE_COMPONENT)
        return [
            root,
            *(
                LevelComponent(
                    name=f"{part.asset}{number}",
                    class_path=STATIC_MESH_COMPONENT,
                    static_mesh=self.paths[part.asset],
                    relative=Transform(
                        location_cm=part.location_cm, rotation_deg=(0.0, part.yaw_deg, 0.0), scale=part.scale
                    ),
                )
                for number, part in enumerate(spec.parts)
            ),
        ]


def wall_run(level: LevelBuilder, modules: Sequence[str], start: tuple[float, float], yaw: float) -> None:
    """Wall modules in a row from ``start`` (their length is the number that ends the name), facing yaw's +Y side."""
    reach = 0.0
    with level.at(*start, yaw):
        for module in modules:
            length = float(module[-3:])
            level.place(module, reach + length / 2, 0)
            reach += length
