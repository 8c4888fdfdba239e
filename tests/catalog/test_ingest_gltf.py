"""What a glTF file may hold beyond one plain mesh, and what it does when it is broken."""

from __future__ import annotations

import io
import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image

from c4s.errors import BadInput
from catalog.ingest.source import read_source
from tests.catalog.gltf_maker import Gltf

SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]


def size_of(path: Path) -> np.ndarray[Any, Any]:
    """Size in cm over Unreal's axes: right, forward, up."""
    points = np.concatenate([part.vertices for part in read_source(path, path.parent).parts])
    return np.ptp(points, axis=0)


def outward(path: Path) -> bool:
    """Whether every triangle and every normal of a box faces away from its middle."""
    for part in read_source(path, path.parent).parts:
        corners = part.vertices[part.faces]
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        away = corners.mean(axis=1) - part.vertices.mean(axis=0)
        if (np.einsum("ij,ij->i", across, away) < 0).any():
            return False
        if (np.einsum("ij,ij->i", part.normals[part.faces[:, 0]], across) < 0).any():
            return False
    return True


@pytest.mark.parametrize(
    "node",
    [
        {},
        {"scale": [-1, 1, 1]},
        {"scale": [-1, -2, -3]},
        {"scale": [2, 0.5, 1]},
        {"matrix": [0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 5, 0, 0, 1]},
    ],
)
def test_mirrored_and_uneven_scales_keep_triangles_outward(node: dict[str, Any], tmp_path: Path) -> None:
    made = Gltf()
    made.mesh(made.box())
    made.tree["nodes"] = [{"children": [1], **node}, {"mesh": 0, "scale": [1, 1, -1], "rotation": [0, 0.6, 0, 0.8]}]
    assert outward(made.write(tmp_path / "a.gltf"))


@pytest.mark.parametrize("kind", ["uint8", "uint16", "uint32"])
@pytest.mark.parametrize(("mode", "corners"), [(4, [0, 1, 2, 0, 2, 3]), (5, [0, 1, 3, 2]), (6, [0, 1, 2, 3])])
def test_lists_strips_and_fans_of_every_index_type(mode: int, corners: list[int], kind: str, tmp_path: Path) -> None:
    made = Gltf()
    made.mesh(
        {
            "attributes": {"POSITION": made.accessor(SQUARE)},
            "mode": mode,
            "indices": made.accessor(np.array(corners)[:, None], kind),
        }
    )
    source = read_source(made.write(tmp_path / "a.glb"), tmp_path)
    assert sum(len(part.faces) for part in source.parts) == 2
    corners_cm = source.parts[0].vertices[source.parts[0].faces]
    across = np.cross(corners_cm[:, 1] - corners_cm[:, 0], corners_cm[:, 2] - corners_cm[:, 0])
    assert np.linalg.norm(across, axis=1).sum() / 2 == pytest.approx(10_000)
    assert (across @ across[0] > 0).all(), "both triangles face the same way"
    assert np.allclose(source.parts[0].normals, [0, 1, 0]), "flat normals where none are given: +Z there, +Y here"


def test_lines_and_points_are_left_out_and_named(tmp_path: Path) -> None:
    made = Gltf()
    position = made.accessor(SQUARE)
    made.mesh(
        made.box(), {"attributes": {"POSITION": position}, "mode": 1}, {"attributes": {"POSITION": position}, "mode": 0}
    )
    source = read_source(made.write(tmp_path / "a.gltf"), tmp_path)
    assert source.notes == ["mesh 'mesh0': lines are left out", "mesh 'mesh0': points are left out"]
    only = Gltf()
    only.mesh({"attributes": {"POSITION": only.accessor(SQUARE)}, "mode": 3})
    with pytest.raises(BadInput, match=r"no triangles.*lines are left out"):
        read_source(only.write(tmp_path / "b.gltf"), tmp_path)


def test_sparse_accessors_with_and_without_a_base(tmp_path: Path) -> None:
    for base in (True, False):
        made = Gltf()
        position = made.accessor(SQUARE)
        record = made.tree["accessors"][position]
        record["sparse"] = {
            "count": 2,
            "indices": {"bufferView": made.view(np.array([1, 2], "uint16").tobytes()), "componentType": 5123},
            "values": {"bufferView": made.view(np.array([[7, 0, 0], [7, 1, 0]], "float32").tobytes())},
        }
        if not base:
            del record["bufferView"]
        made.mesh({"attributes": {"POSITION": position}, "indices": made.accessor([[0], [1], [2]], "uint8")})
        assert size_of(made.write(tmp_path / "a.gltf")) == pytest.approx([700, 0, 100])


