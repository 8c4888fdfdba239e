"""What the agent's side of a built suite gives away: names, ids, the outliner, odd poses; and who is told of it."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from c4s.agents import base
from c4s.agents.base import AgentContext, AgentReport
from c4s.agents.baselines.blind import SeenActor, SeenLevel, chosen, guesses
from c4s.errors import BadInput
from c4s.files import read_json
from c4s.records.level import Level
from c4s.records.pack import Pack
from c4s.records.plan import Configuration
from c4s.records.suite import SuiteFolder
from c4s.run.attempt import run_attempt
from cases.audit import audit, mean_f1, seen
from cases.boxes import boxes_of
from cases.corruption import Author, id_of, meshes
from cases.model import RepairCase, SourceScene, SuiteDefinition
from cases.recipe import Recipe, SetTransform, SpawnActor
from cases.standing import unsound
from cases.starter import farm_scene, outdoor_cases
from cases.starter.plot import Plot
from cases.suite import build_suite
from cases.views import orbit
from tests.built import built_packs
from tests.cases.test_case_suite import small

PASTURE, YARD = "outdoor-farm-pasture", "outdoor-farm-yard"
Change = Callable[[SeenActor], dict[str, Any]]


@pytest.fixture(scope="module")
def farm(tmp_path_factory: pytest.TempPathFactory) -> SuiteFolder:
    """The farm of the starter suite with two of its repairs, beside its pack."""
    root = tmp_path_factory.mktemp("farm")
    (root / "packs").symlink_to(built_packs(tmp_path_factory, "c4s-farm"))
    known = outdoor_cases.scenes()
    repairs = [case for case in outdoor_cases.cases(known) if case.case_id in (PASTURE, YARD)]
    tiny = [
        dataclasses.replace(case, views=[dataclasses.replace(view, width=64, height=36) for view in case.views])
        for case in repairs
        if isinstance(case, RepairCase)
    ]
    build_suite(
        SuiteDefinition("farm", "Farm", "", ("c4s-farm",), (known[1],), tiny), root / "suite", root / "packs", print
    )
    return SuiteFolder(root / "suite")


def start(suite: SuiteFolder, case_id: str) -> Level:
    return Level.read(suite.agent(suite.case(case_id).alias) / "start.level.json")


def things(suite: SuiteFolder, case_id: str) -> SeenLevel:
    pack = Pack.read(suite.root.parent / "packs/c4s-farm/pack.json")
    return seen(start(suite, case_id), boxes_of(pack.assets))


def test_no_word_of_a_case_is_on_the_agents_side(farm: SuiteFolder) -> None:
    for case in farm.suite().cases:
        withheld = farm.withheld_case(case.case_id)
        words = {
            case.case_id,
            withheld.scene_id,
            withheld.title.lower(),
            "removal",
            "insertion",
            "duplication",
            "input",
        }
        for path in farm.agent(case.alias).rglob("*"):
            told = path.name + (path.read_text() if path.suffix == ".json" else "")
            assert not [word for word in words if word in told.lower()], path.name


def test_what_was_put_there_is_like_the_others(farm: SuiteFolder) -> None:
    recipe = Recipe.read(farm.withheld(PASTURE) / "recipe.json")
    put = {operation.stable_id for operation in recipe.operations if isinstance(operation, SpawnActor)}
    actors = [actor for actor in start(farm, PASTURE).actors if meshes(actor)]
    new = [actor for actor in actors if id_of(actor) in put]
    old = [actor for actor in actors if id_of(actor) not in put]
    assert len(new) == 2 and len({actor.guid for actor in actors}) == len(actors)
    for actor in new:
        like = next(one for one in old if one.class_path == actor.class_path)
        assert [part.name for part in actor.components] == [part.name for part in like.components]
        assert [tag.partition("=")[0] for tag in actor.tags] == [tag.partition("=")[0] for tag in like.tags]
        assert len(str(id_of(actor))) == len(str(id_of(like))) and actor.label == actor.name
    names = sorted(int(actor.name.rpartition("_")[2]) for actor in actors if actor.name.startswith("SM_Sheep_"))
    assert names != list(range(1, len(names) + 1)), "numbers have gaps"
    assert actors[-1] not in new


def test_scenes_are_as_people_leave_them_and_stand(farm: SuiteFolder) -> None:
    truth = read_json(farm.withheld(YARD) / "truth.snapshot.json")
    shown = [actor["transform"] for actor in truth["actors"] if actor["asset_path"]]
    mirrored = sum(min(place["scale"]) < 0 for place in shown)
    uneven = sum(len({abs(value) for value in place["scale"]}) > 1 for place in shown)
    askew = sum(place["rotation_deg"][1] % 15 != 0 for place in shown)
    assert min(mirrored, uneven, askew) > 0.15 * len(shown)
    moved = {
        actor["name"]
        for actor in truth["actors"]
        if actor["asset_path"] and len({abs(value) for value in actor["transform"]["scale"]}) > 1
    }
    assert unsound(truth).isdisjoint(moved)


def test_no_number_of_a_recipe_stands_out(farm: SuiteFolder) -> None:
    for case_id in (PASTURE, YARD):
        for actor in start(farm, case_id).actors:
            place = actor.transform
            for value in (*place.location_cm, *place.rotation_deg, *place.scale):
                assert value == round(value, 3), actor.name
    recipe = Recipe.read(farm.withheld(YARD) / "recipe.json")
    truth = {id_of(actor): actor.transform for actor in Level.read(farm.withheld(YARD) / "truth.level.json").actors}
    for operation in recipe.operations:
        assert isinstance(operation, SetTransform)
        if operation.location_cm is not None:
            assert operation.location_cm[0] % 1 != 0
        if operation.rotation_deg is not None:
            assert operation.rotation_deg[1] % 1 != 0
        if operation.scale is not None:
            was = truth[operation.target].scale
            assert max(abs(abs(value) - 1) for value in was) > 0.05, "the size of most is not the answer"


def test_the_best_blind_way_gets_next_to_nothing(farm: SuiteFolder) -> None:
    rows = list(audit(farm, farm.root.parent / "packs"))
    assert [row.case_id for row in rows] == [PASTURE, YARD] and all(len(row.f1) > 10 for row in rows)
    assert max(mean_f1(rows).values()) <= 0.03


def test_a_suite_that_can_be_repaired_blindly_is_not_built(farm: SuiteFolder, tmp_path: Path) -> None:
    plot = Plot("paddock", farm_scene.PATHS, seed=1)
    plot.grid("GrassTile", (-500, 500), (-500, 500))
    for number in range(4):
        plot.add("Cow", -300 + 200 * number, 90 * number)
    scene = SourceScene("paddock", "outdoor", "Paddock", plot.level(), ("c4s-farm",))
    stranger = Author(scene.level, "paddock").insertion(farm_scene.PATHS["Barrel"], (0.0, -300.0, 0.0))
    view = orbit("reference", (0, 0, 60), distance_cm=900, yaw_deg=80, width=64, height=36)
    case = dataclasses.replace(small().cases[0], corruptions=[stranger], views=[view])
    definition = SuiteDefinition("small", "Small", "", ["c4s-farm"], [scene], [case])
    with pytest.raises(BadInput, match=r"paddock-cow 1\.00.*without a look at a picture"):
        build_suite(definition, tmp_path / "suite", farm.root.parent / "packs", print)
    assert not (tmp_path / "suite").exists()


def spoilt(scene: SeenLevel, victim: int, change: Change, others: Change | None = None) -> SeenLevel:
    """A scene in which one thing was changed, and perhaps all others."""
    rows = [
        dataclasses.replace(thing, **(change(thing) if row == victim else others(thing) if others else {}))
        for row, thing in enumerate(scene.things)
    ]
    return SeenLevel(scene.package, tuple(rows))


SPOILT: dict[str, tuple[Change, Change | None]] = {
    "other ids": (lambda t: {"stable_id": "sca_spawned_1"}, None),
    "folders": (lambda t: {"folder": ""}, lambda t: {"folder": "Farm"}),
    "tags and components": (lambda t: {"tags": frozenset({"new"})}, None),
    "names": (lambda t: {"name": "Thing", "label": "Thing"}, None),
    "mirrored": (lambda t: {"scale": (-1.0, 1.0, 1.0)}, lambda t: {"scale": (1.0, 1.0, 1.0)}),
    "odd sizes": (lambda t: {"scale": (1.7, 1.7, 1.7)}, lambda t: {"scale": (1.0, 1.0, 1.0)}),
    "odd turns": (lambda t: {"rotation": (0.0, 37.0, 0.0)}, lambda t: {"rotation": (0.0, 0.0, 0.0)}),
    "round numbers": (lambda t: {"location": (1.12345, 2.54321, 0.0)}, lambda t: {"location": (1.5, 2.5, 0.0)}),
    "paint": (lambda t: {"materials": ((0, "/Game/M.M"),)}, lambda t: {"materials": ()}),
}


@pytest.mark.parametrize("trick", SPOILT)
def test_each_trick_finds_what_it_is_for(farm: SuiteFolder, trick: str) -> None:
    scene = things(farm, YARD)
    victim = next(row for row, thing in enumerate(scene.things) if len(scene.of_mesh[thing.mesh]) > 3)
    made = guesses(spoilt(scene, victim, *SPOILT[trick]))
    assert scene.things[victim].name in {
        guess.actor.replace("Thing", scene.things[victim].name) for guess in chosen(made[trick])
    }


class Nosy:
    """It looks in its surroundings for what the case is called, then does as ``blind`` does."""

    told = ""

    def run(self, context: AgentContext) -> AgentReport:
        from c4s.agents.baselines.blind.agent import Blind

        with context.connect() as tools:
            Nosy.told = tools.call("execute_python_script", script=NOSY, execution_mode="sync").data["output"]
        return Blind().run(context)


NOSY = """
import gc, os, sys
import unreal

