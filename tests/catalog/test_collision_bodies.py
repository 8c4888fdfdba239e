"""Collision of packs: hulls, convex parts and what files bring, measured where it counts: in the engine."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from typer.testing import CliRunner

from c4s.cli.main import app
from c4s.collision import contacts
from c4s.engine.headless.process.boot import boot
from c4s.errors import BadInput
from c4s.geometry.transform import rotation_matrix
from c4s.records.pack import Asset, Pack
from catalog.ingest import authored, decompose
from catalog.ingest.collision import HullChoice
from catalog.ingest.folder import ingest
from tests.shared import SHARED
from tests.work import calls_in

PACKS = SHARED / "assets/packs"
needs_packs = pytest.mark.skipif(not PACKS.is_dir(), reason="the shared sample packs are not here")


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    return tmp_path / "home"


@pytest.fixture
def source(tmp_path: Path) -> Path:
    folder = tmp_path / "source"
    folder.mkdir()
    return folder


def take(folder: Path, pack: str, name: str) -> None:
    """Copy one file of a shared pack with what it refers to."""
    found = next((PACKS / pack).rglob(f"{name}.gltf"))
    tree = json.loads(found.read_text())
    for part in [found.name, *[row["uri"] for key in ("buffers", "images") for row in tree.get(key, [])]]:
        shutil.copy(found.parent / part, folder / part)


def assets(root: Path, pack: str) -> dict[str, Asset]:
    return {asset.id: asset for asset in Pack.read(root / pack / "pack.json").assets}


class Engine:
    """One asset at the origin, and rays."""

    def __init__(self, pack: Path, content: Path, path: str, scale: tuple[float, float, float] = (1, 1, 1)) -> None:
        self.unreal = boot([pack], content)
        self.actor = self.unreal.EditorLevelLibrary.spawn_actor_from_object(
            self.unreal.load_asset(path), self.unreal.Vector(0, 0, 0)
        )
        self.actor.set_actor_scale3d(self.unreal.Vector(*map(float, scale)))
        self.world = self.unreal.EditorLevelLibrary.get_editor_world()

    def ray(self, start: Any, end: Any, triangles: bool = False) -> float | None:
        unreal = self.unreal
        hit = unreal.SystemLibrary.line_trace_single(
            self.world,
            unreal.Vector(*map(float, start)),
            unreal.Vector(*map(float, end)),
            unreal.TraceTypeQuery.TRACE_TYPE_QUERY1,
            triangles,
            [],
            unreal.DrawDebugTrace.NONE,
        )
        return None if hit is None else float(hit.to_tuple()[3])

    def disagreement(self, asset: Asset, count: int = 300) -> float:
        """Share of rays between random points around an asset that meet its bodies and not its triangles, or the
        reverse; a hit within 2 % of the size apart counts as the same."""
        low, high = np.array(asset.bounds_min_cm), np.array(asset.bounds_max_cm)
        size, random = float(np.linalg.norm(high - low)), np.random.default_rng(7)
        wrong = 0
        for start, end in random.uniform(low - 0.1 * (high - low), high + 0.1 * (high - low), (count, 2, 3)):
            way = (end - start) / np.linalg.norm(end - start) * 2 * size
            simple, full = self.ray(start - way, end + way), self.ray(start - way, end + way, True)
            wrong += (simple is None) != (full is None) or (
                simple is not None and full is not None and abs(simple - full) > 0.02 * size
            )
        return wrong / count


@needs_packs
@pytest.mark.parametrize(
    ("pack", "name", "most"), [("kaykit-city-builder", "bench", 6), ("kaykit-prototype", "Primitive_Doorway", 6)]
)
def test_convex_parts_leave_the_hole_open_where_a_hull_fills_it(
    source: Path, tmp_path: Path, home: Path, pack: str, name: str, most: int
) -> None:
    take(source, pack, name)
    wrong = {}
    for how in ("asset", "decompose"):
        ingest(source, f"p-{how}", tmp_path / "packs", hulls=how)  # type: ignore[arg-type]
        (asset,) = assets(tmp_path / "packs", f"p-{how}").values()
        engine = Engine(tmp_path / "packs" / f"p-{how}", tmp_path / how, asset.path)
        wrong[how] = engine.disagreement(asset)
        middle = (np.array(asset.bounds_min_cm) + asset.bounds_max_cm) / 2
        middle[2] = asset.bounds_min_cm[2] + 0.2 * (asset.bounds_max_cm[2] - asset.bounds_min_cm[2])
        through = np.eye(3)[int(np.argmin(asset.size_m[:2]))] * 1000
        assert (engine.ray(middle - through, middle + through) is None) == (how == "decompose")
        assert (how == "asset") == (asset.collision_source == "hull")
        assert 1 <= len(asset.collision) <= most
        assert engine.actor.static_mesh_component.static_mesh is not None
    assert asset.collision_source == "decomposition" and len(asset.collision) > 1
    assert wrong["decompose"] < 0.05 and wrong["asset"] > 2 * wrong["decompose"]


@needs_packs
def test_a_second_build_takes_the_parts_from_the_cache(
    source: Path, tmp_path: Path, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    take(source, "kaykit-prototype", "Primitive_Doorway")
    first = ingest(source, "one", tmp_path / "packs", hulls="decompose")
    kept = list((home / "cache" / "convex").glob("*.npz"))
    assert len(kept) == 1
    monkeypatch.setattr(subprocess, "run", None)
    second = ingest(source, "one", tmp_path / "again", hulls="decompose")
    assert first["sha256"] == second["sha256"]
    kept[0].write_bytes(b"damaged")
    monkeypatch.undo()
    monkeypatch.setenv("C4S_HOME", str(home))
    assert ingest(source, "one", tmp_path / "third", hulls="decompose")["sha256"] == first["sha256"]
    assert kept[0].read_bytes() != b"damaged"


def test_the_command_takes_a_choice_for_each_file(source: Path, home: Path) -> None:
    for name in ("bench_long", "crate", "lamp"):
        legs = trimesh.util.concatenate(
            [
                trimesh.creation.box(
                    extents=(0.1, 0.5, 0.5), transform=trimesh.transformations.translation_matrix([x, 0.25, 0])
                )
                for x in (-0.5, 0.5)
            ]
        )
        legs.export(source / f"{name}.glb")
    run = CliRunner().invoke(
        app,
        [
            "catalog",
            "build",
            str(source),
            "--id",
            "mix",
            "--hulls-of",
            "bench*=decompose",
            "--hulls-of",
            "lamp=none",
            "--json",
        ],
    )
    assert run.exit_code == 0, run.output
    made = assets(home / "packs", "mix")
    assert {name: (asset.collision_source, len(asset.collision)) for name, asset in made.items()} == {
        "bench_long": ("decomposition", 2),
        "crate": ("hull", 2),
        "lamp": ("none", 0),
    }
    assert HullChoice.parse("asset", ["*=piece", "a/b*=node"]).how("a/bench.glb") == "node"
    with pytest.raises(BadInput, match="rule"):
        HullChoice.parse("asset", ["bench=cut"])


def test_what_is_convex_is_not_cut_and_what_is_hidden_adds_nothing() -> None:
    ball, inner = trimesh.creation.icosphere(subdivisions=2, radius=50), trimesh.creation.box(extents=(10, 10, 10))
    joined = trimesh.util.concatenate([ball, inner])
    parts, notes = decompose.decompose(np.asarray(joined.vertices), np.asarray(joined.faces, np.int64))
    assert [len(part) for part in parts] == [162] and notes == []
    open_box = trimesh.creation.box(extents=(20, 20, 20))
    faces = np.asarray(open_box.faces, np.int64)[2:]
    assert decompose.is_convex(np.asarray(open_box.vertices), faces)
    bent = trimesh.creation.annulus(r_min=20, r_max=30, height=10)
    assert not decompose.is_convex(np.asarray(bent.vertices), np.asarray(bent.faces, np.int64))


def test_a_mesh_that_cannot_be_cut_keeps_a_hull_and_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    bent = trimesh.creation.annulus(r_min=20, r_max=30, height=10)
    monkeypatch.setattr(sys, "executable", "/bin/false")
    parts, notes = decompose.decompose(np.asarray(bent.vertices), np.asarray(bent.faces, np.int64), tmp_path)
    assert len(parts) == 1 and "one hull" in notes[0] and not list(tmp_path.iterdir())


def test_a_mesh_has_a_limit_for_all_its_pieces_together(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    rings = [trimesh.creation.annulus(r_min=20, r_max=30, height=10) for _ in range(3)]
    for number, ring in enumerate(rings):
        ring.apply_translation((0, 0, 100 * number))
    joined = trimesh.util.concatenate(rings)
    monkeypatch.setattr(decompose, "MOST_SECONDS", 0.05)
    parts, notes = decompose.decompose(np.asarray(joined.vertices), np.asarray(joined.faces, np.int64), tmp_path)
    assert len(parts) == len(notes) == 3 and all("more than 0.05 s for the mesh" in note for note in notes)


# what files bring


def scene_of(path: Path, shapes: dict[str, tuple[trimesh.Trimesh, Any]]) -> None:
    scene = trimesh.Scene()
    for name, (mesh, matrix) in shapes.items():
        scene.add_geometry(mesh, node_name=name, geom_name=name, transform=matrix)
    scene.export(path)


def matrix(move: Any = (0, 0, 0), turn: float = 0.0, scale: Any = (1, 1, 1)) -> Any:
    made = trimesh.transformations.rotation_matrix(turn, [0, 1, 0]) @ np.diag([*scale, 1.0])
    made[:3, 3] = move
    return made


def test_nodes_named_for_unreal_become_its_bodies_and_are_never_shown(source: Path, tmp_path: Path) -> None:
    scene_of(
        source / "thing.glb",
        {
            "thing": (trimesh.creation.box(extents=(4, 0.1, 4)), matrix((0, 3, 0))),
            "UBX_thing_00": (trimesh.creation.box(extents=(1, 2, 3)), matrix((1, 0, 0), 0.5)),
            "USP_thing": (trimesh.creation.icosphere(subdivisions=2, radius=0.5), matrix((0, 2, 0))),
            "ucp_thing_01": (
                trimesh.creation.capsule(radius=0.25, height=1.0).apply_transform(
                    trimesh.transformations.rotation_matrix(np.pi / 2, [1, 0, 0])
                ),
                matrix((0, 0, 5)),
            ),
            "UCX_thing_02": (
                trimesh.util.concatenate(
                    [
                        trimesh.creation.box(extents=(1, 1, 1)),
                        trimesh.creation.box(transform=matrix((3, 0, 0)), extents=(1, 1, 1)),
                    ]
                ),
                matrix((0, -3, 0)),
            ),
        },
    )
    report = ingest(source, "own", tmp_path / "packs", hulls="decompose")
    asset = assets(tmp_path / "packs", "own")["thing"]
    assert asset.collision_source == "authored" and not [n for n in report["notes"] if n["file"]]
    assert asset.size_m == pytest.approx((4, 4, 0.1), abs=1e-3)
    kinds = sorted(body.kind for body in asset.collision)
    assert kinds == ["box", "capsule", "hull", "hull", "sphere"]
    body = {body.kind: body for body in asset.collision}
    assert body["box"].center == pytest.approx((100, 0, 0), abs=0.1)  # type: ignore[union-attr]
    assert sorted(body["box"].half_extent) == pytest.approx([50, 100, 150], abs=0.1)  # type: ignore[union-attr]
    assert body["sphere"].radius == pytest.approx(50, abs=0.5)  # type: ignore[union-attr]
    assert (body["capsule"].radius, body["capsule"].length) == pytest.approx((25, 100), abs=1)  # type: ignore[union-attr]
    assert body["capsule"].center == pytest.approx((0, 500, 0), abs=1)  # type: ignore[union-attr]
    engine = Engine(tmp_path / "packs" / "own", tmp_path / "content", asset.path)
    assert engine.ray((0, 0, 1000), (0, 0, 0), True) == pytest.approx(695, abs=0.1)
    assert engine.ray((0, 0, 1000), (0, 0, 120)) == pytest.approx(750, abs=0.5)
    assert engine.ray((150, 0, -300), (150, 0, -500)) is None and engine.ray((300, 0, 0), (300, 0, -500)) is not None
    assert engine.ray((0, 500, 500), (0, 500, -500)) == pytest.approx(425, abs=1)
    setup = engine.actor.static_mesh_component.static_mesh.get_editor_property("body_setup")
    geometry = setup.get_editor_property("agg_geom")
    assert [
        len(geometry.get_editor_property(name)) for name in ("box_elems", "sphere_elems", "sphyl_elems", "convex_elems")
    ] == [1, 1, 1, 2]


def test_a_node_that_is_not_what_its_name_says_is_a_hull_and_named(source: Path, tmp_path: Path) -> None:
    scene_of(
        source / "a.glb",
        {
            "a": (trimesh.creation.box(), matrix()),
            "UBX_a": (trimesh.creation.icosphere(subdivisions=1), matrix()),
            "USP_a": (trimesh.creation.box(extents=(1, 2, 3)), matrix()),
            "UCP_a": (trimesh.creation.box(extents=(1, 1, 3)), matrix()),
        },
    )
    scene_of(source / "b.glb", {"UCX_b": (trimesh.creation.box(), matrix())})
    report = ingest(source, "odd", tmp_path / "packs")
    assert [body.kind for body in assets(tmp_path / "packs", "odd")["a"].collision] == ["hull"] * 3
    assert sum("its hull is used" in row["note"] for row in report["notes"]) == 3
    assert [row["file"] for row in report["skipped"]] == ["b.glb"]


@settings(max_examples=60, deadline=None)
@given(
    st.tuples(*[st.floats(-180, 180)] * 3),
    st.tuples(*[st.floats(1, 300)] * 3),
    st.tuples(*[st.floats(-1000, 1000)] * 3),
)
def test_a_turned_box_is_measured_from_its_corners(turn: Any, half: Any, centre: Any) -> None:
    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    corners = (signs * half) @ rotation_matrix(turn).T + centre
    made = authored.box(corners)
    assert made is not None
    again = (signs * made.half_extent) @ rotation_matrix(made.rotation_deg).T + made.center
    gaps = np.linalg.norm(again[:, None] - corners[None], axis=2)
    assert gaps.min(axis=1).max() < 0.01 and sorted(made.half_extent) == pytest.approx(sorted(half), abs=0.01)


def collider_file(path: Path, shape: dict[str, Any], node: dict[str, Any], extensions: tuple[str, str]) -> None:
    """A box of 2 m with a collider node, whose shape is stated in numbers."""
    scene_of(path, {"shown": (trimesh.creation.box(extents=(2, 2, 2)), matrix())})
    scene = trimesh.load_scene(path)
    path.with_suffix(".glb").unlink()
    files = trimesh.exchange.gltf.export_gltf(scene)
    tree = json.loads(files["model.gltf"])
    body, shapes = extensions
    collider = {"geometry": {"shape": 0}} if body.startswith("KHR") else {"shape": 0}
    tree["nodes"].append({"name": "collider", "extensions": {body: {"collider": collider}}, **node})
    tree["scenes"][tree.get("scene", 0)]["nodes"].append(len(tree["nodes"]) - 1)
    tree["extensions"] = {shapes: {"shapes": [shape]}}
    tree["extensionsUsed"] = [body, shapes]
    path.with_suffix(".gltf").write_text(json.dumps(tree))
    for name, data in files.items():
        if name != "model.gltf":
            (path.parent / name).write_bytes(data)


@pytest.mark.parametrize(
    "extensions",
    [("KHR_physics_rigid_bodies", "KHR_implicit_shapes"), ("OMI_physics_body", "OMI_physics_shape")],
    ids=["KHR", "OMI"],
)
@pytest.mark.parametrize(
    ("shape", "node", "kind", "top"),
    [
        ({"type": "box", "box": {"size": [1, 2, 3]}}, {"translation": [0, 4, 0], "scale": [2, 1, 1]}, "box", 500),
        ({"type": "sphere", "sphere": {"radius": 1.5}}, {"scale": [2, 2, 2]}, "sphere", 300),
        ({"type": "sphere", "sphere": {"radius": 1.5}}, {"scale": [1, 2, 1]}, "hull", 300),
        ({"type": "capsule", "capsule": {"height": 2, "radiusBottom": 0.5, "radiusTop": 0.5}}, {}, "capsule", 150),
        ({"type": "capsule", "capsule": {"height": 2, "radiusBottom": 0.5, "radiusTop": 0.25}}, {}, "hull", 125),
        ({"type": "cylinder", "cylinder": {"height": 3, "radiusBottom": 1, "radiusTop": 1}}, {}, "hull", 150),
        (
            {"type": "capsule", "capsule": {"height": 2, "radiusBottom": 0.5, "radiusTop": 0.5}},
            {"rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]},
            "capsule",
            50,
        ),
    ],
)
def test_colliders_stated_in_numbers(
    source: Path,
    tmp_path: Path,
    extensions: tuple[str, str],
    shape: dict[str, Any],
    node: dict[str, Any],
    kind: str,
    top: float,
) -> None:
    collider_file(source / "a.glb", shape, node, extensions)
    report = ingest(source, "stated", tmp_path / "packs")
    assert report["skipped"] == []
    (asset,) = assets(tmp_path / "packs", "stated").values()
    assert asset.collision_source == "authored" and [body.kind for body in asset.collision] == [kind]
    engine = Engine(tmp_path / "packs" / "stated", tmp_path / "content", asset.path)
    assert engine.ray((1, 1, 2000), (1, 1, -2000)) == pytest.approx(2000 - top, abs=1.5)


def test_a_collider_that_cannot_be_used_is_named(source: Path, tmp_path: Path) -> None:
    collider_file(source / "a.glb", {"type": "torus"}, {}, ("KHR_physics_rigid_bodies", "KHR_implicit_shapes"))
    report = ingest(source, "odd", tmp_path / "packs")
    assert any("torus" in row["note"] for row in report["notes"])
    assert [asset.collision_source for asset in assets(tmp_path / "packs", "odd").values()] == ["hull"]


def test_bodies_of_every_kind_make_contacts_under_uneven_scale(source: Path, tmp_path: Path) -> None:
    """The same bodies, in the engine's traces and in the verifier's contacts."""
    from c4s.editor import snapshot

    scene_of(
        source / "ball.glb",
        {
            "ball": (trimesh.creation.box(extents=(1, 1, 1)), matrix()),
            "USP_ball": (trimesh.creation.icosphere(subdivisions=2, radius=0.5), matrix()),
        },
    )
    ingest(source, "balls", tmp_path / "packs")
    (asset,) = assets(tmp_path / "packs", "balls").values()
    engine = Engine(tmp_path / "packs" / "balls", tmp_path / "content", asset.path, (4, 2, 1))
    unreal = engine.unreal
    radius = asset.collision[0].radius  # type: ignore[union-attr]
    assert engine.ray((0, 0, 500), (0, 0, 0)) == pytest.approx(500 - radius)
    unreal.EditorLevelLibrary.spawn_actor_from_object(
        unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector(50 + radius - 7, 0, 0)
    )
    (contact,) = contacts(snapshot.export_snapshot())
    assert contact.depth_cm == pytest.approx(7, abs=1e-3)


def test_what_is_convex_is_not_cut_and_costs_little_more(source: Path, tmp_path: Path) -> None:
    for number in range(8):
        scene_of(source / f"ball_{number}.glb", {"ball": (trimesh.creation.icosphere(subdivisions=3), matrix())})
    whole = calls_in(lambda: ingest(source, "p-whole", tmp_path / "packs", hulls="asset"))
    looked_at = calls_in(lambda: ingest(source, "p-parts", tmp_path / "packs", hulls="decompose"))
    assert looked_at["is_convex"] == 8 and looked_at["_cut"] == 0
    assert looked_at.total() < 1.5 * whole.total()