def test_quantised_positions_and_strides(tmp_path: Path) -> None:
    made = Gltf()
    rows = np.zeros((4, 4), "int16")
    rows[:, :3] = np.array(SQUARE) * 32767
    view = made.view(rows.tobytes(), byteStride=8)
    made.tree["accessors"].append(
        {"bufferView": view, "componentType": 5122, "count": 4, "type": "VEC3", "normalized": True}
    )
    made.mesh({"attributes": {"POSITION": 0}, "mode": 6})
    made.tree |= {"extensionsUsed": ["KHR_mesh_quantization"], "extensionsRequired": ["KHR_mesh_quantization"]}
    made.tree["nodes"][0]["scale"] = [3, 3, 3]
    assert size_of(made.write(tmp_path / "a.gltf")) == pytest.approx([300, 0, 300], abs=0.01)


def test_a_skin_is_shown_as_its_joints_stand_and_a_morph_by_its_weight(tmp_path: Path) -> None:
    made = Gltf()
    primitive = made.box((1, 1, 1))
    primitive["attributes"] |= {
        "JOINTS_0": made.accessor([[0, 1, 0, 0]] * 8, "uint8"),
        "WEIGHTS_0": made.accessor([[0.25, 0.25, 0, 0]] * 8),
    }
    made.mesh(primitive)
    bind = np.tile(np.eye(4, dtype="float32").reshape(1, 16), (2, 1))
    made.tree["skins"] = [{"joints": [1, 2], "inverseBindMatrices": made.accessor(bind)}]
    made.tree["nodes"] = [{"mesh": 0, "skin": 0, "scale": [9, 9, 9]}, {"translation": [0, 4, 0]}, {"scale": [3, 1, 1]}]
    made.tree["scenes"][0]["nodes"] = [0, 1]
    parts = read_source(made.write(tmp_path / "skin.gltf"), tmp_path).parts
    assert np.ptp(parts[0].vertices, axis=0) == pytest.approx([200, 100, 100]), "half of 1 and half of 3 wide"
    assert parts[0].vertices[:, 2].mean() == pytest.approx(200), "half of the way up"

    made = Gltf()
    primitive = made.box((1, 1, 1))
    primitive["targets"] = [{"POSITION": made.accessor([[0, 8, 0]] * 8)}]
    made.mesh(primitive, weights=[0.5])
    made.tree["nodes"] = [{"mesh": 0}, {"mesh": 0, "weights": [0.0]}]
    made.tree["scenes"][0]["nodes"] = [0, 1]
    made.tree["animations"] = [{"channels": [], "samplers": []}]
    source = read_source(made.write(tmp_path / "morph.gltf"), tmp_path)
    assert sorted(round(float(part.vertices[:, 2].mean())) for part in source.parts) == [0, 400]
    assert any("animations" in note for note in source.notes)


def test_only_the_default_scene_is_read_and_the_others_are_named(tmp_path: Path) -> None:
    made = Gltf()
    made.mesh(made.box((1, 1, 1)))
    made.mesh(made.box((5, 5, 5)))
    made.tree["nodes"] = [{"mesh": 0}, {"mesh": 1}]
    made.tree |= {"scenes": [{"nodes": [1], "name": "Spare"}, {"nodes": [0]}], "scene": 1}
    assert size_of(made.write(tmp_path / "a.gltf")) == pytest.approx([100, 100, 100])
    assert any("Spare" in note for note in read_source(tmp_path / "a.gltf", tmp_path).notes)


def test_instances_are_placed(tmp_path: Path) -> None:
    made = Gltf()
    made.mesh(made.box((1, 1, 1)))
    made.tree["nodes"][0]["extensions"] = {
        "EXT_mesh_gpu_instancing": {
            "attributes": {
                "TRANSLATION": made.accessor([[0, 0, 0], [0, 9, 0]]),
                "SCALE": made.accessor([[1, 1, 1], [2, 2, 2]]),
            }
        }
    }
    made.tree |= {"extensionsUsed": ["EXT_mesh_gpu_instancing"], "extensionsRequired": ["EXT_mesh_gpu_instancing"]}
    assert size_of(made.write(tmp_path / "a.gltf")) == pytest.approx([200, 200, 1050])


