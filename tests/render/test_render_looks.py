"""Holes, normal maps, vertex colours, fog, post-process and several processes at once."""

from __future__ import annotations

import hashlib
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from c4s.engine.headless.pictures import take
from c4s.engine.headless.pictures.lights import grade_of, kelvin_rgb
from c4s.engine.headless.process.boot import boot
from c4s.geometry.transform import affine
from c4s.packs.meshes import Mesh
from c4s.render import Camera, Fog, Grade, Instance, Lights, LocalLight, Picture, Renderer, Sky, Sun, SurfaceMaterial

DARK = {"sky": Sky(intensity=0.0), "ambient": (0.0, 0.0, 0.0), "camera_fill": 0.0, "exposure_ev": 0.0}
OVERHEAD = Lights(sun=Sun((0.0, 0.0, -1.0), (1.0, 1.0, 1.0), 2.0), **DARK)
PLAIN = Grade()
WHITE = SurfaceMaterial(base_color=(0.8, 0.8, 0.8), roughness=1.0)
VIEW = {"location_cm": [-300, 40, 150], "rotation_deg": [-20, 0, 0], "fov_deg": 80, "width": 96, "height": 64}


def _square(colors: np.ndarray | None = None) -> Mesh:
    """A square of 100 cm that faces up; u along X, v along Y."""
    vertices = np.array([[-50, -50, 0], [50, -50, 0], [50, 50, 0], [-50, 50, 0]], np.float32)
    return Mesh(
        vertices,
        np.array([[0, 1, 2], [0, 2, 3]], np.int32),
        np.tile(np.array([0, 0, 1], np.float32), (4, 1)),
        (vertices[:, :2] / 100 + 0.5).astype(np.float32),
        np.zeros(2, np.int32),
        colors,
    )


def _place(height: float, material: SurfaceMaterial, actor: int, side: float = 1.0) -> Instance:
    return Instance(0, affine((0, 0, height), (0, 0, 0), (side, side, 1)), (material,), actor)


def _down(
    instances: list[Instance],
    lights: Lights = OVERHEAD,
    mesh: Mesh | None = None,
    mode: str = "lit",
    grade: Grade = PLAIN,
    height: float = 100.0,
) -> Picture:
    renderer = Renderer([mesh or _square()], instances, lights, 2)
    camera = Camera((0, 0, height), (-90, 0, 0), 50, 32, 32)
    picture = renderer.render(camera, mode=mode, grade=grade)  # type: ignore[arg-type]
    renderer.close()
    return picture


def test_a_mask_cuts_holes_for_eyes_and_for_shadows() -> None:
    leaf = np.full((8, 8, 4), 200, np.uint8)
    leaf[:, :4, 3] = 20
    cut = SurfaceMaterial(base_color=(1, 1, 1), texture=leaf, alpha="mask")
    seen = _down([_place(10, cut, 1, 4.0), _place(0, WHITE, 2, 9.0)], mode="base_color")
    assert (seen.actor[:14] == 2).all() != (seen.actor[18:] == 2).all()
    assert {1, 2} == set(np.unique(seen.actor))
    above = Renderer([_square()], [_place(200, cut, 1, 4.0), _place(0, WHITE, 2, 9.0)], OVERHEAD, 2)
    floor = above.render(Camera((0, 0, 100), (-90, 0, 0), 50, 32, 32)).rgb[..., 1].astype(int)
    above.close()
    assert abs(int(floor[4].mean()) - int(floor[28].mean())) > 100
    whole = SurfaceMaterial(base_color=(1, 1, 1), texture=leaf)
    assert set(np.unique(_down([_place(10, whole, 1, 4.0)], mode="base_color").actor)) == {1}


def test_alpha_that_blends_shows_what_is_behind_by_its_share() -> None:
    veil = np.zeros((4, 4, 4), np.uint8)
    veil[..., 3] = 64
    glass = SurfaceMaterial(base_color=(1, 1, 1), texture=veil, alpha="blend")
    picture = _down([_place(10, glass, 1, 4.0), _place(0, WHITE, 2, 9.0)], mode="base_color")
    assert (picture.actor == 2).all()
    assert abs((picture.rgb[16, 16, 0] / 255) ** 2.2 - 0.8 * (1 - 64 / 255)) < 0.03


def test_a_normal_texture_turns_the_light() -> None:
    def brightness(red: int, green: int) -> int:
        bump = np.full((4, 4, 3), (red, green, 200), np.uint8)
        slanted = Lights(sun=Sun((-1.0, 0.0, -1.0), (1.0, 1.0, 1.0), 1.0), **DARK)
        return int(
            _down([_place(0, SurfaceMaterial((0.8, 0.8, 0.8), 1.0, normal_texture=bump), 1, 4.0)], slanted).rgb[
                16, 16, 1
            ]
        )

    assert brightness(210, 128) > brightness(128, 128) + 8 > brightness(46, 128) + 16
    assert abs(brightness(128, 210) - brightness(128, 46)) < 3


