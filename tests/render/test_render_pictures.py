"""Pictures, masks and depth against what geometry says they must be."""

from __future__ import annotations

import math
import os
import shutil
import stat
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from c4s.errors import BadInput
from c4s.geometry.transform import affine, look_at, rotation_matrix
from c4s.packs.meshes import Mesh
from c4s.render import Camera, Instance, Lights, LocalLight, Picture, Renderer, Sky, Sun, SurfaceMaterial

RED = SurfaceMaterial(base_color=(0.8, 0.05, 0.05))
GREEN = SurfaceMaterial(base_color=(0.05, 0.7, 0.05))
BLUE = SurfaceMaterial(base_color=(0.05, 0.1, 0.8))
WHITE = SurfaceMaterial(base_color=(0.8, 0.8, 0.8))
SUN_ONLY = Lights(
    sun=Sun(direction=(0.0, 0.0, -1.0), color=(1, 1, 1), intensity=2.0),
    sky=Sky(intensity=0.0),
    ambient=(0.01, 0.01, 0.01),
    camera_fill=0.0,
    exposure_ev=0.0,
)


def _cube() -> Mesh:
    vertices, normals, uvs, faces = [], [], [], []
    for axis in range(3):
        for sign in (-1.0, 1.0):
            start = len(vertices)
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                corner, normal = np.zeros(3), np.zeros(3)
                normal[axis] = sign
                corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3] = sign * 50, a * 50, b * 50
                vertices.append(corner)
                normals.append(normal)
                uvs.append(((a + 1) / 2, (1 - b) / 2))
            faces += [(start, start + 1, start + 2), (start, start + 2, start + 3)]
    return Mesh(
        np.array(vertices, np.float32),
        np.array(faces, np.int32),
        np.array(normals, np.float32),
        np.array(uvs, np.float32),
        np.repeat(np.arange(6, dtype=np.int32), 2),
    )


CUBE = _cube()


def _box(
    location: tuple[float, float, float],
    size: tuple[float, float, float],
    material: SurfaceMaterial,
    actor: int,
    rotation: tuple[float, float, float] = (0, 0, 0),
) -> Instance:
    return Instance(0, affine(location, rotation, [s / 100 for s in size]), (material,) * 6, actor)


def _take(instances: list[Instance], camera: Camera, lights: Lights | None = None, **options: object) -> Picture:
    renderer = Renderer([CUBE], instances, lights or Lights(), threads=2)
    picture = renderer.render(camera, **options)  # type: ignore[arg-type]
    renderer.close()
    return picture


def _pixel(camera: Camera, point: NDArray[np.float64]) -> tuple[float, float]:
    local = rotation_matrix(camera.rotation_deg).T @ (point - np.asarray(camera.location_cm))
    focal = camera.width / 2 / math.tan(math.radians(camera.hfov_deg) / 2)
    return camera.width / 2 + focal * local[1] / local[0], camera.height / 2 - focal * local[2] / local[0]


def test_a_camera_at_rest_sees_plus_y_on_the_right_and_plus_z_above() -> None:
    picture = _take(
        [
            _box((500, 150, 0), (60, 60, 60), RED, 1),
            _box((500, 0, 150), (60, 60, 60), GREEN, 2),
            _box((-500, 0, 0), (60, 60, 60), BLUE, 3),
        ],
        Camera((0, 0, 0), width=160, height=120),
    )
    for actor, (row, column) in {1: (60, 106), 2: (34, 80)}.items():
        rows, columns = np.nonzero(picture.actor == actor)
        assert abs(rows.mean() - row) < 4 and abs(columns.mean() - column) < 4
    assert not (picture.actor == 3).any()
    assert picture.rgb[60, 106].argmax() == 0 and picture.rgb[34, 80].argmax() == 1


