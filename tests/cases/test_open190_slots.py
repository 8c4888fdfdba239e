"""The slots of open-190: a scene that people made where its package is installed, else the one that is laid out."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import trimesh

from c4s.errors import BadInput
from c4s.files import digest_file, read_json
from c4s.packs.check import pack_changes
from c4s.packs.store import PackStore
from c4s.records.suite import Visibility
from cases.boxes import boxes_of
from cases.importers.scene import REPORT
from cases.open190.brought import BroughtPlace
from cases.open190.eyes import block
from cases.open190.library import SCENES
from cases.open190.repairs.changes import Changeable
from cases.open190.repairs.plan import PUBLIC_SEED, Environment, planned
from cases.open190.slots import VARIABLE, BroughtSpec, SceneSlot, absence, chosen, held, slots, told
from cases.open190.suite import DESCRIPTION, described, unit_plans
from cases.standing import snapshot_of

SEED = "0123456789abcdef0123456789abcdef"
HALVES: tuple[tuple[Visibility, str], ...] = (("public", PUBLIC_SEED), ("private", SEED))


def hall() -> trimesh.Scene:
    """A floor of 12 m with walls about it, in one mesh, four stools in a row and a cup on a table. Metres, Y up."""
    scene = trimesh.Scene()
    shell = [((12, 0.1, 12), (0, -0.05, 0))]
    shell += [((12, 3, 0.1), (0, 1.5, side)) for side in (-6.05, 6.05)]
    shell += [((0.1, 3, 12), (side, 1.5, 0)) for side in (-6.05, 6.05)]
    walls = [trimesh.creation.box(size, trimesh.transformations.translation_matrix(at)) for size, at in shell]
    scene.add_geometry(trimesh.util.concatenate(walls), node_name="hall", geom_name="hall")
    stool, table, cup = (trimesh.creation.box(size) for size in ((0.4, 0.5, 0.3), (1.6, 0.8, 0.8), (0.1, 0.12, 0.08)))
    for number in range(4):
        at = trimesh.transformations.translation_matrix((number - 2.0, 0.252, 2))
        if number:
            scene.graph.update(frame_to=f"stool.{number}", geometry="stool", matrix=at)
        else:
            scene.add_geometry(stool, node_name="stool.0", geom_name="stool", transform=at)
    for name, mesh, at in (("table", table, (3, 0.402, -2)), ("cup", cup, (3.1, 0.864, -2))):
        scene.add_geometry(
            mesh, node_name=name, geom_name=name, transform=trimesh.transformations.translation_matrix(at)
        )
    return scene


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> SceneSlot:
    """A slot whose package is unpacked in a folder."""
    root, file = tmp_path / "unpacked", "usr/share/hall/hall.glb"
    (root / file).parent.mkdir(parents=True)
    hall().export(root / file)
    (root / "usr/share/hall/copyright").write_text("You may do with it what you like.\n")
    monkeypatch.setenv(VARIABLE, str(root))
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    return SceneSlot(
        scene_id="hall",
        in_place_of="machine-shop",
        environment="indoor",
        title="A hall",
        manager="Debian",
        package="hall-data",
        version="1-1",
        install="apt install hall-data",
        file=file,
        file_sha256=digest_file(root / file),
        licence_file="usr/share/hall/copyright",
        licence="CC0-1.0",
    )


def test_each_slot_stands_for_a_scene_of_its_kind_that_may_be_replaced() -> None:
    for slot in slots():
        spec = SCENES[slot.in_place_of]
        assert spec.slot and spec.kind == slot.environment
        assert slot.scene_id not in SCENES
    assert len({slot.in_place_of for slot in slots()}) == len({slot.scene_id for slot in slots()}) == len(slots())


def test_without_the_packages_the_suite_is_that_of_the_kits(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, str(tmp_path))
    assert chosen() == SCENES
    assert described(chosen().values()) == DESCRIPTION
    for slot in slots():
        assert told()[slot.scene_id].startswith(f"{slot.in_place_of} in its place: {slot.package} is not installed")
        assert held(chosen().values())[slot.scene_id] == slot.in_place_of


def test_a_slot_changes_no_repair_of_another_scene(package: SceneSlot) -> None:
    for visibility, seed in HALVES:
        dealt = []
        for specs in (SCENES, chosen([package])):
            rooms = {kind: [name for name, one in specs.items() if one.kind == kind] for kind in ("indoor", "outdoor")}
            dealt.append(planned(rooms, visibility, seed))  # type: ignore[arg-type]
        assert len(dealt[0]) == len(dealt[1])
        for one, other in zip(*dealt, strict=True):
            assert one == other or (one.scene_id, other.scene_id) == ("machine-shop", "hall")
            assert (one.group, one.chain, one.tier, one.nested) == (other.group, other.chain, other.tier, other.nested)


def test_all_slots_of_the_table_change_no_repair_of_another_scene() -> None:
    named = {slot.in_place_of: slot.scene_id for slot in slots()}
    rooms: dict[Environment, list[str]] = {
        kind: [name for name, one in SCENES.items() if one.kind == kind] for kind in ("indoor", "outdoor")
    }
    filled: dict[Environment, list[str]] = {kind: [named.get(name, name) for name in rooms[kind]] for kind in rooms}
    for visibility, seed in HALVES:
        for one, other in zip(planned(rooms, visibility, seed), planned(filled, visibility, seed), strict=True):
            scene_id = named.get(one.scene_id, one.scene_id)
            assert other == replace(one, scene_id=scene_id, case_id=one.case_id.replace(one.scene_id, scene_id))


def test_a_quarter_of_the_source_scenes_may_be_made_by_people() -> None:
    assert len(slots()) * 4 >= sum(spec.kind != "text" for spec in SCENES.values())


def test_the_suite_says_what_was_brought(package: SceneSlot) -> None:
    specs = chosen([package]).values()
    assert "by people (hall from hall-data 1-1)" in described(specs)
    assert {plan.spec.kind for plan in unit_plans(None)} == {"indoor", "outdoor", "text"}


def test_another_file_leaves_the_parametric_scene(package: SceneSlot, tmp_path: Path) -> None:
    assert absence(package) is None
    file = tmp_path / "unpacked" / package.file
    file.write_bytes(file.read_bytes() + b"\0")
    assert absence(package) == "its file is not the one of hall-data 1-1"
    assert chosen([package]) == SCENES


def test_a_missing_program_is_named(package: SceneSlot) -> None:
    lame = package.model_copy(update={"needs": ["no-such-program"]})
    assert absence(lame) == "no-such-program is not installed"


@pytest.mark.parametrize("text", ["", "nowhere/at/all"])
def test_a_root_that_is_no_folder_is_refused(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, text)
    with pytest.raises(BadInput, match="is no folder"):
        chosen()


def test_a_scene_is_brought_once_and_the_same_each_time(package: SceneSlot, tmp_path: Path) -> None:
    spec, packs = BroughtSpec(package), tmp_path / "packs"
    pack = spec.bring(packs)
    assert (pack.pack_id, pack.license, pack.ai_use) == ("open-hall", "CC0-1.0", "allowed")
    before = (packs / "open-hall" / "pack.json").stat().st_mtime_ns
    assert spec.bring(packs) == pack and (packs / "open-hall" / "pack.json").stat().st_mtime_ns == before
    again = spec.bring(tmp_path / "other")
    assert again.sha256() == pack.sha256() and not pack_changes(packs / "open-hall")
    _is_a_hall(spec.place(packs))


def test_the_report_of_the_import_names_the_package_and_no_folder(package: SceneSlot, tmp_path: Path) -> None:
    BroughtSpec(package).bring(tmp_path / "packs")
    file = tmp_path / "home/cache/open-190-slots/open-hall" / REPORT
    assert str(tmp_path) not in file.read_text(encoding="utf-8")
    report = read_json(file)
    assert report["source"] == {
        "manager": "Debian",
        "package": "hall-data",
        "version": "1-1",
        "file": "usr/share/hall/hall.glb",
    }
    assert report["actors"] == 7


def test_what_a_slot_calls_soft_is_never_changed(package: SceneSlot, tmp_path: Path) -> None:
    spec = BroughtSpec(package.model_copy(update={"soft": ["stool_[01]"]}))
    pack = spec.bring(tmp_path / "packs")
    place, folders = spec.place(tmp_path / "packs"), [tmp_path / "packs" / pack.pack_id]
    snapshot, boxes, store = snapshot_of(place.level(), folders), boxes_of(pack.assets), PackStore(folders)
    assert place.left_alone == {"stool_0", "stool_1"}
    found = [
        Changeable(place.level(), "hall", snapshot, boxes, store, [], place.parted, left).things
        for left in ((), place.left_alone)
    ]
    assert {*found[0]} - {*found[1]} == place.left_alone and {*found[1]} == {"stool_2", "stool_3", "cup"}


def _is_a_hall(place: BroughtPlace) -> None:
    said = {(one.kind, one.subject, one.reference) for one in place.relations}
    assert ("on", "cup", "table") in said
    assert {name for kind, name, _ in said if kind == "in_row"} == {f"stool_{number}" for number in range(4)}
    assert list(place.parted) == ["hall"]
    floor = max(place.parted["hall"], key=lambda box: float(np.prod(np.subtract(*box[::-1])[:2])))
    assert floor[1][2] == pytest.approx(0, abs=0.2)
    assert place.space.free([block(0.0, -400.0, 160.0, 35.0)])
    assert not place.space.free([block(605.0, 0.0, 160.0, 35.0)])
    assert place.level() == place.level()