told = [os.getcwd(), *sys.argv, *sys.path, *os.environ.values()]
told += [str(getattr(unreal.Paths, name)()) for name in dir(unreal.Paths) if name.endswith("_dir")]
for place, folders, files in os.walk(unreal.Paths.project_dir()):
    told += [place, *files]
told += [v for d in gc.get_objects() if isinstance(d, dict) for v in list(d.values()) if isinstance(v, str)]
print([text[:200] for text in told if "past" + "ure" in text.lower()])
"""


def test_blind_reads_the_scene_as_the_audit_does_and_code_finds_no_name(
    farm: SuiteFolder, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(base.CLIENTS, "nosy", f"{__name__}:Nosy")
    line = farm.case(PASTURE)
    outcome = run_attempt(
        farm.agent_case(line.alias),
        farm.agent(line.alias),
        Configuration(name="nosy", client="nosy"),
        1,
        tmp_path / "attempt",
        [farm.root.parent / "packs/c4s-farm"],
        None,
    )
    assert outcome.ended_by == "finished" and outcome.submission, outcome.message
    assert Nosy.told.strip() == "[]"
    wanted = chosen([guess for of in guesses(things(farm, PASTURE)).values() for guess in of])
    assert outcome.message == "; ".join(f"{guess.actor}: {guess.edit}, {guess.trick}" for guess in wanted)
    saved = json.loads(next((tmp_path / "attempt/submission").rglob("*.level.json")).read_text())
    more = sum({"delete": -1, "copy": 1}.get(guess.edit, 0) for guess in wanted)
    assert len(saved["actors"]) == len(start(farm, PASTURE).actors) + more
    ids = [id_of(actor) for actor in Level.model_validate(saved).actors]
    assert len(set(filter(None, ids))) == len([own for own in ids if own]), "a copy has no identity of another"