@pytest.mark.parametrize(
    "camera",
    [
        Camera((-300, -200, 250), look_at((-300, -200, 250), (0, 0, 0)), 70, 201, 117),
        Camera((250, 300, -180), (*look_at((250, 300, -180), (0, 0, 0))[:2], 35.0), 50, 160, 160),
    ],
)
def test_the_mask_agrees_with_projected_corners(camera: Camera) -> None:
    from shapely import MultiPoint, contains_xy

    instance = _box((10, -20, 5), (120, 60, 90), RED, 7, (20, 50, 10))
    picture = _take([instance], camera)
    corners = (instance.matrix @ np.c_[CUBE.vertices.astype(float), np.ones(24)].T)[:3].T
    outline = MultiPoint([_pixel(camera, corner) for corner in corners]).convex_hull
    y, x = np.mgrid[0 : camera.height, 0 : camera.width] + 0.5
    inside, near = contains_xy(outline, x, y), contains_xy(outline.boundary.buffer(0.01), x, y)
    assert ((picture.actor == 7) == inside)[~near].all()
    assert inside.sum() > 1000


def test_depth_is_the_distance_along_the_view() -> None:
    wall = _box((1050, 0, 0), (100, 5000, 5000), WHITE, 0)
    picture = _take([wall], Camera((0, 0, 0), width=64, height=48))
    assert np.abs(picture.depth_cm - 1000).max() < 1e-2
    assert (picture.actor == 0).all()


def test_nothing_seen_is_minus_one_and_infinite() -> None:
    picture = _take([_box((-500, 0, 0), (10, 10, 10), RED, 4)], Camera((0, 0, 0), width=33, height=17))
    assert picture.rgb.shape == (17, 33, 3)
    assert (picture.actor == -1).all() and np.isinf(picture.depth_cm).all()


def test_an_empty_scene_is_sky() -> None:
    picture = _take([], Camera((0, 0, 0), width=16, height=16))
    assert (picture.actor == -1).all() and picture.rgb.min() > 30


def test_base_colour_is_the_material_without_light() -> None:
    material = SurfaceMaterial(base_color=(0.5, 0.25, 0.0), emissive=(5, 5, 5), metallic=1.0)
    picture = _take(
        [_box((200, 0, 0), (100, 100, 100), material, 1)],
        Camera((0, 0, 0), width=64, height=48),
        Lights(sun=None),
        mode="base_color",
    )
    inner = picture.rgb[20:28, 28:36].reshape(-1, 3)
    assert (inner == (188, 137, 0)).all()
    assert (picture.rgb[picture.actor == -1][0] == 0).all()


def test_a_texture_shows_its_own_colours_the_right_way_up() -> None:
    texture = np.zeros((2, 2, 3), np.uint8)
    texture[0, 0], texture[0, 1], texture[1, 0], texture[1, 1] = (200, 0, 0), (0, 200, 0), (0, 0, 200), (99, 99, 99)
    texture = texture.repeat(64, 0).repeat(64, 1)
    material = SurfaceMaterial(base_color=(1, 1, 1), texture=texture)
    picture = _take(
        [_box((0, 0, 0), (100, 100, 100), material, 1)],
        Camera((-250, 0, 0), hfov_deg=30, width=64, height=64),
        mode="base_color",
    )
    rows, columns = np.nonzero(picture.actor == 1)
    top, bottom, left, right = rows.min() + 8, rows.max() - 8, columns.min() + 8, columns.max() - 8
    seen = {
        (row, column): tuple(int(c) for c in picture.rgb[row, column])
        for row in (top, bottom)
        for column in (left, right)
    }
    assert sorted(seen.values()) == sorted([(200, 0, 0), (0, 200, 0), (0, 0, 200), (99, 99, 99)])
    assert seen[top, left] == (200, 0, 0) and seen[bottom, right] == (99, 99, 99)


