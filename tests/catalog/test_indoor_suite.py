"""The indoor scenes stand properly, and their cases can be built and repaired."""

import copy
from pathlib import Path
from typing import Any

import pytest

from c4s.evidence import export_level
from c4s.files import read_json
from c4s.packs.store import PackStore
from c4s.records.verdict import Verdict
from c4s.verify.physics.verdict import verify_physics
from cases.applying import apply
from cases.checks import check_repair, check_scene
from cases.corruption import id_of
from cases.model import RepairCase, SourceScene, TextCase
from cases.recipe import KINDS, SpawnActor
from cases.requirements import bundle, families
from cases.starter.indoor_cases import cases, scenes
from cases.starter.indoor_text_cases import INDOOR_TEXT_CASES

INDOOR_SCENES = scenes()
INDOOR_CASES = [case for case in cases(INDOOR_SCENES) if isinstance(case, RepairCase)]
HUNG = {
    "pendant_lamp",
    "ceiling_light_panel",
    "wall_whiteboard",
    "pin_board",
    "wall_clock",
    "framed_poster",
    "wall_shelf",
    "wall_cabinet",
    "wall_mirror",
    "towel_rail",
    "ceiling_lamp",
    "hills_picture",
    "dusk_picture",
}
WALL_OBJECTS = ("Whiteboard", "Clock", "Poster", "PinBoard", "Picture", "Mirror", "WallCabinet", "TowelRail")


@pytest.mark.parametrize("pack_id", ["c4s-office", "c4s-home"])
def test_every_asset_has_a_real_size_a_description_and_bodies_within_it(indoor_packs: Path, pack_id: str) -> None:
    store = PackStore([indoor_packs / pack_id])
    pack = store.packs[indoor_packs / pack_id]
    assert len(pack.assets) >= 40 and len([a for a in pack.assets if a.kind == "blueprint"]) >= 3
    for asset in pack.assets:
        assert asset.description and asset.tags, asset.id
        assert all(0.005 <= size <= 3.2 for size in asset.size_m), (asset.id, asset.size_m)
        if asset.kind == "static_mesh":
            low, high = store.mesh(asset.path).bounds_cm
            assert low == pytest.approx(asset.bounds_min_cm, abs=2e-3)
            assert high == pytest.approx(asset.bounds_max_cm, abs=2e-3)
            assert asset.collision, asset.id
            assert abs(asset.bounds_min_cm[2]) < 1 or asset.id in HUNG, "pivot at the floor, or where it hangs"


@pytest.mark.parametrize("scene", INDOOR_SCENES, ids=lambda s: s.scene_id)
def test_scenes_stand_without_floating_or_penetration(scene: SourceScene, indoor_packs: Path, tmp_path: Path) -> None:
    pack = indoor_packs / scene.packs[0]
    check_scene(scene, {asset.path for asset in PackStore([pack]).assets()})
    ids = [id_of(actor) for actor in scene.level.actors]
    assert None not in ids and len(set(ids)) == len(ids)
    document = tmp_path / "scene.level.json"
    scene.level.write(document)
    export_level(engine="headless", packs=[pack], level=document, out=tmp_path / "snapshot.json")
    exported = read_json(tmp_path / "snapshot.json")
    assert len(exported["actors"]) == len(scene.level.actors)
    leaves = {leaf["leaf_id"]: leaf for leaf in verify_physics("text-to-scene", exported).measurements["leaf_results"]}
    assert leaves["solid_penetration"]["score"] == 1.0
    floating = leaves["floating"]["floating_actors"]
    assert [name for name in floating if not any(word in name for word in WALL_OBJECTS)] == []
    for case in INDOOR_CASES:
        if case.scene_id == scene.scene_id:
            assert perfect_repair(case, exported, PackStore([pack])).score == 1.0, case.case_id


def perfect_repair(case: RepairCase, truth: dict[str, Any], store: PackStore) -> Verdict:
    """The physics verdict on the original, of which the targets of a case's changes count as edited."""
    targets = {operation.target for operation in case.operations if not isinstance(operation, SpawnActor)}
    start = copy.deepcopy(truth)
    for actor in start["actors"]:
        if actor["stable_actor_id"] in targets:
            actor["transform"]["location_cm"][0] += 1e6
    return verify_physics(case.setting, truth, start, meshes=store.recorded_mesh)


def test_scene_sizes() -> None:
    count = {scene.scene_id: len(scene.level.actors) for scene in INDOOR_SCENES}
    assert count["starter-office"] >= 200 and 95 <= count["starter-flat"] <= 160


@pytest.mark.parametrize("case", INDOOR_CASES, ids=lambda c: c.case_id)
def test_repair_cases_can_be_applied_and_solved(case: RepairCase) -> None:
    scene = next(scene for scene in INDOOR_SCENES if scene.scene_id == case.scene_id)
    corrupted = apply(scene.level, case.operations, "/Game/Code4SceneInputs/x/Input")
    check_repair(case, case.operations, scene.level, corrupted)
    assert len(case.views) == 2 and case.setting == "image-to-scene/indoor"


def test_repair_cases_cover_every_kind_and_chain_length() -> None:
    assert {kind for case in INDOOR_CASES for kind in case.kinds} == set(KINDS)
    assert {len(case.kinds) for case in INDOOR_CASES} == {1, 2, 3, 4, 5}
    assert {case.group for case in INDOOR_CASES} == {"Restore", "Lifecycle", "Layout", "Symmetry", "Transform"}


@pytest.mark.parametrize("case", INDOOR_TEXT_CASES, ids=lambda c: c.case_id)
def test_text_cases_have_bundles_over_all_families(case: TextCase) -> None:
    assert 80 <= len(case.description.split()) <= 200
    made = bundle(case.case_id, case.description, case.description + "\n\n=== ASSET PALETTE ===\nx", case.requirements)
    assert len(made["requirements"]) == len(case.requirements.predicates)
    assert len(families(case.requirements)) == 4
