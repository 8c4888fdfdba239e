"""Made cases are sifted: what is kept has a truth that scores fully and cannot be guessed; the rest is told."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import pytest
import trimesh

from c4s.errors import BadInput
from c4s.files import read_json
from c4s.records.level import Level
from c4s.records.suite import SuiteFolder, WithheldFolder
from c4s.verify.physics.verdict import verify_physics
from cases.audit import audit
from cases.generate import generated, sound_things
from cases.importers.importing import import_scene
from cases.model import RepairCase
from cases.stamp import refused_cases
from cases.suite import build_suite

SIZES = {"crate": (1.0, 1.0, 1.0), "post": (0.4, 1.6, 0.4), "bench": (1.6, 0.5, 0.6)}


@pytest.fixture(scope="module")
def yard(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A yard of crates, posts and benches on tiles, without ground; a folder of its files."""
    folder = tmp_path_factory.mktemp("yard")
    for name, size in SIZES.items():
        (folder / f"{name}.obj").write_text(trimesh.exchange.obj.export_obj(trimesh.creation.box(extents=size)))
    rows = ["actor,asset,x,y,z,roll,pitch,yaw"]
    for row in range(3):
        for column in range(5):
            name = list(SIZES)[(row + column) % 3]
            height = SIZES[name][1] / 2
            place = f"{4 * column + 0.00004},{4 * row},{height + 0.00004}"
            rows.append(f"{name}_{row}{column},{name}.obj,{place},0,0,{0.3 * column + row}")
    rows.append("hung,crate.obj,9,9,5.00004,0,0,0.1234567")
    (folder / "yard.csv").write_text("\n".join(rows))
    return folder


def test_what_is_kept_is_good_and_the_rest_is_told(yard: Path) -> None:
    packs = yard / "packs"
    bare = import_scene(yard / "yard.csv", "bare", suites=yard / "suites", packs=packs)
    assert sound_things(Level.read(Path(bare["level"])), [packs / "bare"]) == [], "everything stands on nothing"
    report = import_scene(yard / "yard.csv", "yard", suites=yard / "suites", packs=packs, ground=True)
    level = Level.read(Path(report["level"]))
    things = sound_things(level, [packs / "yard"])
    assert len(things) == 15 and "Ground" not in {thing.name for thing in things}
    made = generated("yard", level, things, packs, ["yard"], count=1, changes=2, seed=1)
    suite = build_suite(made, yard / "built", packs, lambda line: None)
    folder = SuiteFolder(yard / "built")
    assert len(suite.cases) == 1
    for case in suite.cases:
        withheld = WithheldFolder(folder.withheld(case.case_id))
        truth, start = read_json(withheld.truth_snapshot), read_json(withheld.input_snapshot)
        assert verify_physics(case.setting, truth, start).score == 1.0
    assert all(row.best[1] == 0 for row in audit(folder, packs))
    kept = {case.case_id for case in suite.cases}
    refused = refused_cases(yard / "built")
    assert kept.isdisjoint(one.case_id for one in refused) and all(one.reason for one in refused)
    assert build_suite(made, yard / "built", packs, lambda line: None).sha256() == suite.sha256()


def test_where_too_few_can_be_seen_the_next_ones_are_looked_at(yard: Path) -> None:
    packs = yard / "packs"
    report = import_scene(yard / "yard.csv", "hidden", suites=yard / "suites", packs=packs, ground=True)
    level = Level.read(Path(report["level"]))
    things = sound_things(level, [packs / "hidden"])
    made = generated("hidden", level, things, packs, ["hidden"], count=1, changes=1, seed=1)
    repairs = [case for case in made.cases if isinstance(case, RepairCase)]
    sky = {"location_cm": (0.0, 0.0, 90_000.0), "target_cm": (0.0, 0.0, 99_000.0)}
    blind = [
        dataclasses.replace(case, views=[dataclasses.replace(view, **sky) for view in case.views])
        for case in repairs[:-2]
    ]
    cases, lines = [*blind, *repairs[-2:]], list[str]()
    suite = build_suite(dataclasses.replace(made, cases=cases), yard / "seen", packs, lines.append)
    assert len(suite.cases) == 1
    unseen = {one.case_id for one in refused_cases(yard / "seen") if one.kind == "seen"}
    assert len(unseen) > 1 and suite.cases[0].case_id not in unseen
    assert sum("of the original" in line for line in lines) > 1


def test_a_scene_whose_truth_always_loses_makes_no_case(yard: Path) -> None:
    packs = yard / "packs"
    report = import_scene(yard / "yard.csv", "floating", suites=yard / "suites", packs=packs)
    level = Level.read(Path(report["level"]))
    solid = import_scene(yard / "yard.csv", "solid", suites=yard / "suites", packs=packs, ground=True)
    things = sound_things(Level.read(Path(solid["level"])), [packs / "solid"])
    floating = [
        thing.__class__(thing.name, thing.origin, thing.extent, thing.mesh.replace("Solid", "Floating"))
        for thing in things
    ]
    made = generated("floating", level, floating, packs, ["floating"], count=1, changes=1, seed=1)
    kept = dataclasses.replace(made, cases=[case for case in made.cases if "insertion" not in case.case_id][:3])
    with pytest.raises(BadInput, match=r"none of [0-9]+ made cases is a good one: [0-9]+ lose physics"):
        build_suite(kept, yard / "none", packs, lambda line: None)
    assert not (yard / "none").exists()
