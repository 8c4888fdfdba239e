"""Basic shapes, paths and broken packs."""

from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.packs.meshes import load_mesh, read_parts
from c4s.packs.store import PackStore, object_path
from c4s.records.pack import Asset, MaterialSlot, Pack
from tests.work import calls_in


@pytest.mark.parametrize("name", ["Cube", "Sphere", "Cylinder", "Cone", "Plane"])
def test_basic_shapes_are_one_metre_with_the_pivot_at_the_centre(name: str) -> None:
    store = PackStore([])
    asset = store.asset(f"/Engine/BasicShapes/{name}")
    assert asset is not None and asset.collision
    mesh = store.mesh(asset.path)
    np.testing.assert_allclose(mesh.bounds_cm, (asset.bounds_min_cm, asset.bounds_max_cm), atol=1e-3)
    assert asset.size_m == pytest.approx((1, 1, 0 if name == "Plane" else 1))
    assert store.material(asset.slots[0].material) is not None
    np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=1e-5)


@given(st.lists(st.from_regex(r"[A-Za-z][A-Za-z0-9_]{0,8}", fullmatch=True), min_size=1, max_size=4))
def test_all_forms_of_a_path_name_one_object(parts: list[str]) -> None:
    package = "/Game/" + "/".join(parts)
    wanted = f"{package}.{parts[-1]}"
    assert object_path(package) == object_path(wanted) == object_path(wanted + "_C") == wanted


def asset_of(file: str, slots: list[str]) -> Asset:
    return Asset(
        id="thing",
        name="Thing",
        path="/Game/P/Thing.Thing",
        category="c",
        bounds_min_cm=(0, 0, 0),
        bounds_max_cm=(1, 1, 1),
        mesh=file,
        slots=[MaterialSlot(name=s, material="") for s in slots],
    )


def test_node_transforms_units_and_axes_are_applied(tmp_path: Path) -> None:
    box = trimesh.creation.box((1, 2, 4))
    scene = trimesh.Scene()
    scene.add_geometry(box, transform=trimesh.transformations.translation_matrix((10, 20, 30)))
    (tmp_path / "m.glb").write_bytes(scene.export(file_type="glb"))
    part = read_parts(tmp_path / "m.glb", scale=0.5)[0]
    np.testing.assert_allclose(np.ptp(part.vertices, axis=0), (50, 200, 100))
    np.testing.assert_allclose((part.vertices.min(0) + part.vertices.max(0)) / 2, (500, 1500, 1000))
    a, b, c = np.moveaxis(part.vertices[part.faces].astype(float), 1, 0)
    assert np.einsum("ij,ij->i", a, np.cross(b, c)).sum() > 0, "the winding still turns outward"


def test_unusable_meshes_are_named(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="no such mesh file"):
        load_mesh(tmp_path, asset_of("missing.glb", []))
    (tmp_path / "empty.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\n")
    with pytest.raises(BadInput, match=r"empty\.obj"):
        load_mesh(tmp_path, asset_of("empty.obj", ["slot"]))
    (tmp_path / "tri.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    with pytest.raises(BadInput, match="no slot of the asset"):
        load_mesh(tmp_path, asset_of("tri.obj", ["Other"]))
    (tmp_path / "nan.obj").write_text("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    with pytest.raises(BadInput, match=r"nan\.obj"):
        load_mesh(tmp_path, asset_of("nan.obj", ["slot"]))


def test_missing_truncated_and_doubled_packs_are_refused(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="no such pack"):
        PackStore([tmp_path])
    (tmp_path / "pack.json").write_text('{"pack_id": ')
    with pytest.raises(BadInput, match="not valid JSON"):
        PackStore([tmp_path])
    pack = Pack(pack_id="p", content_folder="P", title="", license="", assets=[asset_of("m.glb", [])])
    for name in "ab":
        pack.write(tmp_path / name / "pack.json")
    with pytest.raises(BadInput, match="twice, or in two packs"):
        PackStore([tmp_path / "a", tmp_path / "b"])


def test_a_file_of_a_pack_is_looked_for_once(tmp_path: Path) -> None:
    asset = asset_of("m.glb", [])
    Pack(pack_id="p", content_folder="P", title="", license="", assets=[asset]).write(tmp_path / "pack.json")
    store = PackStore([tmp_path])
    assert calls_in(lambda: store.mesh_file(asset.path))["file_in"] == 1
    assert calls_in(lambda: store.mesh_file(asset.path))["file_in"] == 0
