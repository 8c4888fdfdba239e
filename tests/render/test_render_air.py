"""A SkyAtmosphere reddens and dims a low sun and its sky, and leaves a level without one as it was."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from PIL import Image

_CODE = """
import sys
from pathlib import Path
from c4s.engine.headless.process.boot import boot
folder = Path(sys.argv[1])
unreal = boot([], folder / "content")
spawn = unreal.EditorLevelLibrary.spawn_actor_from_class
floor = unreal.EditorLevelLibrary.spawn_actor_from_object(
    unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector(500, 0, -50))
floor.set_actor_scale3d(unreal.Vector(20, 20, 1))
sun = spawn(unreal.DirectionalLight, unreal.Vector(), unreal.Rotator(pitch=-60, yaw=10))
spawn(unreal.SkyLight, unreal.Vector())
from c4s.engine.headless.pictures import take
from c4s.engine.headless.pictures.lights import lights_of
from c4s.engine.headless.world.state import world

def told(name):
    lights = lights_of(tuple(world().light_sources()))
    view = {"location_cm": [-300, 0, 150], "rotation_deg": [-10, 0, 0], "fov_deg": 80, "width": 48, "height": 32}
    take.take([view], [str(folder / f"{name}.png")], "lit", False)
    print(*lights.sun.color, *lights.sky.zenith, *lights.sky.horizon)

told("bare")
air = spawn(unreal.SkyAtmosphere, unreal.Vector())
told("high")
sun.set_actor_rotation(unreal.Rotator(pitch=-4, yaw=10), False)
told("low")
sun.light_component.set_editor_property("atmosphere_sun_light", False)
told("apart")
"""


def test_a_low_sun_reddens_light_and_sky(tmp_path: Path) -> None:
    done = subprocess.run([sys.executable, "-c", _CODE, str(tmp_path)], capture_output=True, text=True, check=True)
    rows = [[float(number) for number in line.split()] for line in done.stdout.splitlines()[-4:]]
    (bare, high, low, apart) = ([row[:3], row[3:6], row[6:]] for row in rows)
    assert bare == apart
    for part in range(3):
        assert high[part][0] / bare[part][0] > 0.95
        assert low[part][0] < high[part][0] and low[part][2] < high[part][2] / 2
    assert low[0][0] > 2 * low[0][1] > 4 * low[0][2]
    assert low[2][0] > low[2][1] > low[2][2] and low[1][2] > low[1][0]

    def red_over_blue(name: str, row: int) -> float:
        with Image.open(tmp_path / f"{name}.png") as picture:
            red, _, blue = picture.convert("RGB").getpixel((24, row))  # type: ignore[misc]
        return float(red) / float(blue)

    assert red_over_blue("low", 6) > 1.2 > 1.0 > red_over_blue("high", 6)
    assert red_over_blue("low", 28) > 1.15 * red_over_blue("high", 28)
