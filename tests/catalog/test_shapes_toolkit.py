"""The toolkit builds closed parts with the sizes asked for, and a pack is read back as it was written."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.packs.store import PackStore
from c4s.trees import digest_tree
from catalog.build import build_pack
from catalog.shapes import AssetSpec, BlueprintPartSpec, BlueprintSpec, Builder, MaterialSpec, PackSpec
from catalog.shapes.patches import Patch, box, cylinder, ellipsoid, extrude, prism, tube
from catalog.shapes.textures import wood

sizes = st.tuples(*[st.floats(1, 500)] * 3)


def volume(patch: Patch) -> float:
    """Signed volume enclosed by a closed surface whose faces turn outward."""
    a, b, c = np.moveaxis(patch.vertices[patch.faces], 1, 0)
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


@settings(max_examples=30, deadline=None)
@given(sizes)
def test_boxes_have_their_size_volume_and_bottom_at_zero(size: tuple[float, float, float]) -> None:
    patch = box(size)
    np.testing.assert_allclose(np.ptp(patch.vertices, axis=0), size, rtol=1e-9)
    assert patch.vertices[:, 2].min() == pytest.approx(0, abs=1e-9)
    assert volume(patch) == pytest.approx(np.prod(size), rel=1e-6)


def test_other_solids_turn_outward_and_enclose_what_they_should() -> None:
    assert volume(cylinder(10, 20, 64)) == pytest.approx(np.pi * 100 * 20, rel=5e-3)
    assert volume(ellipsoid((10, 20, 30), 64)) == pytest.approx(4 / 3 * np.pi * 5 * 10 * 15, rel=1e-2)
    assert volume(extrude([(0, 0), (10, 0), (10, 5), (5, 5), (5, 10), (0, 10)], 3)) == pytest.approx(225)
    assert volume(prism([(-5, 0), (5, 0), (0, 6)], 10)) == pytest.approx(300)
    assert volume(tube([(0, 0, 0), (0, 0, 10), (0, 10, 20)], 1, 24)) > 0
    assert 0 < volume(box((10, 10, 10), bevel=1)) < 1000


def chair(b: Builder) -> None:
    b.box("Oak", (40, 40, 4), (0, 0, 42))
    b.box("Cloth", (36, 4, 40), (0, -18, 46), bevel=1)
    for x in (-17, 17):
        b.cylinder("Oak", 2, 42, (x, 0, 0), segments=8)


def spec(**changes: object) -> PackSpec:
    fields = {
        "pack_id": "c4s-test",
        "content_folder": "C4STest",
        "title": "Test",
        "description": "",
        "materials": [
            MaterialSpec("Oak", texture=wood((150, 110, 70), 1), tile_m=0.5),
            MaterialSpec("Cloth", (0.1, 0.2, 0.5)),
        ],
        "assets": [AssetSpec("TestChair", "seating", "A chair.", ("chair",), chair)],
        "blueprints": [
            BlueprintSpec(
                "Pair",
                "seating",
                "Two chairs.",
                (),
                (BlueprintPartSpec("TestChair"), BlueprintPartSpec("TestChair", (100, 0, 0), yaw_deg=180)),
            )
        ],
        "category_descriptions": {"seating": "Chairs"},
    } | changes
    return PackSpec(**fields)  # type: ignore[arg-type]


def test_a_pack_is_read_back_as_it_was_built(tmp_path: Path) -> None:
    pack = build_pack(spec(), tmp_path)
    store = PackStore([tmp_path / "c4s-test"])
    asset = store.asset("/Game/C4STest/Seating/SM_TestChair")
    assert asset is not None and asset.id == "test_chair" and [s.name for s in asset.slots] == ["Oak", "Cloth"]
    assert {body.kind for body in asset.collision} == {"box", "hull"}
    mesh = store.mesh(asset.path)
    np.testing.assert_allclose(mesh.bounds_cm, (asset.bounds_min_cm, asset.bounds_max_cm), atol=1e-3)
    np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=1e-3)
    back = mesh.vertices[mesh.faces[mesh.face_slots == 1].ravel()]
    assert back[:, 1].max() < -15, "the back stays at -Y: the axes are not mirrored"
    pair = store.asset(pack.assets[1].path + "_C")
    assert pair is not None and pair.bounds_max_cm[0] == pytest.approx(120)
    assert store.asset(asset.path + "_C") is None, "a static mesh has no class"
    assert "/Game/C4STest/Materials/M_Oak" in store.packages() and "/Engine/BasicShapes/Cube" in store.packages()


def test_the_same_specification_gives_the_same_bytes(tmp_path: Path) -> None:
    first, second = build_pack(spec(), tmp_path / "a"), build_pack(spec(), tmp_path / "b")
    assert first.sha256() == second.sha256() and digest_tree(tmp_path / "a") == digest_tree(tmp_path / "b")


def test_wrong_specifications_are_refused(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="no material 'Cloth'"):
        build_pack(spec(materials=[MaterialSpec("Oak")]), tmp_path)
    with pytest.raises(BadInput, match="no asset 'Ghost'"):
        build_pack(spec(blueprints=[BlueprintSpec("X", "seating", "", (), (BlueprintPartSpec("Ghost"),))]), tmp_path)
    with pytest.raises(BadInput, match="no description"):
        build_pack(spec(category_descriptions={}), tmp_path)


@pytest.mark.parametrize("content", [b"", b"glTF", b"not a mesh at all"])
def test_a_broken_mesh_file_is_one_clear_line(tmp_path: Path, content: bytes) -> None:
    pack = build_pack(spec(), tmp_path)
    (tmp_path / "c4s-test" / "meshes" / "test_chair.glb").write_bytes(content)
    with pytest.raises(BadInput, match=r"test_chair\.glb: cannot read this mesh") as error:
        PackStore([tmp_path / "c4s-test"]).mesh(pack.assets[0].path)
    assert "\n" not in error.value.line()
