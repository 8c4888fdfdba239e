"""Maps of 0 A.D. from a made-up archive in its formats: meshes, actors, terrain, and what becomes a thing."""

from __future__ import annotations

import io
import os
import struct
import zipfile
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from c4s.errors import BadInput
from c4s.files import digest_file
from cases.importers.imported import ImportedScene
from cases.open190.slots import VARIABLE, BroughtSpec, MapPart, SceneSlot, absence
from cases.zeroad import Square, read_map
from cases.zeroad.pmd import read_pmd
from cases.zeroad.pmp import read_pmp

MAP = "maps/scenarios/hamlet.xml"
SIDE = 16
CORNERS = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def pmd(*boxes: tuple[tuple[float, float, float], tuple[float, float, float]], point: str = "") -> bytes:
    """A mesh of boxes (size and lowest corner, metres, Y up), with one point for props two metres to the east."""
    rows, faces = b"", b""
    for number, (size, low) in enumerate(boxes):
        for corner in CORNERS:
            place = [low[axis] + corner[axis] * size[axis] for axis in range(3)]
            rows += struct.pack("<8f", *place, *(corner[axis] - 0.5 for axis in range(3)), corner[0], corner[2])
            rows += struct.pack("<4B4f", *[255] * 4, *[0.0] * 4)
        for a, b, c, d in QUADS:
            faces += struct.pack("<6H", *(8 * number + one for one in (a, b, c, a, c, d)))
    body = struct.pack("<I", 8 * len(boxes)) + struct.pack("<I", 1) + rows
    body += struct.pack("<I", 12 * len(boxes)) + faces + struct.pack("<I", 0) + struct.pack("<I", bool(point))
    if point:
        body += struct.pack("<I", len(point)) + point.encode() + struct.pack("<7fB", 4, 0, 0, 0, 0, 0, 1, 255)
    return b"PSMD" + struct.pack("<II", 4, len(body)) + body


