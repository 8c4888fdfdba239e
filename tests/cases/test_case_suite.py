"""A suite built whole, through the real packs and the real engine, from one small scene."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from c4s.errors import BadInput
from c4s.files import digest
from c4s.records.binding import Binding
from c4s.records.pack import Pack
from c4s.records.suite import SuiteFolder
from cases.applying import apply
from cases.corruption import Author, id_of
from cases.model import RepairCase, SourceScene, SuiteDefinition, TextCase
from cases.recipe import KINDS, Recipe
from cases.requirements import EntitySpec, PredicateSpec, RequirementSpec
from cases.starter import farm_scene, harbour_scene
from cases.starter.outdoor_cases import cases, scenes
from cases.starter.plot import Plot
from cases.suite import build_suite
from cases.views import orbit
from catalog.build import build_pack
from catalog.starter import farm
from tests.built import built_once, built_packs

TEXT = "A field with two cows and a barn."


@pytest.fixture(scope="module")
def packs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built_packs(tmp_path_factory, "c4s-farm")


def small() -> SuiteDefinition:
    plot = Plot("paddock", farm_scene.PATHS, seed=1)
    plot.grid("GrassTile", (-500, 500), (-500, 500))
    plot.add("Cow", -200, 0)
    plot.add("Cow", 200, 100, yaw=90)
    plot.add("Barn", 0, -1500)
    scene = SourceScene("paddock", "outdoor", "Paddock", plot.level(), ("c4s-farm",))
    author = Author(scene.level, "paddock")
    cow = next(name for name in author.actors if name.startswith("SM_Cow"))
    view = orbit("reference", (0, 0, 60), distance_cm=900, yaw_deg=80, width=160, height=90)
    repair = RepairCase(
        "paddock-cow",
        "paddock",
        "A cow turned round",
        [author.rotate(cow, 90), author.mirror(cow)],
        "Transform",
        "easy",
        [view],
    )
    spec = RequirementSpec(
        [
            EntitySpec("cows", "two cows", ("cow",), collection=True),
            EntitySpec("field", "field", ("grass tile",), "surface"),
            EntitySpec("barn", "barn"),
        ],
        [
            PredicateSpec("existence", "cows", "two cows", "cows"),
            PredicateSpec("existence", "field", "A field", "field"),
            PredicateSpec("existence", "barn", "a barn", "barn"),
        ],
    )
    text = TextCase(
        "paddock-text", "paddock", "Paddock", TEXT, spec, 20.0, "easy", ground=[farm_scene.PATHS["GrassTile"]]
    )
    return SuiteDefinition("small", "Small", "", ["c4s-farm"], [scene], [repair, text])


def paddock_home(factory: pytest.TempPathFactory) -> Path:
    """A home with the farm's pack and the suite ``small``, built once a test run; for reading."""

    def build(root: Path) -> None:
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("C4S_HOME", str(root))
            shutil.copytree(built_packs(factory, "c4s-farm"), root / "packs")
            built = build_suite(small(), root / "suites/small", root / "packs", lambda line: None)
            assert SuiteFolder(root / "suites/small").suite() == built

    return built_once(factory, "paddock-home", build)