def test_the_same_scene_gives_the_same_bytes_with_any_number_of_threads() -> None:
    rng = np.random.default_rng(5)
    boxes = [
        _box(
            tuple(rng.uniform(-400, 400, 3)),
            tuple(rng.uniform(20, 150, 3)),
            (RED, GREEN, BLUE)[n % 3],
            n,
            tuple(rng.uniform(-180, 180, 3)),
        )
        for n in range(60)
    ]
    lights = Lights(local=(LocalLight((0, 0, 300), intensity_cd=20),))
    camera = Camera((-900, 0, 300), look_at((-900, 0, 300), (0, 0, 0)), 70, 161, 91)
    pictures = []
    for threads in (1, 2, 3, 2):
        renderer = Renderer([CUBE], boxes, lights, threads=threads)
        pictures += [renderer.render(camera), renderer.render(camera)]
        renderer.close()
    for picture in pictures[1:]:
        assert (picture.rgb == pictures[0].rgb).all()
        assert (picture.actor == pictures[0].actor).all()
        assert picture.depth_cm.tobytes() == pictures[0].depth_cm.tobytes()


def _mean_luminance(picture: Picture, actor: int) -> float:
    return float(picture.rgb[picture.actor == actor].mean())


@pytest.mark.parametrize("scale", [(1, 1, 1), (-1, 1, 1), (1, -1, 1), (1, 1, -1), (-1, -1, -1), (-2, 0.5, 1)])
def test_mirrored_and_stretched_instances_are_lit_on_the_side_of_the_light(scale: tuple[float, ...]) -> None:
    matrix = affine((0, 0, 0), (0, 0, 0), scale)
    instance = Instance(0, matrix, (WHITE,) * 6, 0)
    above = _take([instance], Camera((0, 0, 500), (-90, 0, 0), 30, 32, 32), SUN_ONLY)
    below = _take([instance], Camera((0, 0, -500), (90, 0, 0), 30, 32, 32), SUN_ONLY)
    assert above.rgb[16, 16].min() > 150
    assert below.rgb[16, 16].max() < 60


def test_a_slanted_surface_under_uneven_scale_has_its_true_normal() -> None:
    slope = np.array([[0, 0, 0], [100, 0, 100], [100, 100, 100], [0, 100, 0]], np.float32) - np.float32(50)
    normal = np.tile(np.array([-1, 0, 1], np.float32) / np.float32(math.sqrt(2)), (4, 1))
    mesh = Mesh(
        slope, np.array([[0, 1, 2], [0, 2, 3]], np.int32), normal, np.zeros((4, 2), np.float32), np.zeros(2, np.int32)
    )
    camera = Camera((0, 0, 800), (-90, 0, 0), 20, 32, 32)

    def shade(scale: tuple[float, float, float]) -> float:
        renderer = Renderer([mesh], [Instance(0, affine((0, 0, 0), (0, 0, 0), scale), (WHITE,), 0)], SUN_ONLY, 1)
        return float(renderer.render(camera).rgb[16, 16, 1])

    flat, steep = shade((3, 1, 0.3)), shade((1, 1, 3))
    assert flat > shade((1, 1, 1)) + 10 > steep + 20


def test_a_box_shades_the_floor_and_glass_does_not() -> None:
    floor, camera = _box((0, 0, -5), (2000, 2000, 10), WHITE, 0), Camera((-400, 0, 120), (-15, 0, 0), 60, 96, 64)
    column, row = (int(value) for value in _pixel(camera, np.array([0.0, 0.0, 0.0])))

    def brightness(material: SurfaceMaterial) -> int:
        return int(_take([floor, _box((0, 0, 300), (200, 200, 10), material, 1)], camera, SUN_ONLY).rgb[row, column, 1])

    assert brightness(WHITE) < 40
    assert brightness(SurfaceMaterial(opacity=0.3)) > 150


def test_glass_shows_what_is_behind_and_the_mask_names_it() -> None:
    glass = SurfaceMaterial(base_color=(0.2, 0.2, 0.2), opacity=0.2)
    scene = [_box((200, 0, 0), (4, 150, 150), glass, 1), _box((400, 0, 0), (50, 100, 100), RED, 2)]
    camera = Camera((0, 0, 0), hfov_deg=40, width=48, height=48)
    picture = _take(scene, camera, mode="base_color")
    assert picture.actor[24, 24] == 2
    assert int(picture.rgb[24, 24, 0]) > 2 * int(picture.rgb[24, 24, 1])
    assert (
        _take(
            [_box((200, 0, 0), (4, 150, 150), SurfaceMaterial(opacity=0.6), 1), scene[1]], camera, mode="base_color"
        ).actor[24, 24]
        == 1
    )