def test_roughness_and_metal_textures_and_emissive_ones_count() -> None:
    plain = SurfaceMaterial((0.8, 0.2, 0.1), 1.0, 1.0)
    dull = SurfaceMaterial((0.8, 0.2, 0.1), 1.0, 1.0, roughness_metal_texture=np.zeros((2, 2, 3), np.uint8) + 255)
    paint = SurfaceMaterial(
        (0.8, 0.2, 0.1), 1.0, 1.0, roughness_metal_texture=np.full((2, 2, 3), (0, 255, 0), np.uint8)
    )
    pictures = [_down([_place(0, material, 1, 4.0)]).rgb for material in (plain, dull, paint)]
    assert (pictures[0] == pictures[1]).all() and (pictures[0] != pictures[2]).any()
    lamp = SurfaceMaterial((0, 0, 0), emissive=(1, 1, 1), emissive_texture=np.full((2, 2, 3), (255, 0, 0), np.uint8))
    red = _down([_place(0, lamp, 1, 4.0)], Lights(sun=None, **DARK)).rgb[16, 16]
    assert red[0] > 150 and red[1] == red[2] == 0


def test_vertex_colours_multiply_the_base_colour() -> None:
    colors = np.array([[1, 0, 0]] * 4, np.float32)
    picture = _down([_place(0, WHITE, 1, 4.0)], mesh=_square(colors), mode="base_color")
    assert tuple(picture.rgb[16, 16]) == (231, 0, 0)


def test_depth_and_mask_agree_with_the_plane_that_is_there() -> None:
    tilt = Instance(0, affine((0, 0, 0), (20, 30, 0), (9, 9, 1)), (WHITE,), 5)
    camera = Camera((0, 0, 300), (-80, 15, 0), 60, 64, 48)
    renderer = Renderer([_square()], [tilt], OVERHEAD, 1)
    picture = renderer.render(camera)
    renderer.close()
    from c4s.geometry.transform import rotation_matrix

    turn, normal = rotation_matrix(camera.rotation_deg), tilt.matrix[:3, 2]
    half = np.tan(np.radians(30.0))
    for row, column in ((3, 3), (24, 32), (40, 60)):
        right, up = (column + 0.5) / 64 * 2 - 1, 1 - (row + 0.5) / 48 * 2
        ray = turn[:, 0] + turn[:, 1] * half * right + turn[:, 2] * half * up * 48 / 64
        expected = -(normal @ np.asarray(camera.location_cm)) / (normal @ ray)
        hit = np.abs(np.linalg.inv(tilt.matrix) @ [*(np.asarray(camera.location_cm) + ray * expected), 1])[:2].max()
        assert (picture.actor[row, column] == 5) == (hit < 50)
        if hit < 50:
            assert abs(picture.depth_cm[row, column] / expected - 1) < 1e-5


def test_fog_thickens_with_distance_and_thins_with_height() -> None:
    def red(fog: Fog, height: float) -> int:
        lights = Lights(sun=None, fog=fog, **DARK)
        return int(_down([_place(0, WHITE, 1, 99.0)], lights, height=height).rgb[16, 16, 0])

    thick = Fog(density=1.0, falloff=0.0, color=(1.0, 0.0, 0.0))
    assert red(thick, 100) < red(thick, 500) < red(thick, 3000)
    assert red(Fog(density=1.0, falloff=50.0, height_cm=-500.0, color=(1, 0, 0)), 1000) < 10
    assert red(Fog(density=1.0, falloff=0.0, start_cm=2000.0, color=(1, 0, 0)), 1000) == 0
    assert red(Fog(density=9.0, falloff=0.0, max_opacity=0.1, color=(1, 0, 0)), 3000) < red(thick, 3000) - 40


def test_every_sun_and_rectangle_lights_and_shadows_can_be_off() -> None:
    two = Lights(sun=OVERHEAD.sun, other_suns=(Sun((0.0, 0.0, -1.0), (1.0, 1.0, 1.0), 2.0),), **DARK)
    floor = [_place(0, WHITE, 1, 9.0)]
    assert _down(floor, two).rgb[16, 16, 1] > _down(floor).rgb[16, 16, 1] + 20
    shaded = [*floor, _place(150, WHITE, 2, 9.0)]
    free = Lights(sun=Sun((0, 0, -1), (1, 1, 1), 2.0, casts_shadows=False), **DARK)
    assert _down(shaded).rgb[16, 16, 1] == 0 and _down(shaded, free).rgb[16, 16, 1] > 100
    panel = LocalLight((0, 0, 90), intensity_cd=2.0, direction=(0, 0, -1), across=(20, 0, 0), upwards=(0, 20, 0))
    away = LocalLight((0, 0, 90), intensity_cd=2.0, direction=(0, 0, 1), across=(20, 0, 0), upwards=(0, 20, 0))
    assert _down(floor, Lights(sun=None, local=(panel,), **DARK)).rgb[16, 16, 1] > 60
    assert _down(floor, Lights(sun=None, local=(away,), **DARK)).rgb[16, 16, 1] == 0


