"""Scenes and shapes in the warehouse, made of the starter packs and of a suite as it is built."""

from __future__ import annotations

import json
import struct
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from c4s.packs.meshes import Mesh
from c4s.packs.store import PackStore
from c4s.records.snapshot import read_snapshot
from c4s.records.suite import SuiteFolder, WithheldFolder
from tests.built import built_once, built_packs
from tests.run.conftest import build_small
from warehouse.database import rebuild, rows
from warehouse.parquet import write_part
from warehouse.scenes import Content, case_scenes, document_of, packed, unpacked
from warehouse.scenes.shapes import MOST_TRIANGLES, mesh_bytes

KEY = {
    "trial_id": "",
    "run_id": "run",
    "suite": "small",
    "suite_digest": "d",
    "configuration": "_case",
    "configuration_digest": "",
    "repeat": 0,
}
MOST_SCENE_BYTES = 24_000
MOST_PACK_BYTES = 500_000
"""Every mesh of a starter pack together."""


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built_once(tmp_path_factory, "small-home", build_small)


def unfolded(data: bytes) -> tuple[dict[str, Any], NDArray[Any], NDArray[Any]]:
    """The header, the vertices (cm) and the triangles of mesh bytes."""
    raw = zlib.decompress(data, -15)
    (length,) = struct.unpack_from("<I", raw)
    head = json.loads(raw[4 : 4 + length])
    count = head["vertices"]
    steps = np.frombuffer(raw, np.uint16, 3 * count, 4 + length).reshape(-1, 3)
    low, high = np.array(head["low"]), np.array(head["high"])
    kind = np.dtype(np.uint32 if head["wide"] else np.uint16)
    size = head["indices"] * kind.itemsize
    padded = size + -size % 4
    faces = np.frombuffer(raw, kind, head["indices"], len(raw) - padded).reshape(-1, 3)
    return head, low + steps / 65535 * (high - low), faces


def test_the_meshes_of_a_pack_are_small_and_as_they_were(tmp_path_factory: pytest.TempPathFactory) -> None:
    store = PackStore([built_packs(tmp_path_factory, "c4s-home") / "c4s-home"])
    total = 0
    for asset in store.assets():
        if asset.kind != "static_mesh":
            continue
        mesh = store.mesh(asset.path)
        data, triangles = mesh_bytes(mesh)
        total += len(data)
        head, vertices, faces = unfolded(data)
        assert triangles == len(faces) == len(mesh.faces) == sum(size for _, _, size in head["groups"]) // 3
        span = float(np.ptp(mesh.vertices, axis=0).max())
        assert np.abs(vertices - mesh.vertices).max() <= span / 65535 + 1e-4
        before, after = (np.sort(np.sort(mesh_faces, axis=1), axis=0) for mesh_faces in (mesh.faces, faces))
        assert (before == after).all()
    assert total < MOST_PACK_BYTES


def test_a_mesh_of_too_many_triangles_is_drawn_coarser() -> None:
    side = 160
    x, y = np.meshgrid(np.arange(side, dtype=np.float32), np.arange(side, dtype=np.float32))
    vertices = np.column_stack([x.ravel(), y.ravel(), np.zeros(side * side, np.float32)])
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    faces = np.concatenate(
        [
            np.column_stack([corner, corner + 1, corner + side]),
            np.column_stack([corner + 1, corner + side + 1, corner + side]),
        ]
    ).astype(np.int32)
    normals = np.tile(np.array([0, 0, 1], np.float32), (len(vertices), 1))
    mesh = Mesh(vertices, faces, normals, vertices[:, :2].copy(), np.zeros(len(faces), np.int32))
    data, triangles = mesh_bytes(mesh)
    _, found, _ = unfolded(data)
    assert 0 < triangles <= MOST_TRIANGLES < len(faces)
    assert np.ptp(found, axis=0)[:2].min() > 0.95 * side


def test_a_scene_keeps_where_every_mesh_stands(home: Path) -> None:
    suite = SuiteFolder(home / "suites" / "small")
    case = suite.suite().cases[0]
    snapshot = read_snapshot(WithheldFolder(suite.withheld(case.case_id)).truth_snapshot)
    document = document_of(snapshot, Content((home / "packs" / "c4s-home",)))
    assert unpacked(packed(document)) == document
    assert len(packed(document)) < MOST_SCENE_BYTES
    assert len(document["actors"]) == len(snapshot["actors"])
    for told, actor in zip(document["actors"], snapshot["actors"], strict=True):
        drawn = [one for one in actor["c4s"]["components"] if one["mesh"] and one["visible"]]
        assert [document["meshes"][part[0]][0] for part in told["parts"]] == [one["mesh"] for one in drawn]
        for part, one in zip(told["parts"], drawn, strict=True):
            pose = part[2] or told["pose"]
            transform = one["transform"]
            wanted = [*transform["location_cm"], *transform["quaternion_xyzw"], *transform["scale"]]
            assert pose == pytest.approx(wanted, abs=1e-3)
    assert any("texture" in look for look in document["materials"])


def test_a_snapshot_without_keys_of_c4s_has_boxes(home: Path) -> None:
    suite = SuiteFolder(home / "suites" / "small")
    case = suite.suite().cases[0]
    snapshot = read_snapshot(WithheldFolder(suite.withheld(case.case_id)).truth_snapshot)
    plain = {
        "actors": [{key: value for key, value in actor.items() if key != "c4s"} for actor in snapshot["actors"]],
        "material_parameter_catalog": {},
    }
    document = document_of(plain)
    assert all(actor["parts"] == [] and len(actor["box"]) == 6 for actor in document["actors"])


def test_of_a_private_case_no_scene_is_kept(home: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("C4S_HOME", str(home))
    suite = SuiteFolder(home / "suites" / "small")
    case = suite.suite().cases[0]
    agent, record = suite.agent_case(case.alias), suite.withheld_case(case.case_id)
    folder, key = WithheldFolder(suite.withheld(case.case_id)), {**KEY, "case_id": case.case_id}
    private = record.model_copy(update={"visibility": "private"})
    assert list(case_scenes(agent, private, folder, key, tmp_path)) == []
    assert not (tmp_path / "shapes").exists()
    kept = list(case_scenes(agent, record, folder, key, tmp_path))
    assert "truth" in {row.role for row in kept}
    write_part(tmp_path, "scenes", kept, suite="small", configuration="_case", key="one")
    rebuild(tmp_path)
    shapes = {row["shape_sha256"]: row["kind"] for row in rows(tmp_path, "SELECT shape_sha256, kind FROM shapes")}
    for row in rows(tmp_path, "SELECT document FROM scenes"):
        document = unpacked(row["document"])
        assert all(shapes[mesh[1]] == "mesh" for mesh in document["meshes"])
        assert all(shapes[look["texture"]] == "texture" for look in document["materials"] if "texture" in look)