def test_a_suite_is_built_whole_and_again_to_the_same_digest(
    packs: Path, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    shutil.copytree(paddock_home(tmp_path_factory) / "suites/small", tmp_path / "a")
    folder = SuiteFolder(tmp_path / "a")
    first = folder.suite()
    assert [case.case_id for case in first.cases] == ["paddock-cow", "paddock-text"]
    _check_repair(folder)
    _check_text(folder)
    steps: list[str] = []
    assert build_suite(small(), tmp_path / "a", packs, steps.append) == first
    assert steps == ["suite small: already built"]
    assert build_suite(small(), tmp_path / "b", packs, lambda line: None) == first
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a", "b"]


def _check_repair(folder: SuiteFolder) -> None:
    alias, withheld = folder.case("paddock-cow").alias, folder.withheld_case("paddock-cow")
    agent = folder.agent_case(alias)
    assert withheld.operations == ["rotate", "mirror"] and withheld.minimum_actors == 3
    assert agent.budget.tool_calls == 80 and (withheld.alias, withheld.title) == (alias, "A cow turned round")
    picture = folder.agent(alias) / agent.reference_views[0]
    assert picture.read_bytes().startswith(b"\x89PNG")
    truth, given = (
        json.loads((folder.withheld("paddock-cow") / f"{name}.snapshot.json").read_text())["actors"]
        for name in ("truth", "input")
    )
    different = [a["label"] for a, b in zip(truth, given, strict=True) if a["transform"] != b["transform"]]
    assert len(different) == 1 and different[0].startswith("SM_Cow")
    recipe = Recipe.read(folder.withheld("paddock-cow") / "recipe.json")
    assert recipe.operations[0].op == "set_transform"
    assert {a["stable_actor_id"] for a in truth} == {id_of(a) for a in small_level_with_ids(folder)}
    told = "".join(path.read_text() for path in folder.agent(alias).glob("*.json")).lower()
    assert not [word for word in ("ground_truth", "recipe", "paddock", "turned", "input") if word in told]


def small_level_with_ids(folder: SuiteFolder) -> list:
    from c4s.records.level import Level

    return Level.read(folder.withheld("paddock-cow") / "truth.level.json").actors


def _check_text(folder: SuiteFolder) -> None:
    case = folder.agent_case(folder.case("paddock-text").alias)
    assert case.prompt.startswith(TEXT) and case.plate_m == 20.0
    order = [case.prompt.index(part) for part in ("=== GROUND ===", "=== ASSET PALETTE ===", "=== THE TASK ===")]
    assert order == sorted(order)
    assert "- cow | Cow | animals | " in case.prompt and "/Game/C4SFarm/Animals/SM_Cow.SM_Cow" in case.prompt
    made = json.loads((folder.withheld("paddock-text") / "requirements.bundle.json").read_text())
    assert made["graph"]["prompt"] + "\n" == case.prompt
    binding = Binding.read(folder.withheld("paddock-text") / "binding.json")
    assert [path.rsplit(".", 1)[-1] for path in binding.entities["entity_cows"].assets] == ["SM_Cow"]
    assert binding.bundle_sha256 == digest(made["graph"])


def test_unusable_definitions_are_refused(packs: Path, tmp_path: Path) -> None:
    good = small()
    repair = good.cases[0]
    for wrong in (
        SuiteDefinition("s", "", "", ["c4s-farm"], good.scenes, [repair, repair]),
        SuiteDefinition("s", "", "", ["c4s-farm"], [], [repair]),
        SuiteDefinition("s", "", "", ["no-such-pack"], good.scenes, [repair]),
        SuiteDefinition("s", "", "", [], good.scenes, [repair]),
    ):
        with pytest.raises(BadInput):
            build_suite(wrong, tmp_path / "bad", packs, lambda line: None)
    assert not list(tmp_path.iterdir())


def test_the_outdoor_cases_cover_every_kind_of_change_and_apply() -> None:
    known = scenes()
    assert {s.scene_id: len(s.level.actors) for s in known}.keys() == {harbour_scene.SCENE_ID, farm_scene.SCENE_ID}
    sizes = {s.scene_id: len(s.level.actors) for s in known}
    assert 600 <= sizes[harbour_scene.SCENE_ID] <= 1000 and 260 <= sizes[farm_scene.SCENE_ID] <= 500
    made = cases(known)
    repairs = [case for case in made if isinstance(case, RepairCase)]
    assert len(repairs) == 6 and len(made) == 8
    assert {kind for case in repairs for kind in case.kinds} == set(KINDS)
    assert max(len(case.kinds) for case in repairs) == 5
    for case in repairs:
        level = next(s.level for s in known if s.scene_id == case.scene_id)
        assert apply(Author(level, case.scene_id).level, case.operations, "/Game/In").actors


def test_packs_are_the_same_bytes_every_time(packs: Path, tmp_path: Path) -> None:
    build_pack(farm.pack(), tmp_path)
    again, before = (Pack.read(root / "c4s-farm" / "pack.json") for root in (tmp_path, packs))
    assert again.sha256() == before.sha256()
    assert len(again.assets) >= 40 and all(asset.bounds_min_cm[2] <= 0.5 for asset in again.assets)