def test_grades_change_exposure_saturation_contrast_and_white() -> None:
    floor = [_place(0, SurfaceMaterial((0.5, 0.25, 0.1), 1.0), 1, 9.0)]

    def pixel(grade: Grade) -> np.ndarray:
        return _down(floor, grade=grade).rgb[16, 16].astype(int)

    plain = pixel(Grade())
    assert pixel(Grade(bias_ev=1.0)).sum() > plain.sum() + 60
    assert np.ptp(pixel(Grade(saturation=(0.0, 0.0, 0.0)))) <= 1
    assert pixel(Grade(gain=(0.5, 0.5, 0.5))).sum() < plain.sum() - 60
    cold, warm = (pixel(grade_of({"white_temp": kelvin})) for kelvin in (4000.0, 10000.0))
    assert cold[2] - cold[0] > plain[2] - plain[0] > warm[2] - warm[0]
    assert grade_of({}) == Grade()


def test_black_bodies_are_orange_white_and_blue() -> None:
    orange, white, blue = (kelvin_rgb(kelvin) for kelvin in (2000.0, 6500.0, 12000.0))
    assert orange[0] > 1.5 > 0.9 > orange[1] > orange[2]
    assert white == pytest.approx((1.0, 1.0, 1.0), abs=0.08)
    assert blue[2] > 1.2 > blue[0]


def test_the_engine_reads_lights_fog_and_post_process(tmp_path: Path) -> None:
    unreal = boot([], tmp_path / "content")
    spawn = unreal.EditorLevelLibrary.spawn_actor_from_class
    cube = unreal.load_asset("/Engine/BasicShapes/Cube")
    unreal.EditorLevelLibrary.spawn_actor_from_object(cube, unreal.Vector(0, 0, 50))

    def picture(name: str) -> np.ndarray:
        from PIL import Image

        take.take([VIEW], [str(tmp_path / name)], "lit", False)
        return np.asarray(Image.open(tmp_path / name)).astype(int)

    sun = spawn(unreal.DirectionalLight, unreal.Vector(), unreal.Rotator(pitch=-50, yaw=10))
    plain = picture("plain.png")
    sun.light_component.set_use_temperature(True)
    sun.light_component.set_temperature(2500.0)
    warm = picture("warm.png")
    assert (warm[..., 0] - warm[..., 2]).mean() > (plain[..., 0] - plain[..., 2]).mean() + 5
    fog = spawn(unreal.ExponentialHeightFog, unreal.Vector())
    fog.component.set_fog_density(3.0)
    fog.component.set_fog_inscattering_color(unreal.LinearColor(0, 1, 0, 1))
    green = picture("fog.png")
    assert (green[..., 1] - green[..., 0]).mean() > (warm[..., 1] - warm[..., 0]).mean() + 20
    volume = spawn(unreal.PostProcessVolume, unreal.Vector())
    settings = unreal.PostProcessSettings()
    settings.set_editor_property("color_saturation", unreal.Vector4(0, 0, 0, 1))
    volume.set_editor_property("settings", settings)
    volume.set_editor_property("unbound", True)
    assert (picture("kept.png") == green).all()
    settings.set_editor_property("override_color_saturation", True)
    volume.set_editor_property("settings", settings)
    assert np.ptp(picture("grey.png"), axis=2).max() <= 1


def test_three_processes_at_once_write_the_same_bytes(tmp_path: Path) -> None:
    code = (
        "import sys, hashlib\nfrom pathlib import Path\nfrom c4s.engine.headless.process.boot import boot\n"
        "from c4s.engine.headless.pictures.take import take\nfolder = Path(sys.argv[1])\n"
        "unreal = boot([], folder / 'content')\ncube = unreal.load_asset('/Engine/BasicShapes/Cube')\n"
        "for n in range(30):\n    unreal.EditorLevelLibrary.spawn_actor_from_object(cube, "
        "unreal.Vector(n * 60, (n % 7) * 90 - 250, 50), unreal.Rotator(yaw=n * 11))\n"
        f"take([{VIEW!r}], [str(folder / 'a.png')], 'lit', True)\n"
    )
    running = []
    for number in range(3):
        (tmp_path / str(number)).mkdir()
        running.append(subprocess.Popen([sys.executable, "-c", code, str(tmp_path / str(number))]))
    assert [process.wait(timeout=120) for process in running] == [0, 0, 0]
    for name in ("a.png", "a.actors.npz"):
        made = [(tmp_path / str(number) / name).read_bytes() for number in range(3)]
        if name.endswith(".png"):
            assert len({hashlib.sha256(data).hexdigest() for data in made}) == 1
    masks = [np.load(tmp_path / str(number) / "a.actors.npz") for number in range(3)]
    for key in ("actor", "depth_cm", "names"):
        assert len({mask[key].tobytes() for mask in masks}) == 1
