"""Attributes of every component type, plain and compressed, against the rules of glTF 2.0 computed apart."""

from __future__ import annotations

import itertools
import struct
from pathlib import Path
from typing import Any

import DracoPy  # type: ignore[import-not-found]
import numpy as np
import pytest
import trimesh

from c4s.errors import BadInput
from catalog.ingest.source import read_source
from catalog.ingest.surface import SourcePart
from tests.catalog.gltf_maker import KINDS, Gltf

LETTER = {"int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "uint32": "I", "float32": "f"}
POINTS = [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]]
FACES = [[0, 1, 2], [0, 2, 3]]


def by_specification(raw: list[list[Any]], kind: str, normalized: bool) -> np.ndarray[Any, Any]:
    """Section 3.6.2.2 of glTF 2.0 and the table of KHR_mesh_quantization, from the bytes of each number."""

    def one(value: Any) -> float:
        (found,) = struct.unpack("<" + LETTER[kind], struct.pack("<" + LETTER[kind], value))
        if not normalized or kind == "float32":
            return float(found)
        return {
            "int8": max(found / 127.0, -1.0),
            "uint8": found / 255.0,
            "int16": max(found / 32767.0, -1.0),
            "uint16": found / 65535.0,
            "uint32": found / 4294967295.0,
        }[kind]

    return np.array([[one(value) for value in row] for row in raw])


