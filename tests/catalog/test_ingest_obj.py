"""OBJ files and their material libraries, held against Assimp where that reads the same thing."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from c4s.errors import BadInput
from catalog.ingest.polygons import triangulated
from catalog.ingest.source import read_source
from catalog.ingest.surface import Source, SourcePart, linear
from tests.catalog import assimp

SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
TEXTURED = SQUARE + "usemtl paint\nf 1/1 2/2 3/3 4/4\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    place = tmp_path / "art"
    place.mkdir()
    return place


def read(folder: Path, text: str, mtl: str | None = None, name: str = "thing.obj") -> Source:
    (folder / name).parent.mkdir(exist_ok=True, parents=True)
    (folder / name).write_text(text)
    if mtl is not None:
        (folder / "thing.mtl").write_text(mtl)
    return read_source(folder / name, folder)


def area(part: SourcePart) -> float:
    """Square metres."""
    corners = part.vertices[part.faces] / 100
    return (
        float(np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()) / 2
    )


def areas(source: Source) -> dict[str, float]:
    found: dict[str, float] = {}
    for part in source.parts:
        found[part.surface.name] = round(found.get(part.surface.name, 0.0) + area(part), 6)
    return found


def paint(folder: Path, name: str, color: tuple[int, ...], mode: str = "RGB", size: int = 4) -> None:
    (folder / name).parent.mkdir(exist_ok=True, parents=True)
    Image.new(mode, (size, size), color).save(folder / name)


def pixels(png: bytes | None) -> Image.Image:
    assert png is not None
    return Image.open(io.BytesIO(png))


STRIPS = (
    "mtllib thing.mtl\no Box\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 0 0\nv 3 1 0\n"
    "usemtl red\nf 1 2 3 4\nusemtl green\nf 2 5 6 3\nusemtl red\nf 5 7 8 6\n"
)


def test_each_face_keeps_its_material_in_one_object(folder: Path, tmp_path: Path) -> None:
    source = read(folder, STRIPS, "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\n")
    assert areas(source) == {"red": 2.0, "green": 1.0}
    assert [part.surface.color for part in source.parts] == [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
    theirs: dict[str, int] = {}
    for mesh in assimp.read(folder / "thing.obj", tmp_path):
        theirs[mesh.material] = theirs.get(mesh.material, 0) + len(mesh.corners)
    assert theirs == {"red": 4, "green": 2}


def test_objects_are_pieces_and_groups_are_where_there_is_no_object(folder: Path) -> None:
    groups = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\ng left\nf 1 2 3\ng right side\nf 1 2 4\ng left\nf 2 3 4\n"
    source = read(folder, groups)
    assert [(part.node, len(part.faces)) for part in source.parts] == [("left", 2), ("right side", 1)]
    source = read(folder, groups.replace("g left\nf 1 2 3", "o whole\ng left\nf 1 2 3"))
    assert [(part.node, len(part.faces)) for part in source.parts] == [("whole", 3)]


def test_what_a_face_names_may_be_negative_and_lines_may_go_on(folder: Path) -> None:
    plain = read(folder, SQUARE + "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\nv 5 0 0\nv 5 1 0\nv 6 0 0\nf 5 6 7\n")
    turned = read(
        folder,
        "\ufeff" + SQUARE.replace("v 1 1 0", "v 1 \\\n 1 0") + "vn 0 0 1\nf -4/-4/-1 \\\n -3/-3/-1 -2/-2/-1\t-1/-1/-1\n"
        "v 5 0 0  # far\r\nv 5 1 0\nv 6 0 0\nf -3//1 -2//1 -1//1\n",
    )
    assert sum(area(part) for part in plain.parts) == pytest.approx(1.5)
    assert np.array_equal(plain.parts[0].vertices, turned.parts[0].vertices)
    assert np.array_equal(plain.parts[0].uvs, turned.parts[0].uvs)


def test_corners_of_every_form_in_one_file(folder: Path) -> None:
    source = read(
        folder, SQUARE + "vn 0 0 1\nf 1 2 3\nf 1/1 2/2 3/3\nf 1//1 3//1 4//1\nf 1/1/1 3/3/1 4/4/1\nf 1/1/ 2 3//1\n"
    )
    assert len(source.parts[0].faces) == 5


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "does not exist"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 2 3\n", "does not exist"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "does not exist"),
        ("v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "less than three"),
        ("v 0 0 x\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "malformed"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf a b c\n", "no number"),
        ("v 0 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n", "not finite"),
        ("v 0 0 0\nv 1 0 0\nl 1 2\n", "no triangles"),
    ],
)
def test_a_broken_file_is_bad_input(text: str, said: str, folder: Path) -> None:
    with pytest.raises(BadInput, match=said):
        read(folder, text)


def test_lines_and_points_and_wrong_texture_coordinates_are_noted(folder: Path) -> None:
    source = read(folder, SQUARE + "l 1 2\np 1\nf 1/9 2/2 3/3\n")
    assert source.notes == [
        "1 lines are left out",
        "1 points are left out",
        "1 texture coordinates that do not exist are left out",
    ]


def test_normals_follow_smoothing_groups_where_none_are_written(folder: Path) -> None:
    roof = "v 0 0 0\nv 1 0 0\nv 1 0 2\nv 0 0 2\nv 2 1 0\nv 2 1 2\n"
    flat = read(folder, f"{roof}f 1 2 3 4\nf 2 5 6 3\n").parts[0]
    assert len(flat.vertices) == 8
    assert len(read(folder, f"{roof}s off\nf 1 2 3 4\nf 2 5 6 3\n").parts[0].vertices) == 8
    assert len(read(folder, f"{roof}s 1\nf 1 2 3 4\ns 2\nf 2 5 6 3\n").parts[0].vertices) == 8
    smooth = read(folder, f"{roof}s 1\nf 1 2 3 4\nf 2 5 6 3\n").parts[0]
    assert len(smooth.vertices) == 6
    shared = smooth.normals[np.isclose(smooth.vertices[:, 0], 100)]
    assert np.allclose(np.abs(shared @ [0, 0, 1]), 2 / np.hypot(2, 1), atol=1e-5), "between the two faces, by area"
    written = read(folder, f"{roof}vn 1 0 0\nvn 0 0 0\ns 1\nf 1//1 2//1 3//2 4\n").parts[0]
    turned = {tuple(np.round(normal, 3).tolist()) for normal in written.normals}
    assert turned == {(1.0, 0.0, 0.0), (0.0, 0.0, -1.0)}, "a written normal of no length is made"


def test_colours_of_vertices_multiply_the_material(folder: Path, tmp_path: Path) -> None:
    text = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0.5\nf 1 2 3\n"
    plain = read(folder, text).parts[0]
    assert plain.colors is not None
    assert plain.surface.color == (1.0, 1.0, 1.0)
    theirs = assimp.read(folder / "thing.obj", tmp_path)[0].colors
    assert theirs is not None
    ours = plain.colors[plain.faces[:, ::-1]]
    assert np.allclose(
        np.sort(ours.reshape(-1, 3), axis=0), np.sort([[linear(c) for c in row[:3]] for row in theirs[0]], axis=0)
    )
    many = text.replace(" 1 0 0\n", " 255 0 0\n", 1).replace("0.5", "128")
    assert np.allclose(
        np.asarray(read(folder, many).parts[0].colors).max(axis=0), [1.0, linear(1 / 255), linear(128 / 255)]
    )
    white = read(
        folder, text.replace("1 0 0\nv", "1 1 1\nv", 1).replace("0 1 0\nv", "1 1 1\nv", 1).replace("0 0 0.5", "1 1 1")
    )
    assert white.parts[0].colors is None or np.ptp(white.parts[0].colors) > 0


def test_textures_lie_as_their_options_say(folder: Path) -> None:
    paint(folder, "a picture.png", (255, 0, 0))
    plain = read(folder, "mtllib thing.mtl\n" + TEXTURED, "newmtl paint\nKd 0.2 0.2 0.2\nmap_Kd a picture.png\n").parts[
        0
    ]
    assert plain.surface.color == (1.0, 1.0, 1.0), "a texture stands in place of the colour"
    assert pixels(plain.surface.texture).getpixel((0, 0)) == (255, 0, 0)
    moved = read(
        folder,
        "mtllib thing.mtl\n" + TEXTURED,
        "newmtl paint\n\tmap_Kd -blendu on -o 0.25 0.5 -s 2 4 1 -mm 0 1 a picture.png -bm 0.2\n",
    ).parts[0]
    expected = (plain.uvs * [1, -1] + [0, 1]) * [2, 4] + [0.25, 0.5]
    assert np.allclose(moved.uvs * [1, -1] + [0, 1], expected)
    assert moved.surface.texture == plain.surface.texture
    tile = read(folder, "mtllib thing.mtl\n" + TEXTURED, "newmtl paint\nmap_Kd -s 3 a picture.png\n").parts[0]
    assert np.allclose(tile.uvs[:, 0], plain.uvs[:, 0] * 3)


def test_opacity_comes_from_a_number_a_map_or_the_picture_itself(folder: Path) -> None:
    paint(folder, "red.png", (255, 0, 0))
    half = Image.new("L", (4, 4), 0)
    half.paste(255, (0, 0, 2, 4))
    half.save(folder / "half.png")
    cut = Image.new("RGBA", (4, 4), (0, 255, 0, 255))
    cut.paste((0, 0, 0, 0), (0, 0, 2, 4))
    cut.save(folder / "leaf.png")
    paint(folder, "nothing.png", (9, 9, 9, 0), "RGBA")
    head = "mtllib thing.mtl\n" + TEXTURED

    def surface(mtl: str):  # type: ignore[no-untyped-def]
        return read(folder, head, f"newmtl paint\n{mtl}\n").parts[0].surface

    assert (surface("d 0.25").opacity, surface("Tr 0.25").opacity, surface("d 1\nTr 1").opacity) == (0.25, 0.75, 1.0)
    assert surface("d -halo 0.5").opacity == 0.5
    mapped = surface("map_Kd red.png\nmap_d half.png")
    assert mapped.alpha == "mask"
    assert pixels(mapped.texture).getpixel((0, 0)) == (255, 0, 0, 255)
    assert pixels(mapped.texture).getpixel((3, 0)) == (255, 0, 0, 0)
    alone = surface("Kd 0 0 1\nmap_d half.png")
    assert (alone.color, alone.alpha) == ((0.0, 0.0, 1.0), "mask")
    assert pixels(alone.texture).getpixel((0, 0)) == (255, 255, 255, 255)
    assert surface("map_Kd leaf.png").alpha == "mask"
    assert surface("map_Kd leaf.png\nmap_d leaf.png").texture == surface("map_Kd leaf.png").texture
    assert surface("map_Kd nothing.png").alpha == "opaque", "alpha that hides all of it means something else"
    source = read(folder, head, "newmtl paint\nd 0\n")
    assert source.notes == ["material 'paint' is wholly transparent"]


def test_physically_based_values_and_maps(folder: Path) -> None:
    paint(folder, "rough.png", (64,), "L")
    paint(folder, "metal.png", (200,), "L", 8)
    paint(folder, "normal.png", (128, 128, 255))
    paint(folder, "height.png", (90,), "L")
    paint(folder, "glow.png", (255, 255, 0))
    head = "mtllib thing.mtl\n" + TEXTURED
    plain = read(folder, head, "newmtl paint\nKd 0.5\nKe 1 0.5 0\nPr 0.3\nPm 0.9\n").parts[0].surface
    grey = round(linear(0.5), 4)
    assert plain.color == (grey, grey, grey)
    assert (plain.roughness, plain.metallic, plain.emissive) == (0.3, 0.9, (1.0, grey, 0.0))
    mapped = (
        read(
            folder,
            head,
            "newmtl paint\nmap_Pr rough.png\nmap_Pm metal.png\nmap_Bump -bm 2 normal.png\nmap_Ke glow.png\n",
        )
        .parts[0]
        .surface
    )
    assert pixels(mapped.roughness_metal_texture).getpixel((0, 0)) == (255, 64, 200)
    assert (mapped.roughness, mapped.metallic, mapped.emissive) == (1.0, 1.0, (1.0, 1.0, 1.0))
    assert mapped.normal_texture is not None
    assert mapped.emissive_texture is not None
    source = read(folder, head, "newmtl paint\nbump height.png\n")
    assert source.parts[0].surface.normal_texture is None
    assert source.notes == ["material 'paint': its bump map is left out"]


@pytest.mark.parametrize(
    "named",
    [
        "thing.mtl",
        "./thing.mtl",
        "C:\\art\\models\\thing.mtl",
        "/home/someone/thing.mtl",
        "lib\\Thing.MTL",
        "other.mtl thing.mtl",
        "gone.mtl",
    ],
)
def test_material_libraries_are_found(named: str, folder: Path) -> None:
    (folder / "other.mtl").write_text("newmtl other\nKd 0 0 1\n")
    source = read(folder, f"mtllib {named}\n{TEXTURED}", "newmtl paint\nKd 1 0 0\n")
    assert source.parts[0].surface.color == (1.0, 0.0, 0.0)
    assert source.notes == (["file 'gone.mtl' is missing: thing.mtl is read"] if named == "gone.mtl" else [])


def test_libraries_with_blanks_several_lines_and_their_own_folder(folder: Path) -> None:
    paint(folder, "tex/wood.png", (10, 20, 30))
    paint(folder, "wood.png", (0, 0, 0))
    (folder / "tex" / "all my paints.mtl").write_text("newmtl paint\nmap_Kd wood.png\n")
    (folder / "second.mtl").write_text("newmtl red\nKd 1 0 0\n")
    text = f"mtllib tex/all my paints.mtl\nmtllib second.mtl\n{TEXTURED}usemtl red\nf 1 2 3\n"
    source = read(folder, text)
    assert pixels(source.parts[0].surface.texture).getpixel((0, 0)) == (10, 20, 30), "beside its library first"
    assert source.parts[1].surface.color == (1.0, 0.0, 0.0)


def test_what_is_missing_is_noted_and_plain(folder: Path) -> None:
    source = read(folder, f"mtllib gone.mtl\n{TEXTURED}")
    assert source.parts[0].surface.color == (0.5, 0.5, 0.5)
    assert source.notes == ["file 'gone.mtl' is missing: its materials are plain grey"]
    source = read(folder, f"mtllib thing.mtl\n{TEXTURED}", "newmtl other\nKd 1 0 0\n")
    assert source.notes == ["material 'paint' is in no library: it is plain grey"]
    source = read(folder, f"mtllib thing.mtl\n{TEXTURED}", "newmtl paint\nKd 1 0 0\nmap_Kd gone.png\n")
    assert source.parts[0].surface.color == (1.0, 0.0, 0.0)
    assert source.notes == ["file 'gone.png' is missing: the plain colour is used"]


def test_a_library_outside_the_folder_is_not_read(folder: Path, tmp_path: Path) -> None:
    (tmp_path / "secret.mtl").write_text("newmtl paint\nKd 1 0 0\n")
    source = read(folder, f"mtllib ../secret.mtl\n{TEXTURED}")
    assert source.parts[0].surface.color == (0.5, 0.5, 0.5)


def test_concave_polygons_are_filled_and_nothing_else(folder: Path, tmp_path: Path) -> None:
    arrow = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 3 1 0\nf 1 2 3 4\n"
    assert areas(read(folder, arrow)) == {"plain": pytest.approx(4.0)}
    keyhole = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\nf 1 2 3 4 1 5 6 7 8 5\n"
    assert areas(read(folder, keyhole)) == {"plain": pytest.approx(12.0)}, "a square with a hole, joined by a cut"
    comb = [
        (0, 0),
        (9, 0),
        (9, 5),
        (8, 5),
        (8, 1),
        (6, 1),
        (6, 5),
        (5, 5),
        (5, 1),
        (3, 1),
        (3, 5),
        (2, 5),
        (2, 1),
        (0, 1),
    ]
    text = "".join(f"v {x} 0.5 {y}\n" for x, y in comb) + f"f {' '.join(str(i + 1) for i in range(len(comb)))}\n"
    assert areas(read(folder, text)) == {"plain": pytest.approx(9 + 3 * 4)}
    theirs = assimp.read(folder / "thing.obj", tmp_path)[0].corners
    assert np.linalg.norm(
        np.cross(theirs[:, 1] - theirs[:, 0], theirs[:, 2] - theirs[:, 0]), axis=1
    ).sum() / 2 == pytest.approx(21)


@given(
    st.lists(st.floats(0.2, 1.0), min_size=3, max_size=24),
    st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda axis: np.linalg.norm(axis) > 0.1),
    st.booleans(),
)
def test_triangles_of_a_star_fill_it(radii: list[float], axis: tuple[float, float, float], turned: bool) -> None:
    """Any star-shaped polygon in any plane: the signed areas are all of one sign and add up to the polygon's."""
    angles = np.arange(len(radii)) * 2 * np.pi / len(radii)
    flat = np.stack([np.cos(angles), np.sin(angles)], axis=1) * np.asarray(radii)[:, None]
    flat = flat[::-1] if turned else flat
    normal = np.asarray(axis) / np.linalg.norm(axis)
    side = np.cross(normal, np.eye(3)[int(np.argmin(np.abs(normal)))])
    side /= np.linalg.norm(side)
    points = flat @ np.stack([side, np.cross(normal, side)])
    triangles, owner = triangulated(points, np.asarray([len(points)]))
    corners = flat[triangles]
    one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    signed = (one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]) / 2
    ahead = np.roll(flat, -1, axis=0)
    whole = float((flat[:, 0] * ahead[:, 1] - flat[:, 1] * ahead[:, 0]).sum()) / 2
    assert len(triangles) == len(points) - 2
    assert not owner.any()
    assert (signed * np.sign(whole) > -1e-9).all()
    assert signed.sum() == pytest.approx(whole)


