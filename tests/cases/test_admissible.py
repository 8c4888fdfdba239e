"""Repairs that cannot be used are refused by the build, each with what was measured of the real scene."""

from __future__ import annotations

import dataclasses
import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from pathlib import Path

import pytest

from c4s.errors import BadInput
from c4s.files import read_json
from c4s.records.suite import SuiteFolder
from cases.admissible import Refused
from cases.corruption import Author, Corruption
from cases.model import CaseView, RepairCase, SourceScene, SuiteDefinition
from cases.starter import farm_scene
from cases.starter.plot import Plot
from cases.suite import build_suite
from cases.views import orbit
from tests.built import built_packs

PATHS = farm_scene.PATHS


def paddock() -> SourceScene:
    """A field with things that can be changed, some that must not be, and hay on a cart."""
    plot = Plot("paddock", PATHS, seed=1)
    plot.grid("GrassTile", (-1500, -500, 500, 1500), (-1500, -500, 500, 1500))
    plot.add("Cow", -200, 0)
    for number in range(4):
        plot.add("Barrel", 300 + 150 * number, 300)
    plot.add("Crate", 0, -300)
    plot.add("HayBale", 0, -300, 25.2)
    plot.add("HayBale", -600, -300)
    plot.add("StoneWall", 600, -300)
    for number in range(6):
        plot.add("Sheep", -700 + 230 * number, 800)
    plot.add("Pig", 900, -900)
    plot.add("Pig", 900, -880)
    plot.daylight(-50, 40)
    return SourceScene("paddock", "outdoor", "Paddock", plot.level(), ("c4s-farm",))


def near(x: float, y: float, distance_cm: float = 700) -> CaseView:
    return orbit("reference", (x, y, 60), distance_cm=distance_cm, yaw_deg=-80, pitch_deg=25, width=640, height=360)


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, str]:
    """What the build of one suite says against each of its cases; nothing of a good one."""
    scene = paddock()
    author = Author(scene.level, scene.scene_id)
    name = {actor.name.rsplit("_", 1)[0]: actor.name for actor in author.level.actors}
    crate, loose = name["SM_Crate"], sorted(one for one in author.actors if one.startswith("SM_HayBale"))[1]

    def case(case_id: str, change: Corruption, *views: CaseView, more: Sequence[Corruption] = ()) -> RepairCase:
        return RepairCase(case_id, "paddock", case_id, [change, *more], "Layout", "easy", list(views))

    barrels = [author.rotate(one, 90) for one in sorted(author.actors) if one.startswith("SM_Barrel")]
    cases = [
        case("good-turn", author.rotate(name["SM_Cow"], 90), near(-200, 0)),
        case("good-move", author.move(loose, by_cm=(150, -120, 0)), near(-600, -300)),
        case("far", author.rotate(name["SM_Cow"], 90), near(-200, 0, 20000)),
        case("elsewhere", author.removal(name["SM_Cow"]), near(3000, -4000)),
        case("round", barrels[0], near(500, 300), more=barrels[1:]),
        case("small-change", author.rescale(loose, 1.055), near(-600, -300)),
        case("ground", author.removal(name["SM_GrassTile"]), near(1500, 1500, 2500)),
        case("wall", author.removal(name["SM_StoneWall"]), near(600, -300)),
        case("support", author.removal(crate), near(0, -300)),
        case(
            "two-views",
            author.rotate(name["SM_Cow"], 90),
            near(-200, 0),
            dataclasses.replace(near(-200, 0, 900), name="second"),
        ),
    ]
    cases.append(case("sunken", author.move(name["SM_Pig"], by_cm=(0, 220, 0)), near(900, -900)))
    definition = SuiteDefinition("bad", "Bad", "", ["c4s-farm"], [scene], cases)
    packs = built_packs(tmp_path_factory, "c4s-farm")
    place = tmp_path_factory.mktemp("bad") / "suite"
    with pytest.raises(Refused) as refused:
        build_suite(definition, place, packs, lambda line: None)
    assert not place.exists()
    told: dict[str, list[str]] = defaultdict(list)
    for one in refused.value.refusals:
        told[one.case_id].append(one.reason)
    assert "cannot be used" in refused.value.line()
    return {one.case_id: "; ".join(told[one.case_id]) for one in cases}


@pytest.mark.parametrize(
    ("case_id", "says"),
    [
        ("far", r"SM_Cow_\d has \d+ of 1280x720 pixels in the reference views at the most; 400 are needed"),
        ("elsewhere", r"SM_Cow_\d has 0 of 1280x720 pixels"),
        ("round", r"SM_Barrel_\d turned shows in [0-2]\.\d% of its own pixels"),
        ("small-change", r"SM_HayBale_\d rescaled shows in \d+\.\d% of its own pixels .* 12% and 400 are needed"),
        ("ground", r"SM_GrassTile_\d+ is 1000 x 1000 x 4 cm: ground, which is no target"),
        ("sunken", r"its truth has a physics score of 0\.\d+: SM_Pig_\d .* sinks \d+\.\d cm into SM_Pig_\d"),
        ("wall", r"SM_StoneWall_\d is structure, which is no target"),
        ("support", r"SM_HayBale_\d stand in the original and hang or sink in the start scene"),
        ("two-views", r"it has 2 reference views; a case of image-to-scene/outdoor has 1"),
    ],
)
def test_a_repair_that_cannot_be_used_is_refused_with_the_number(
    found: Mapping[str, str], case_id: str, says: str
) -> None:
    assert re.search(says, found[case_id]), found[case_id]


def test_good_repairs_are_not_refused(found: Mapping[str, str]) -> None:
    assert (found["good-turn"], found["good-move"]) == ("", "")


def test_where_none_of_the_made_cases_shows_there_is_no_suite(
    tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    scene = paddock()
    author = Author(scene.level, scene.scene_id)
    cows = [name for name in author.actors if name.startswith(("SM_Cow", "SM_Sheep"))]
    made = [
        RepairCase(f"far-{name}", "paddock", "", [author.rotate(name, 90)], "Layout", "easy", [near(0, 0, 20000)])
        for name in cows
    ]
    definition = SuiteDefinition("made", "Made", "", ["c4s-farm"], [scene], made, most=1)
    with pytest.raises(BadInput, match=r"none of 7 made cases is a good one: .*cannot be seen"):
        build_suite(definition, tmp_path / "made", built_packs(tmp_path_factory, "c4s-farm"), lambda line: None)
    assert not (tmp_path / "made").exists()


def test_what_was_seen_of_good_repairs_is_kept(tmp_path: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    scene = paddock()
    author = Author(scene.level, scene.scene_id)
    cow = next(name for name in author.actors if name.startswith("SM_Cow"))
    case = RepairCase("turn", "paddock", "", [author.rotate(cow, 90)], "Layout", "easy", [near(-200, 0)])
    definition = SuiteDefinition("good", "Good", "", ["c4s-farm"], [scene], [case])
    build_suite(definition, tmp_path / "good", built_packs(tmp_path_factory, "c4s-farm"), lambda line: None)
    (row,) = read_json(SuiteFolder(tmp_path / "good").sightings)["turn"]
    assert row["actor"] == cow and row["done"] == ["turned"]
    assert row["pixels"] > 5000 and 0.3 < row["changed_share"] <= 1