def test_corners_are_darker_than_open_walls() -> None:
    room = [
        _box((0, 0, -5), (800, 800, 10), WHITE, 0),
        _box((205, 0, 100), (10, 800, 400), WHITE, 1),
        _box((0, 205, 100), (800, 10, 400), WHITE, 2),
    ]
    lights = Lights(sun=None, sky=Sky((1, 1, 1), (1, 1, 1), (1, 1, 1)), camera_fill=0.0, exposure_ev=0.0)
    camera = Camera((-200, 100, 150), (-15, 0, 0), 70, 120, 80)
    picture = _take(room, camera, lights)

    def at(point: tuple[float, float, float]) -> int:
        column, row = _pixel(camera, np.array(point))
        return int(picture.rgb[int(row), int(column), 1])

    assert at((198, 40, 3)) < at((120, 40, 0)) - 10


def test_a_spot_light_lights_its_cone_only_and_falls_off() -> None:
    floor = _box((0, 0, -5), (3000, 3000, 10), WHITE, 0)
    spot = LocalLight((0, 0, 300), intensity_cd=30, direction=(0, 0, -1), inner_cone_deg=15, outer_cone_deg=25)
    dark = Lights(sun=None, sky=Sky(intensity=0.0), ambient=(0, 0, 0), camera_fill=0.0, exposure_ev=0.0)
    camera = Camera((0, 0, 290), (-90, 0, 0), 90, 64, 64)
    lit = _take([floor], camera, Lights(**{**vars(dark), "local": (spot,)}))
    assert lit.rgb[32, 32].min() > 120 and lit.rgb[32, 5].max() == 0
    far = _take(
        [floor],
        camera,
        Lights(**{**vars(dark), "local": (LocalLight((0, 0, 300), intensity_cd=30, attenuation_radius=290),)}),
    )
    assert far.rgb.max() == 0


def test_emissive_surfaces_shine_in_the_dark() -> None:
    dark = Lights(sun=None, sky=Sky(intensity=0.0), ambient=(0, 0, 0), camera_fill=0.0, exposure_ev=0.0)
    lamp = SurfaceMaterial(base_color=(0, 0, 0), emissive=(2.0, 1.0, 0.2))
    scene = [_box((200, -60, 0), (50, 50, 50), lamp, 0), _box((200, 60, 0), (50, 50, 50), WHITE, 1)]
    picture = _take(scene, Camera((0, 0, 0), width=64, height=48), dark)
    assert _mean_luminance(picture, 0) > 120 and _mean_luminance(picture, 1) < 25


def test_automatic_exposure_keeps_a_dim_room_and_a_bright_yard_readable() -> None:
    floor, camera = _box((0, 0, -5), (4000, 4000, 10), WHITE, 0), Camera((-300, 0, 200), (-30, 0, 0), 70, 64, 48)
    for strength in (0.3, 3.0, 60.0):
        lights = Lights(sun=Sun(intensity=strength), sky=Sky(intensity=strength / 4))
        assert 90 < _mean_luminance(_take([floor], camera, lights), 0) < 225
    plain = _mean_luminance(_take([floor], camera), 0)
    assert _mean_luminance(_take([floor], camera, exposure_bias_ev=-2.0), 0) < plain - 40


def test_more_samples_smooth_edges_and_leave_the_mask_alone() -> None:
    scene, camera = [_box((300, 0, 0), (100, 100, 100), WHITE, 1, (0, 0, 20))], Camera((0, 0, 0), width=96, height=72)
    one, four = (_take(scene, camera, mode="base_color", samples=samples) for samples in (1, 4))
    assert (one.actor == four.actor).all() and len(np.unique(four.rgb)) > len(np.unique(one.rgb))


