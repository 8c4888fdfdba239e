"""Lamps and the sun."""

from __future__ import annotations

from c4s.records.level import Transform
from cases.open190.layout.putting import Putting


class Lighting(Putting):
    """Lights a place."""

    def light(
        self,
        x: float,
        y: float,
        z: float = 240.0,
        *,
        intensity: float = 3000.0,
        radius: float = 900.0,
        colour: tuple[int, int, int] = (255, 236, 208),
    ) -> None:
        """A point light; intensity in the engine's unitless measure."""
        wx, wy, _ = self._world(x, y, 0)
        self._numbers["LightPoint"] += 1
        self.add_light(
            f"LightPoint_{self._numbers['LightPoint']}",
            "PointLight",
            Transform(location_cm=(wx, wy, z)),
            intensity=intensity,
            attenuation_radius=radius,
            light_color=[*colour, 255],
        )

    def sun(
        self,
        pitch: float = -42.0,
        yaw: float = -118.0,
        *,
        intensity: float = 4.0,
        colour: tuple[int, int, int] = (255, 255, 255),
        sky: float = 1.0,
    ) -> None:
        """A sun that shines along [pitch, yaw], the light of the sky, air and thin fog."""
        self.add_light(
            "LightSun",
            "DirectionalLight",
            Transform(location_cm=(0.0, 0.0, 3000.0), rotation_deg=(pitch, yaw, 0.0)),
            intensity=intensity,
            light_source_angle=2.0,
            light_color=[*colour, 255],
        )
        self.add_light("LightSky", "SkyLight", Transform(location_cm=(0.0, 0.0, 3100.0)), intensity=sky)
        self.add_air()