def test_a_large_file_is_read_whole(folder: Path) -> None:
    side = 200
    rows, columns = np.divmod(np.arange(side * side), side)
    text = "\n".join(f"v {x} {y} {(x * y) % 7}" for x, y in zip(columns.tolist(), rows.tolist(), strict=True))
    first = (
        (np.arange((side - 1) * (side - 1)) // (side - 1)) * side + np.arange((side - 1) * (side - 1)) % (side - 1) + 1
    )
    quads = np.stack([first, first + 1, first + side + 1, first + side], axis=1)
    faces = "\n".join("f " + " ".join(f"{corner}" for corner in quad) for quad in quads.tolist())
    source = read(folder, f"s 1\n{text}\n{faces}\n")
    assert sum(len(part.faces) for part in source.parts) == 2 * len(quads)
    assert len(source.parts[0].vertices) == side * side


REAL = sorted(Path("/usr/share/assimp/models/OBJ").glob("*.obj"))
ODD = {"box_longline.obj", "number_formats.obj", "point_cloud.obj", "testline.obj", "testpoints.obj", "regr01.obj"}


@pytest.mark.skipif(not REAL, reason="Debian's assimp-testmodels is not installed")
def test_areas_by_material_are_those_of_assimp(tmp_path: Path) -> None:
    for path in REAL:
        if path.name in ODD or "UTF16" in path.name:
            continue
        ours = sorted(areas(read_source(path, path.parent)).values())
        found: dict[str, float] = {}
        for mesh in assimp.read(path, tmp_path):
            across = np.cross(mesh.corners[:, 1] - mesh.corners[:, 0], mesh.corners[:, 2] - mesh.corners[:, 0])
            found[mesh.material] = found.get(mesh.material, 0.0) + float(np.linalg.norm(across, axis=1).sum()) / 2
        theirs = sorted(value for value in found.values() if value)
        assert ours == pytest.approx(theirs, rel=1e-3), path.name
