"""Plain GLB files are read without trimesh, to the very same arrays; every other file goes to trimesh."""

from __future__ import annotations

import json
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from c4s.packs import meshes
from c4s.packs.meshes import MeshPart, read_parts
from c4s.packs.plain_glb import read_plain
from catalog.build import glb
from catalog.shapes import Builder

Change = Callable[[dict[str, Any]], object]


def _file(path: Path, change: Change = lambda tree: None) -> Path:
    """A desk of two materials, its JSON changed."""
    builder = Builder()
    builder.box("Wood", (160, 80, 4), (0, 0, 72))
    builder.box("Steel", (4, 4, 72), (70, 30, 0))
    shape = builder.shape()
    data = glb(shape.mesh, shape.materials, dict.fromkeys(shape.materials, (0.5, 0.4, 0.3)))
    size = struct.unpack_from("<I", data, 12)[0]
    tree = json.loads(data[20 : 20 + size])
    change(tree)
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + size :]
    path.write_bytes(struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text) + len(rest), len(text), b"JSON") + text + rest)
    return path


def _by_trimesh(path: Path, monkeypatch: pytest.MonkeyPatch) -> list[MeshPart]:
    with monkeypatch.context() as patch:
        patch.setattr(meshes, "read_plain", lambda path: None)
        return read_parts(path)


def _same(parts: list[MeshPart], others: list[MeshPart]) -> bool:
    def flat(part: MeshPart) -> list[object]:
        arrays = (part.vertices, part.faces, part.normals, part.uvs, part.colors)
        return [part.slot, *(None if a is None else (a.dtype, a.shape, a.tobytes()) for a in arrays)]

    return [flat(part) for part in parts] == [flat(part) for part in others]


def test_a_pack_s_own_file_is_read_to_the_same_bytes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = _file(tmp_path / "desk.glb")
    assert read_plain(path) is not None
    parts = read_parts(path)
    assert sorted(part.slot for part in parts) == ["Steel", "Wood"] and all(len(part.faces) == 12 for part in parts)
    assert _same(parts, _by_trimesh(path, monkeypatch))


@pytest.mark.parametrize(
    "change",
    [
        lambda tree: tree["nodes"][0].update(translation=[1, 2, 3]),
        lambda tree: tree["nodes"][0].update(matrix=np.diag([2.0, 2.0, 2.0, 1.0]).ravel().tolist()),
        lambda tree: (
            tree["nodes"].append({"children": [0, 1], "scale": [1, 2, 1]}),
            tree["scenes"][0].update(nodes=[2]),
        ),
        lambda tree: tree["nodes"][1].update(mesh=0),
        lambda tree: tree["meshes"][0]["primitives"].append(dict(tree["meshes"][1]["primitives"][0])),
        lambda tree: tree["meshes"][0]["primitives"][0].update(mode=5),
        lambda tree: tree["meshes"][0]["primitives"][0]["attributes"].pop("NORMAL"),
        lambda tree: tree["meshes"][0]["primitives"][0].pop("material"),
        lambda tree: tree["meshes"][0]["primitives"][0]["attributes"].update(
            COLOR_0=tree["meshes"][0]["primitives"][0]["attributes"]["NORMAL"]
        ),
    ],
    ids=["moved", "matrix", "parent", "twice", "two primitives", "strip", "no normals", "no material", "colours"],
)
def test_what_is_not_plain_goes_to_trimesh(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, change: Change) -> None:
    path = _file(tmp_path / "other.glb", change)
    assert read_plain(path) is None
    assert _same(read_parts(path), _by_trimesh(path, monkeypatch))


@pytest.mark.parametrize("size", [0, 3, 11, 19, 40, 2000])
def test_a_cut_file_is_not_plain(tmp_path: Path, size: int) -> None:
    path = _file(tmp_path / "cut.glb")
    path.write_bytes(path.read_bytes()[:size])
    assert read_plain(path) is None
    with pytest.raises(meshes.BadInput, match="cannot read this mesh"):
        read_parts(path)