def raw_values(kind: str, width: int) -> list[list[Any]]:
    """Four rows that reach both ends of a type."""
    if kind == "float32":
        return [[(row * width + column) / (4 * width - 1) for column in range(width)] for row in range(4)]
    limits = np.iinfo(kind)
    ends = [int(limits.min), int(limits.max), int(limits.max) // 2, int(limits.max) // 5]
    return [[ends[(row + column) % 4] for column in range(width)] for row in range(4)]


def read(made: Gltf, tmp_path: Path) -> SourcePart:
    return read_source(made.write(tmp_path / "thing.gltf"), tmp_path).parts[0]


def back(points: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Points or normals in the file's axes."""
    return points[:, [0, 2, 1]]


def made_with(name: str, raw: list[list[Any]], kind: str, normalized: bool, **more: Any) -> Gltf:
    made = Gltf()
    attributes = {"POSITION": made.accessor(POINTS), "NORMAL": made.accessor([[0, 1, 0]] * 4)}
    attributes[name] = made.accessor(raw, kind, **({"normalized": True} if normalized else {}))
    made.mesh(
        {"attributes": attributes, "indices": made.accessor([[i] for face in FACES for i in face], "uint8"), **more}
    )
    return made


@pytest.mark.parametrize(("kind", "normalized"), list(itertools.product(LETTER, (False, True))))
def test_positions_texture_coordinates_and_normals_of_every_type(kind: str, normalized: bool, tmp_path: Path) -> None:
    if kind == "float32" and normalized:
        pytest.skip("floats are never normalised")
    raw = raw_values(kind, 3)
    expected = by_specification(raw, kind, normalized)
    assert back(read(made_with("POSITION", raw, kind, normalized), tmp_path).vertices) / 100 == pytest.approx(expected)
    again = trimesh.load_scene(tmp_path / "thing.gltf", process=False).to_geometry()
    if not normalized and kind not in ("int16", "uint16"):
        assert np.sort(np.asarray(again.vertices), axis=0) == pytest.approx(np.sort(expected, axis=0), rel=1e-6)
    normals = read(made_with("NORMAL", raw, kind, normalized), tmp_path).normals
    assert back(normals) == pytest.approx(expected / np.linalg.norm(expected, axis=1, keepdims=True))
    raw = raw_values(kind, 2)
    part = read(made_with("TEXCOORD_0", raw, kind, normalized), tmp_path)
    assert part.uvs == pytest.approx(by_specification(raw, kind, normalized))
    raw = raw_values(kind, 4)
    with_tangents = read(made_with("TANGENT", raw, kind, normalized), tmp_path)
    assert back(with_tangents.vertices) / 100 == pytest.approx(np.array(POINTS))


@pytest.mark.parametrize("width", [3, 4])
@pytest.mark.parametrize("kind", ["uint8", "uint16", "float32"])
@pytest.mark.parametrize("normalized", [False, True])
def test_colours_of_every_type_are_shares(kind: str, width: int, normalized: bool, tmp_path: Path) -> None:
    """Integers of colours are always shares: a file whose accessor forgets to say so is not white all over."""
    raw = raw_values(kind, width)
    part = read(made_with("COLOR_0", raw, kind, normalized), tmp_path)
    expected = by_specification(raw, kind, True)[:, :3]
    assert part.colors == pytest.approx(expected)


@pytest.mark.parametrize("joints", ["uint8", "uint16"])
@pytest.mark.parametrize("weights", ["uint8", "uint16", "float32"])
def test_joints_and_weights_of_every_type(joints: str, weights: str, tmp_path: Path) -> None:
    made = Gltf()
    most = 1.0 if weights == "float32" else int(np.iinfo(weights).max)
    rows = [[most, 0, 0, 0], [0, most, 0, 0], [0, most, 0, 0], [most, 0, 0, 0]]
    made.mesh(
        {
            "attributes": {
                "POSITION": made.accessor(POINTS),
                "JOINTS_0": made.accessor([[0, 1, 0, 0]] * 4, joints),
                "WEIGHTS_0": made.accessor(rows, weights, **({} if weights == "float32" else {"normalized": True})),
            },
            "indices": made.accessor([[i] for face in FACES for i in face], "uint8"),
        }
    )
    made.tree["nodes"] = [{"mesh": 0, "skin": 0}, {}, {"translation": [1, 0, 0]}]
    made.tree["scenes"][0]["nodes"] = [0, 1, 2]
    made.tree["skins"] = [{"joints": [1, 2]}]
    part = read(made, tmp_path)
    assert np.ptp(part.vertices, axis=0) == pytest.approx([200, 100, 0])


def draco(attributes: dict[str, tuple[np.ndarray[Any, Any], bool]], component: dict[str, int]) -> Gltf:
    """A square whose attributes are in a Draco buffer, described by accessors without data."""
    made, numbers = Gltf(), {name: 10 + index for index, name in enumerate(attributes)}
    data = DracoPy.encode(
        np.asarray(POINTS, np.float32),
        np.asarray(FACES, np.uint32),
        quantization_bits=14,
        preserve_order=True,
        generic_attributes={numbers[name]: values for name, (values, _) in attributes.items()},
    )
    position = next(one["unique_id"] for one in DracoPy.decode(data).attributes if one["attribute_type"] == 0)
    view = made.view(data)

    def described(count: int, kind: int, shape: str, normalized: bool = False) -> int:
        made.tree["accessors"].append(
            {"componentType": kind, "count": count, "type": shape, **({"normalized": True} if normalized else {})}
        )
        return len(made.tree["accessors"]) - 1

    own = {
        name: described(4, component[name], f"VEC{values.shape[1]}", normalized)
        for name, (values, normalized) in attributes.items()
    }
    made.mesh(
        {
            "attributes": {"POSITION": described(4, 5126, "VEC3"), **own},
            "indices": described(6, 5125, "SCALAR"),
            "extensions": {
                "KHR_draco_mesh_compression": {"bufferView": view, "attributes": {"POSITION": position, **numbers}}
            },
        }
    )
    made.tree |= {
        "extensionsRequired": ["KHR_draco_mesh_compression"],
        "extensionsUsed": ["KHR_draco_mesh_compression"],
    }
    return made


@pytest.mark.parametrize("kind", ["uint8", "uint16", "float32"])
@pytest.mark.parametrize("width", [3, 4])
@pytest.mark.parametrize("normalized", [False, True])
def test_compressed_colours_are_shares_of_their_own_type(
    kind: str, width: int, normalized: bool, tmp_path: Path
) -> None:
    """Draco's decoder hands 16-bit colours over as 32-bit numbers: by those, everything is black."""
    raw = raw_values(kind, width)
    made = draco({"COLOR_0": (np.asarray(raw, kind), normalized and kind != "float32")}, {"COLOR_0": KINDS[kind]})
    part = read(made, tmp_path)
    assert part.colors is not None
    order = [POINTS.index(point) for point in np.round(back(part.vertices) / 100).astype(int).tolist()]
    assert part.colors == pytest.approx(by_specification(raw, kind, True)[order, :3], abs=1e-6)


def test_compressed_texture_coordinates_keep_their_type(tmp_path: Path) -> None:
    for kind, normalized in (("uint16", True), ("uint16", False), ("uint8", True), ("float32", False)):
        raw = raw_values(kind, 2)
        made = draco({"TEXCOORD_0": (np.asarray(raw, kind), normalized)}, {"TEXCOORD_0": KINDS[kind]})
        part = read(made, tmp_path)
        order = [POINTS.index(point) for point in np.round(back(part.vertices) / 100).astype(int).tolist()]
        assert part.uvs == pytest.approx(by_specification(raw, kind, normalized)[order])


@pytest.mark.parametrize("name", ["EXT_meshopt_compression", "KHR_meshopt_compression"])
def test_meshopt_is_refused_by_name(name: str, tmp_path: Path) -> None:
    made = Gltf()
    made.mesh(made.box())
    made.tree |= {"extensionsUsed": [name], "extensionsRequired": [name]}
    with pytest.raises(BadInput, match=f"compressed with {name}, which is not read; write the file again"):
        read(made, tmp_path)


def test_a_texture_in_ktx2_is_noted_and_the_plain_colour_used(tmp_path: Path) -> None:
    made = Gltf()
    made.mesh({**made.box(), "material": 0})
    made.tree |= {
        "images": [{"mimeType": "image/ktx2", "bufferView": made.view(b"\xabKTX 20\xbb\r\n\x1a\n" + bytes(80))}],
        "textures": [{"extensions": {"KHR_texture_basisu": {"source": 0}}}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1], "baseColorTexture": {"index": 0}}}],
        "extensionsUsed": ["KHR_texture_basisu"],
        "extensionsRequired": ["KHR_texture_basisu"],
    }
    source = read_source(made.write(tmp_path / "thing.gltf"), tmp_path)
    assert source.parts[0].surface.color == (1.0, 0.0, 0.0)
    assert any("KTX2" in note for note in source.notes)