def test_far_from_the_origin_nothing_changes() -> None:
    def picture_at(x: float) -> Picture:
        scene = [_box((x + 300, 0, 0), (100, 100, 100), RED, 0), _box((x + 300, 0, -55), (900, 900, 10), WHITE, 1)]
        return _take(scene, Camera((x, 0, 60), (-10, 0, 0), width=64, height=48))

    near, far = picture_at(0.0), picture_at(5_000_000.0)
    assert (near.actor == far.actor).all() and (near.rgb == far.rgb).all()


def test_slots_without_materials_and_flat_instances_are_harmless() -> None:
    flat = Instance(0, affine((200, 0, 0), (0, 0, 0), (0, 1, 1)), (RED,) * 6, 1)
    bare = Instance(0, affine((300, 0, 0), (0, 0, 0), (1, 1, 1)), (), 2)
    picture = _take([flat, bare], Camera((0, 0, 0), width=32, height=32), mode="base_color")
    assert set(np.unique(picture.actor)) == {-1, 2}
    assert len(np.unique(picture.rgb[picture.actor == 2])) <= 3


@pytest.mark.parametrize(
    ("meshes", "instances", "words"),
    [
        ([Mesh(CUBE.vertices, CUBE.faces[:0], CUBE.normals, CUBE.uvs, CUBE.face_slots[:0])], [], "no triangles"),
        ([Mesh(CUBE.vertices, CUBE.faces + 1, CUBE.normals, CUBE.uvs, CUBE.face_slots)], [], "beyond"),
        (
            [Mesh(CUBE.vertices * np.float32("nan"), CUBE.faces, CUBE.normals, CUBE.uvs, CUBE.face_slots)],
            [],
            "not finite",
        ),
        ([CUBE], [Instance(0, np.full((4, 4), np.nan), (), 0)], "not 4x4 and finite"),
        ([CUBE], [Instance(1, np.eye(4), (), 0)], "names mesh 1"),
        ([CUBE], [Instance(0, np.eye(4), (SurfaceMaterial(roughness=math.nan),), 0)], "material"),
    ],
)
def test_what_cannot_be_drawn_is_refused_in_one_line(meshes: list[Mesh], instances: list[Instance], words: str) -> None:
    with pytest.raises(BadInput, match=words):
        Renderer(meshes, instances, Lights(), 1)


def test_cameras_and_lights_that_make_no_sense_are_refused() -> None:
    for bad in ({"hfov_deg": 180.0}, {"width": 0}, {"location_cm": (math.nan, 0, 0)}):
        with pytest.raises(BadInput):
            Camera(**{"location_cm": (0, 0, 0), **bad})  # type: ignore[arg-type]
    with pytest.raises(BadInput, match="light"):
        Renderer([CUBE], [], Lights(local=(LocalLight((math.inf, 0, 0)),)), 1)


def test_importing_the_renderer_loads_no_compiler() -> None:
    code = "import sys, c4s.render; print('numba' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"


def test_kept_code_in_a_read_only_folder_is_used_and_not_touched(tmp_path: Path) -> None:
    from c4s.render.compiled import code_folder

    _take([], Camera((0, 0, 0), width=4, height=4))
    here = code_folder()
    assert here is not None
    kept, scratch = tmp_path / here.name, tmp_path / "scratch"
    shutil.copytree(here, kept)
    scratch.mkdir()
    before = sorted(path.name for path in kept.rglob("*"))
    for path in [kept, *kept.rglob("*")]:
        path.chmod(stat.S_IRUSR | stat.S_IXUSR)
    code = (
        "from c4s.render import *\n"
        "from c4s import compiled as shared\n"
        "from c4s.render import compiled\n"
        "shared.writable = lambda folder: False\n"
        "Renderer([], [], Lights(), 1).render(Camera((0, 0, 0), width=4, height=4))\n"
        "from c4s.render.develop import combine_rows as kernel\n"
        "print(compiled.code_folder(), sum(kernel.stats.cache_hits.values()))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "NUMBA_CACHE_DIR": str(tmp_path), "TMPDIR": str(scratch)},
    )
    folder, hits = done.stdout.split()
    assert folder.startswith(str(scratch)) and hits == "1"
    assert sorted(path.name for path in kept.rglob("*")) == before and not list(scratch.iterdir())
