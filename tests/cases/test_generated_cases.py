"""Cases made by chance from an imported scene: of things that stand, solvable, and the same for one seed."""

from __future__ import annotations

from pathlib import Path

import pytest

from c4s.errors import BadInput
from c4s.records.level import Level
from cases.applying import apply
from cases.checks import check_definition, check_repair
from cases.generate import SoundThing, generated, sound_things
from cases.importers.importing import import_scene
from cases.model import RepairCase

TABLE = "actor,asset,x,y,z,roll,pitch,yaw\n" + "".join(
    f"{name},{asset}.obj,{x},{y},{z},0,0,0\n"
    for name, asset, x, y, z in (
        ("ground", "ground", 0, 0, -0.5),
        ("crate_a", "crate", -3, 0, 0.501),
        ("crate_b", "crate", 0, 0, 0.501),
        ("crate_c", "crate", 3, 0, 0.501),
        ("post_a", "post", 0, 3, 0.501),
        ("post_b", "post", 3, 3, 0.501),
        ("hung", "post", -3, 3, 4.0),
        ("sunk", "post", -3, -3, 0.2),
    )
)


@pytest.fixture(scope="module")
def yard(tmp_path_factory: pytest.TempPathFactory) -> tuple[Level, Path, list[SoundThing]]:
    import trimesh

    folder = tmp_path_factory.mktemp("yard")
    for name, size in (("ground", (20, 1, 20)), ("crate", (1, 1, 1)), ("post", (0.4, 1, 0.4))):
        (folder / f"{name}.obj").write_text(trimesh.exchange.obj.export_obj(trimesh.creation.box(extents=size)))
    (folder / "yard.csv").write_text(TABLE)
    report = import_scene(folder / "yard.csv", "yard", suites=folder / "suites", packs=folder / "packs")
    level = Level.read(Path(report["level"]))
    return level, folder / "packs", sound_things(level, [folder / "packs" / "yard"])


def test_only_things_that_stand_and_fit_are_changed(yard: tuple[Level, Path, list[SoundThing]]) -> None:
    assert [thing.name for thing in yard[2]] == ["crate_a", "crate_b", "crate_c", "post_a", "post_b"]


def test_cases_follow_from_the_seed_and_can_be_solved(yard: tuple[Level, Path, list[SoundThing]]) -> None:
    level, packs, things = yard
    made = generated("yard", level, things, packs, ["yard"], count=4, changes=3, seed=5, environment="outdoor")
    again = generated("yard", level, things, packs, ["yard"], count=4, changes=3, seed=5, environment="outdoor")
    other = generated("yard", level, things, packs, ["yard"], count=4, changes=3, seed=6, environment="outdoor")
    assert made == again != other
    check_definition(made)
    assert [len(case.kinds) for case in made.cases[:4] if isinstance(case, RepairCase)] == [1, 2, 3, 1]
    for case in made.cases:
        assert isinstance(case, RepairCase)
        truth = made.scenes[0].level
        check_repair(case, case.operations, truth, apply(truth, case.operations, "/Game/Code4SceneInputs/x/Input"))
    with pytest.raises(BadInput, match="fewer --changes"):
        generated("yard", level, things, packs, ["yard"], count=1, changes=8, seed=0)
