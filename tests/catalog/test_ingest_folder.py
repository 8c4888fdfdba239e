"""Folders of mesh files become packs: real packs where they are at hand, and tiny broken files made here."""

from __future__ import annotations

import base64
import csv
import json
from collections import defaultdict
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.packs.store import PackStore
from c4s.trees import digest_tree
from catalog.ingest.collision import collision_of
from catalog.ingest.excess import corners_of
from catalog.ingest.folder import ingest
from catalog.ingest.hulls import MAX_VERTICES, bodies, hull, joined
from catalog.ingest.source import read_source
from catalog.ingest.units import check_units
from tests.shared import SHARED

ASSETS = SHARED / "assets"
PACKS = sorted(path for path in (ASSETS / "packs").glob("*") if path.is_dir())
EVERY = 9
"""Of this many files of a real pack one is given the bodies that its surface tells: cutting them all takes minutes."""


def gltf(
    path: Path,
    *,
    texture: str | None = None,
    draco: bool = False,
    nodes: list[dict[str, Any]] | None = None,
    points: np.ndarray[Any, Any] | None = None,
) -> None:
    """A glTF file with one box of 1 x 2 x 3 m under the given nodes."""
    box = trimesh.creation.box(extents=(1, 2, 3))
    vertices = np.asarray(box.vertices if points is None else points, np.float32)
    faces = np.asarray(box.faces, np.uint16)
    primitive: dict[str, Any] = {"attributes": {"POSITION": 0}, "indices": 1, "material": 0}
    tree: dict[str, Any] = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": nodes or [{"mesh": 0, "name": "box"}],
        "meshes": [{"name": "box", "primitives": [primitive]}],
        "accessors": [
            {
                "componentType": 5126,
                "count": len(vertices),
                "type": "VEC3",
                "min": vertices.min(axis=0).tolist(),
                "max": vertices.max(axis=0).tolist(),
            },
            {"componentType": 5123, "count": faces.size, "type": "SCALAR"},
        ],
        "materials": [{"name": "paint", "pbrMetallicRoughness": {"baseColorFactor": [1.0, 0.25, 0.0, 1.0]}}],
    }
    if draco:
        import DracoPy

        data = DracoPy.encode(vertices, faces.astype(np.uint32))
        primitive["extensions"] = {"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {"POSITION": 0}}}
        tree |= {
            "extensionsUsed": ["KHR_draco_mesh_compression"],
            "extensionsRequired": ["KHR_draco_mesh_compression"],
            "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": len(data)}],
        }
    else:
        data = vertices.tobytes() + faces.tobytes()
        tree["bufferViews"] = [
            {"buffer": 0, "byteOffset": 0, "byteLength": vertices.nbytes},
            {"buffer": 0, "byteOffset": vertices.nbytes, "byteLength": faces.nbytes},
        ]
        tree["accessors"][0]["bufferView"], tree["accessors"][1]["bufferView"] = 0, 1
    tree["buffers"] = [
        {"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}
    ]
    if texture:
        tree |= {"images": [{"uri": texture}], "textures": [{"source": 0}]}
        tree["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    path.write_text(json.dumps(tree))


@pytest.fixture
def source(tmp_path: Path) -> Path:
    folder = tmp_path / "source"
    folder.mkdir()
    return folder


def asset_of(report: dict[str, Any], index: int = 0) -> Any:
    return PackStore([Path(report["folder"])]).packs[Path(report["folder"])].assets[index]


@pytest.mark.skipif(not PACKS, reason="the shared sample packs are not here")
@pytest.mark.parametrize("folder", PACKS, ids=lambda path: str(path.name))
def test_every_file_of_a_real_pack_has_its_listed_size(folder: Path, tmp_path: Path) -> None:
    report = ingest(folder, folder.name, tmp_path, hulls="asset")
    assert report["skipped"] == [] and report["license"] == "CC0-1.0"
    store = PackStore([tmp_path / folder.name])
    sizes = {asset.mesh: asset for asset in store.packs[tmp_path / folder.name].assets}
    with (ASSETS / "packs.csv").open() as file:
        rows = [row for row in csv.DictReader(file) if row["pack"] == folder.name]
    listed = defaultdict(list)
    for row in rows:
        stem = Path(row["file"]).stem.replace("-", "_")
        listed[f"meshes/{(stem + '_Mesh' if stem.endswith('_C') else stem).lower()}.glb"].append(
            [float(row[f"size_{axis}_authored"]) for axis in "xzy"]
        )
    assert len(rows) == len(sizes)
    for mesh, wanted in listed.items():
        assert any(np.allclose(sizes[mesh].size_m, one, atol=2e-3) for one in wanted), mesh
    assert all(
        store.mesh(asset.path).bounds_cm[0] == pytest.approx(asset.bounds_min_cm, abs=0.01) for asset in sizes.values()
    )


@pytest.mark.skipif(not PACKS, reason="the shared sample packs are not here")
@pytest.mark.parametrize("folder", PACKS, ids=lambda path: str(path.name))
def test_the_bodies_that_a_surface_tells_reach_as_far_as_the_mesh(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path))
    with (ASSETS / "packs.csv").open() as file:
        names = sorted(row["file"] for row in csv.DictReader(file) if row["pack"] == folder.name)
    for name in names[::EVERY]:
        (path,) = (found for found in folder.rglob(Path(name).name) if found.is_file())
        made = collision_of(path, folder, read_source(path, folder).parts, "auto")
        mesh = joined([(part.node, part.vertices, part.faces) for part in made.shown])[0]
        corners = np.concatenate([corners_of(body) for body in made.bodies])
        within = 1.0 + 0.05 * float(np.linalg.norm(np.ptp(mesh, axis=0)))
        assert np.allclose(corners.min(axis=0), mesh.min(axis=0), atol=within, rtol=0), name
        assert np.allclose(corners.max(axis=0), mesh.max(axis=0), atol=within, rtol=0), name


@pytest.mark.skipif(not PACKS, reason="the shared sample packs are not here")
@pytest.mark.parametrize(("name", "low", "high"), [("kaykit-city-builder", 4.0, 6.0), ("kaykit-furniture", 0.6, 0.75)])
def test_a_scale_is_proposed_near_the_known_one(name: str, low: float, high: float) -> None:
    with (ASSETS / "packs.csv").open() as file:
        sizes = [
            (Path(row["file"]).stem, max(float(row[f"size_{axis}_authored"]) for axis in "xyz"))
            for row in csv.DictReader(file)
            if row["pack"] == name
        ]
    proposed = check_units(sizes).proposed
    assert proposed is not None and low <= proposed <= high
    assert check_units((stem, side * proposed) for stem, side in sizes).proposed is None


def test_bad_files_are_named_and_the_rest_is_kept(source: Path, tmp_path: Path) -> None:
    gltf(source / "good.gltf")
    (source / "truncated.glb").write_bytes(b"glTF\x02\x00\x00\x00\xff\x00")
    (source / "empty.obj").write_text("# nothing\n")
    (source / "point.obj").write_text("v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n")
    (source / "nan.obj").write_text("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    (source / "far.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")
    (source / "text.dae").write_text("no xml")
    report = ingest(source, "mixed", tmp_path)
    assert report["assets"] == 1 and report["files"] == 7
    assert {row["file"] for row in report["skipped"]} == {
        "truncated.glb",
        "empty.obj",
        "point.obj",
        "nan.obj",
        "far.obj",
        "text.dae",
    }
    assert all(row["reason"] for row in report["skipped"])


def test_nothing_usable_is_bad_input_and_leaves_no_pack(source: Path, tmp_path: Path) -> None:
    (source / "broken.glb").write_bytes(b"glTF")
    with pytest.raises(BadInput, match=r"none of 1 mesh files can be used; broken\.glb"):
        ingest(source, "broken", tmp_path / "packs")
    assert list((tmp_path / "packs").iterdir()) == []
    with pytest.raises(BadInput, match="no mesh files"):
        ingest(tmp_path / "packs", "none", tmp_path)


@pytest.mark.parametrize(("pack_id", "scale"), [("../out", 1.0), ("Upper", 1.0), ("fine", 0.0), ("fine", float("nan"))])
def test_bad_ids_and_scales_are_bad_input(source: Path, tmp_path: Path, pack_id: str, scale: float) -> None:
    gltf(source / "box.gltf")
    with pytest.raises(BadInput):
        ingest(source, pack_id, tmp_path, scale=scale)


@pytest.mark.parametrize("draco", [False, True])
def test_nested_nodes_are_applied(source: Path, tmp_path: Path, draco: bool) -> None:
    turn = [0.0, 0.7071067811865476, 0.0, 0.7071067811865476]
    gltf(
        source / "box.gltf",
        draco=draco,
        nodes=[
            {"children": [1], "scale": [2, 2, 2]},
            {"mesh": 0, "name": "box", "translation": [5, 0, 0], "rotation": turn},
        ],
    )
    asset = asset_of(ingest(source, "nested", tmp_path, scale=0.5))
    assert asset.size_m == pytest.approx((3, 1, 2), abs=2e-3)
    assert asset.bounds_min_cm[0] == pytest.approx(350, abs=0.2)


def test_a_missing_texture_is_named_and_the_plain_colour_used(source: Path, tmp_path: Path) -> None:
    gltf(source / "box.gltf", texture="wood.png")
    report = ingest(source, "bare", tmp_path)
    assert any("wood.png" in row["note"] for row in report["notes"])
    material = PackStore([tmp_path / "bare"]).material(asset_of(report).slots[0].material)
    assert material is not None and material.texture is None
    assert material.base_color == pytest.approx((1.0, 0.25, 0.0), abs=0.01)


def test_textures_are_found_by_their_ending_and_nothing_outside_is_read(source: Path, tmp_path: Path) -> None:
    from PIL import Image

    Image.new("RGB", (4, 4), (200, 100, 50)).save(tmp_path / "secret.png")
    (source / "art").mkdir()
    Image.new("RGB", (4, 4), (20, 100, 50)).save(source / "art" / "Wood.PNG")
    gltf(source / "a.gltf", texture="C:/artist/art/wood.png")
    gltf(source / "b.gltf", texture="../secret.png")
    report = ingest(source, "found", tmp_path / "packs")
    store = PackStore([tmp_path / "packs" / "found"])
    first, second = (store.material(asset_of(report, i).slots[0].material) for i in (0, 1))
    assert first is not None and first.texture is not None
    assert second is not None and second.texture is None
    assert [row["file"] for row in report["notes"] if "secret" in row["note"]] == ["b.gltf"]


def test_dae_units_and_axes_are_applied(source: Path, tmp_path: Path) -> None:
    data = trimesh.exchange.dae.export_collada(trimesh.creation.box(extents=(100, 200, 300))).decode()
    start, end = data.index("<asset>"), data.index("</asset>")
    asset = '<asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis>'
    (source / "box.dae").write_text(data[:start] + asset + data[end:])
    assert asset_of(ingest(source, "dae", tmp_path)).size_m == pytest.approx((1, 2, 3), abs=1e-3)


def test_the_same_folder_gives_the_same_bytes(source: Path, tmp_path: Path) -> None:
    gltf(source / "box_a.gltf")
    gltf(source / "box_b.gltf", points=np.asarray(trimesh.creation.box().vertices) * 2)
    (source / "LICENSE").write_text("MIT License\n")
    one, two = ingest(source, "same", tmp_path / "1"), ingest(source, "same", tmp_path / "2")
    assert one["sha256"] == two["sha256"] and one["license"] == "MIT"
    assert digest_tree(tmp_path / "1" / "same") == digest_tree(tmp_path / "2" / "same")
    assert asset_of(one).category == "box"


@given(st.lists(st.tuples(*[st.floats(-1000, 1000)] * 3), min_size=1, max_size=60))
def test_a_hull_holds_its_points_and_adds_little(points: list[tuple[float, float, float]]) -> None:
    cloud = np.asarray(points)
    corners = np.asarray(hull(cloud).vertices)
    assert (corners.min(axis=0) <= cloud.min(axis=0) + 2e-3).all()
    assert (corners.max(axis=0) <= cloud.max(axis=0) + 0.2).all()
    assert np.linalg.matrix_rank(corners - corners[0], tol=1e-3) == 3


def test_hulls_an_asset_a_node_or_a_piece() -> None:
    legs = [trimesh.creation.box(transform=trimesh.transformations.translation_matrix([x, 0, 0])) for x in (0, 50)]
    joined = trimesh.util.concatenate(legs)
    part = ("table", np.asarray(joined.vertices, float), np.asarray(joined.faces))
    assert [len(bodies([part, ("other", *part[1:])], per)) for per in ("asset", "node", "piece")] == [1, 2, 2]
    ball = trimesh.creation.icosphere(subdivisions=4, radius=50)
    assert len(hull(np.asarray(ball.vertices)).vertices) <= MAX_VERTICES