def test_colours_of_vertices_are_kept_or_become_the_surface(tmp_path: Path) -> None:
    made = Gltf()
    many = made.accessor([[255, 0, 0, 255]] * 4 + [[0, 0, 255, 255]] * 4, "uint8", normalized=True)
    same = made.accessor([[0.5, 0.25, 1.0]] * 8)
    box = made.box()
    made.mesh({**box, "attributes": {**box["attributes"], "COLOR_0": many}})
    made.mesh({**box, "attributes": {**box["attributes"], "COLOR_0": same}})
    made.tree["nodes"] = [{"mesh": 0}, {"mesh": 1}]
    made.tree["scenes"][0]["nodes"] = [0, 1]
    first, second = read_source(made.write(tmp_path / "a.gltf"), tmp_path).parts
    assert first.colors is not None and np.ptp(first.colors, axis=0).tolist() == [1, 0, 1]
    assert second.colors is None and second.surface.color == (0.5, 0.25, 1.0)


def picture(kind: str, mode: str = "RGBA", color: tuple[int, ...] = (200, 100, 50, 0)) -> bytes:
    out = io.BytesIO()
    Image.new(mode, (4, 4), color).save(out, format=kind)
    return out.getvalue()


def test_textures_in_the_file_webp_transforms_cut_outs_and_glow(tmp_path: Path) -> None:
    made = Gltf()
    uv = made.accessor([[0, 0], [1, 0], [1, 1], [0, 1]])
    turn = {"offset": [0.5, 0.25], "scale": [2, 4], "rotation": math.pi / 2}
    made.tree |= {
        "images": [
            {"bufferView": made.view(picture("WEBP")), "mimeType": "image/webp"},
            {"bufferView": made.view(picture("PNG", "RGB", (9, 200, 9))), "mimeType": "image/png"},
        ],
        "textures": [
            {"extensions": {"EXT_texture_webp": {"source": 0}}},
            {"source": 1},
            {"extensions": {"KHR_texture_basisu": {"source": 0}}},
        ],
        "materials": [
            {
                "name": "leaf",
                "alphaMode": "MASK",
                "emissiveFactor": [1, 1, 1],
                "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 3}},
                "emissiveTexture": {"index": 1, "extensions": {"KHR_texture_transform": turn}},
                "normalTexture": {"index": 1, "texCoord": 1},
                "pbrMetallicRoughness": {
                    "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform": turn}}
                },
            },
            {"name": "basis", "pbrMetallicRoughness": {"baseColorTexture": {"index": 2}}},
        ],
    }
    square = {"attributes": {"POSITION": made.accessor(SQUARE), "TEXCOORD_0": uv}, "mode": 6}
    made.mesh({**square, "material": 0}, {**square, "material": 1})
    source = read_source(made.write(tmp_path / "a.gltf"), tmp_path)
    leaf, basis = (part.surface for part in source.parts)
    assert leaf.texture is not None and Image.open(io.BytesIO(leaf.texture)).mode == "RGBA" and leaf.alpha == "mask"
    assert leaf.emissive == (3, 3, 3) and leaf.emissive_texture is not None and leaf.normal_texture is None
    assert basis.texture is None and leaf.name == "leaf"
    assert any("KTX2" in note for note in source.notes) and any("normal texture" in note for note in source.notes)
    corner = {
        tuple(np.round(point[[0, 2]]).astype(int)): uv
        for point, uv in zip(source.parts[0].vertices, source.parts[0].uvs, strict=True)
    }
    assert corner[0, 0] == pytest.approx([0.5, 0.25]) and corner[100, 0] == pytest.approx([0.5, -1.75])
    assert corner[0, 100] == pytest.approx([4.5, 0.25])