def pmp(heights: np.ndarray[tuple[int, int], np.dtype[np.uint16]]) -> bytes:
    """A terrain of one patch: grass, and a quarter of it dirt."""
    dirt = [column < SIDE // 2 and row < SIDE // 2 for row in range(SIDE) for column in range(SIDE)]
    tiles = b"".join(struct.pack("<HHI", one, 0xFFFF, 0) for one in dirt)
    body = struct.pack("<I", 1) + heights.astype("<u2").tobytes() + struct.pack("<I", 2)
    names = b"".join(struct.pack("<I", len(name)) + name for name in (b"grass", b"dirt"))
    return b"PSMP" + struct.pack("<II", 7, len(body)) + body + names + tiles


def actor(mesh: str, props: str = "", more: str = "") -> str:
    return (
        f'<actor version="1"><group><variant frequency="1"><mesh>{mesh}</mesh><textures>'
        f'<texture file="wall.png" name="baseTex"/></textures><props>{props}</props></variant>{more}</group></actor>'
    )


def within(text: str) -> str:
    """What an element holds."""
    return text.partition(">")[2].rpartition("<")[0]


def entity(template: str, x: float, z: float, uid: int) -> str:
    return (
        f'<Entity uid="{uid}"><Template>{template}</Template>'
        f'<Position x="{x}" z="{z}"/><Orientation y="3.14159265"/></Entity>'
    )


@pytest.fixture
def archive(tmp_path: Path) -> Path:
    """A hut whose foot is sunk half a metre, with a barrel beside it, and one on a slope; a soldier; a tree."""
    heights = np.full((SIDE + 1, SIDE + 1), 20 * 92, np.uint16)
    heights[:, 12:] = np.arange(5) * 2 * 92 + 20 * 92
    heights[0, 0] += 9
    told = [entity("hut", 20, 30, 1), entity("hut", 58, 30, 2), entity("units/soldier", 24, 30, 3)]
    told += [entity("actor|flora/tree.xml", 10, 10, 4), entity("nothing", 12, 12, 5), entity("hut", 900, 900, 6)]
    told += [entity("actor|flora/grass.xml", 14, 10, 7), entity("actor|vat.xml", 30, 50, 8)]
    water = "<Environment><Water><WaterBody><Height>5</Height></WaterBody></Water></Environment>"
    picture = io.BytesIO()
    Image.new("RGB", (8, 8), "brown").save(picture, format="PNG")
    files: dict[str, str | bytes] = {
        MAP: f"<Scenario>{water}<Entities>{''.join(told)}</Entities></Scenario>",
        "maps/scenarios/hamlet.pmp": pmp(heights),
        "simulation/templates/house.xml": "<Entity><VisualActor><Actor>hut.xml</Actor></VisualActor></Entity>",
        "simulation/templates/hut.xml": '<Entity parent="house"/>',
        "simulation/templates/units/soldier.xml": '<Entity parent="house"/>',
        "art/actors/hut.xml": actor("hut.dae", '<prop actor="barrel.xml" attachpoint="side"/>'),
        "art/actors/barrel.xml": actor("barrel.dae"),
        "art/actors/flora/grass.xml": actor("barrel.dae"),
        "art/actors/vat.xml": f"<qualitylevels><inline>{within(actor('barrel.dae'))}</inline></qualitylevels>",
        "art/actors/flora/tree.xml": actor("tree.dae"),
        "art/meshes/hut.dae.cached.pmd": pmd(((4, 3.5, 4), (-2, -0.5, -2)), point="side"),
        "art/meshes/barrel.dae.cached.pmd": pmd(((0.6, 1.0, 0.6), (-0.3, -0.1, -0.3))),
        "art/meshes/tree.dae.cached.pmd": pmd(((0.4, 5, 0.4), (-0.2, 0, -0.2)), ((4, 2, 4), (-2, 4, -2))),
        "art/textures/skins/wall.png": picture.getvalue(),
        "art/terrains/grass.xml": '<terrain><textures><texture name="baseTex" file="grass.png"/></textures></terrain>',
        "art/textures/terrain/grass.png": picture.getvalue(),
    }
    path = tmp_path / "public.zip"
    with zipfile.ZipFile(path, "w") as out:
        for name, data in files.items():
            out.writestr(name, data)
    return path


@pytest.fixture
def scene(archive: Path) -> ImportedScene:
    """The map of the archive."""
    return read_map(archive, MAP, Square(0, 0, SIDE))


def test_what_lives_and_what_lies_elsewhere_is_left_out(scene: ImportedScene) -> None:
    paths = {one.path for one in scene.actors}
    assert paths == {"hut_1/hut", "hut_1/barrel", "hut_2", "tree_1", "grass_1", "vat_1", "Ground"}
    assert [row["name"] for row in scene.skipped] == ["nothing"]


def test_on_level_ground_a_prop_is_a_thing_and_stands_on_the_ground(scene: ImportedScene) -> None:
    for path, tall in (("hut_1/hut", 300.0), ("hut_1/barrel", 90.0)):
        (one,) = (one for one in scene.actors if one.path == path)
        points = np.concatenate([part.vertices for part in scene.assets[one.asset].parts])
        placed = points @ one.matrix[:3, :3].T + one.matrix[:3, 3]
        assert placed[:, 2].min() == pytest.approx(0.2)
        assert float(np.ptp(placed[:, 2])) == pytest.approx(tall, abs=0.1)


def test_north_is_x_and_east_is_y(scene: ImportedScene) -> None:
    (hut,) = (one for one in scene.actors if one.path == "hut_1/hut")
    assert hut.matrix[:2, 3] == pytest.approx([-200.0, -1200.0], abs=0.01)
    (barrel,) = (one for one in scene.actors if one.path == "hut_1/barrel")
    assert barrel.matrix[:2, 3] == pytest.approx([-200.0, -800.0], abs=0.01)


def test_level_ground_is_one_slab_and_each_sloping_tile_two(scene: ImportedScene) -> None:
    assert len(scene.assets["ground"].collision) == 1 + 2 * 4 * SIDE
    (tree,) = (one for one in scene.actors if one.path == "tree_1")
    assert len(scene.assets[tree.asset].collision) == 1


def test_triangles_look_outwards(scene: ImportedScene) -> None:
    for name in ("hut_1/hut", "Ground"):
        (one,) = (one for one in scene.actors if one.path == name)
        for part in scene.assets[one.asset].parts:
            corners = part.vertices[part.faces]
            flat = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            assert (np.einsum("ij,ij->i", flat, part.normals[part.faces].sum(axis=1)) > 0).all()


def test_each_texture_of_the_ground_is_a_surface_of_its_own(scene: ImportedScene) -> None:
    parts = {part.surface.name: part for part in scene.assets["ground"].parts}
    assert {name: part.surface.texture is None for name, part in parts.items()} == {"grass": False, "dirt": True}
    area = {name: len(part.faces) / sum(len(one.faces) for one in parts.values()) for name, part in parts.items()}
    assert area["dirt"] == pytest.approx(0.25, abs=0.06)
    dirt = parts["dirt"].vertices
    assert dirt[:, :2].mean(axis=0) == pytest.approx([-1600, -1600], abs=200)


def test_grass_has_no_body(scene: ImportedScene) -> None:
    (grass,) = (one for one in scene.actors if one.path == "grass_1")
    assert not scene.assets[grass.asset].collision


def test_a_square_off_the_map_is_refused(archive: Path) -> None:
    with pytest.raises(BadInput, match="does not lie on this map"):
        read_map(archive, MAP, Square(8, 8, SIDE))


INSTALLED = Path(os.environ.get(VARIABLE, "/")) / "usr/share/games/0ad/mods/public/public.zip"


@pytest.mark.skipif(not INSTALLED.is_file(), reason="0ad-data is not installed, nor unpacked where C4S_SLOTS says")
def test_a_map_of_the_game_is_read() -> None:
    scene = read_map(INSTALLED, "maps/scenarios/sandbox_iberians.xml", Square(74, 40, 12))
    assert len(scene.actors) > 20 and not scene.skipped
    assert {part.surface.texture is None for asset in scene.assets.values() for part in asset.parts} == {False}


def test_a_slot_may_be_a_part_of_a_map(archive: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    root = archive.parent
    (root / "copyright").write_text("Hamlet, by its makers.\n")
    monkeypatch.setenv(VARIABLE, str(root))
    monkeypatch.setenv("C4S_HOME", str(root / "home"))
    slot = SceneSlot(
        scene_id="hamlet",
        in_place_of="town-square",
        environment="outdoor",
        title="A hamlet",
        manager="Debian",
        package="hamlet-data",
        version="1-1",
        install="apt install hamlet-data",
        file=archive.name,
        file_sha256=digest_file(archive),
        licence_file="copyright",
        licence="CC-BY-SA-3.0",
        map=MapPart(name=MAP, column=0, row=0, side=SIDE),
        soft=["tree*"],
    )
    assert absence(slot) is None
    pack = BroughtSpec(slot).bring(root / "packs")
    assert (pack.license, pack.ai_use) == ("CC-BY-SA-3.0", "allowed")
    assert "Hamlet, by its makers." in (root / "packs/open-hamlet/LICENSE.txt").read_text()
    place = BroughtSpec(slot).place(root / "packs")
    assert {"hut_1_hut", "hut_1_barrel", "Ground"} <= {actor.name for actor in place.level().actors}
    assert list(place.parted) == ["Ground"] and place.left_alone == {"tree_1"}
    bodies = {asset.path.rpartition("/")[2]: asset.collision for asset in pack.assets}
    soft = [name for name, its in bodies.items() if not its]
    assert soft == [name for name in bodies if "grass" in name or "tree" in name] and len(soft) == 2


def test_broken_files_are_named(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="this PMD cannot be read"):
        read_pmd(pmd(((1, 1, 1), (0, 0, 0)))[:90], "a.pmd")
    with pytest.raises(BadInput, match="another format"):
        read_pmp(b"PSMX" + bytes(12), "a.pmp")
    (tmp_path / "public.zip").write_bytes(b"no archive")
    with pytest.raises(BadInput, match="this archive cannot be read"):
        read_map(tmp_path / "public.zip", MAP, Square(0, 0, 4))