def test_other_material_models(tmp_path: Path) -> None:
    made = Gltf()
    made.tree["materials"] = [
        {
            "extensions": {
                "KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.1, 0.2, 0.3, 1], "glossinessFactor": 0.75}
            }
        },
        {"alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.5]}},
        {"extensions": {"KHR_materials_transmission": {"transmissionFactor": 1.0}}},
    ]
    box = made.box()
    made.mesh(*({**box, "material": index} for index in range(3)), box)
    gloss, blend, glass, plain = (part.surface for part in read_source(made.write(tmp_path / "a.gltf"), tmp_path).parts)
    assert gloss.color == (0.1, 0.2, 0.3) and gloss.roughness == 0.25 and gloss.metallic == 0
    assert blend.opacity == 0.5 and 0 < glass.opacity < 0.5
    assert plain.color == (1, 1, 1) and plain.metallic == 1 and plain.roughness == 1


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"asset": {"version": "1.0"}}, "version 1.0"),
        ({"asset": None}, "no asset record"),
        ({"extensionsRequired": ["EXT_meshopt_compression"]}, "EXT_meshopt_compression.*gltfpack"),
        ({"extensionsRequired": ["ACME_warp"]}, "ACME_warp, which is not read"),
        ({"nodes": [{"mesh": 3}]}, "meshes 3, of which there are 1"),
        ({"nodes": [{"children": [0]}]}, "hangs below itself"),
        ({"nodes": [{"mesh": 0, "rotation": [0, 0, 0, 0]}]}, "no quaternion"),
        ({"nodes": [{"mesh": 0, "scale": [1, 0, 1]}]}, "scaled to nothing"),
        ({"nodes": [{"mesh": 0, "translation": [1e300, 1e300, 1e308]}]}, "not finite"),
        ({"buffers": [{"byteLength": 10**9, "uri": "data:,x"}]}, "cut off"),
        ({"buffers": [{"byteLength": 1, "uri": "gone.bin"}]}, r"'gone\.bin' is missing"),
        ({"buffers": [{"byteLength": 1, "uri": "../../../etc/passwd"}]}, "passwd' is missing"),
        ({"accessors": [{"bufferView": 0, "componentType": 5126, "count": 10**7, "type": "VEC3"}] * 2}, "past the end"),
        ({"nodes": 5}, "no list"),
        ({"meshes": [{"primitives": [{"attributes": {}}]}]}, "no positions"),
    ],
)
def test_broken_files_are_named_with_a_reason(change: dict[str, Any], said: str, tmp_path: Path) -> None:
    made = Gltf()
    made.mesh(made.box())
    path = made.write(tmp_path / "a.gltf")
    path.write_text(json.dumps(json.loads(path.read_text()) | change))
    with pytest.raises(BadInput, match=said):
        read_source(path, tmp_path)


@pytest.mark.parametrize("keep", [3, 12, 19, 60, -1, -200])
def test_a_truncated_glb_is_bad_input(keep: int, tmp_path: Path) -> None:
    made = Gltf()
    made.mesh(made.box())
    path = made.write(tmp_path / "a.glb")
    path.write_bytes(path.read_bytes()[:keep])
    with pytest.raises(BadInput, match=r"cut off|cannot be read|cannot read"):
        read_source(path, tmp_path)


ODD = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-2, 99),
    st.floats(),
    st.text(max_size=3),
    st.just([]),
    st.just({}),
    st.just(10**30),
    st.lists(st.integers(-1, 9), max_size=4),
)


@settings(max_examples=150, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(picks=st.lists(st.integers(0, 10**6), min_size=1, max_size=3), odd=ODD)
def test_whatever_one_value_is_changed_to_the_file_reads_or_is_bad_input(
    picks: list[int], odd: Any, tmp_path: Path
) -> None:
    made = Gltf()
    box = made.box()
    box["attributes"] |= {"TEXCOORD_0": made.accessor(np.zeros((8, 2))), "COLOR_0": made.accessor(np.ones((8, 3)))}
    made.mesh({**box, "material": 0, "targets": [{"POSITION": 0}]}, weights=[0.5])
    made.tree |= {
        "materials": [{"alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}],
        "images": [{"bufferView": made.view(picture("PNG"))}],
        "skins": [{"joints": [0]}],
    }
    path = made.write(tmp_path / "a.gltf")
    tree = json.loads(path.read_text())
    places: list[tuple[Any, Any]] = []
    waiting: list[Any] = [tree]
    while waiting:
        value = waiting.pop()
        keys = value.keys() if isinstance(value, dict) else range(len(value)) if isinstance(value, list) else ()
        places += [(value, key) for key in keys]
        waiting += [value[key] for key in keys]
    for pick in picks:
        owner, key = places[pick % len(places)]
        if isinstance(owner, dict) or key < len(owner):
            owner[key] = odd
    path.write_text(json.dumps(tree))
    try:
        source = read_source(path, tmp_path)
    except BadInput:
        return
    assert all(np.isfinite(part.vertices).all() and len(part.faces) for part in source.parts)
