"""Scenes that break what reads them: each ends in a verdict, within the limits of its stages, and never pending."""

from __future__ import annotations

import asyncio
import json
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from c4s.engine import open_engine
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import TrialFolder
from c4s.records.pack import Pack
from c4s.records.plan import Configuration, Plan
from c4s.records.score import TrialScore
from c4s.records.suite import SuiteFolder
from c4s.records.verdict import Verdict
from c4s.run.check import freeze_submission
from c4s.run.drive import Pending, run_trials, stage_functions
from c4s.run.plan import Trial, make_plan, open_run, trials
from c4s.run.pool import Pool

CASE = "text-flat-family"
ACTORS = "unreal.get_editor_subsystem(unreal.EditorActorSubsystem)"
SPAWN = f"{ACTORS}.spawn_actor_from_class(unreal.{{}}, unreal.Vector(0, 0, 100))"
SCRIPTS = {
    "flat-volume": f"{SPAWN.format('PostProcessVolume')}.set_actor_scale3d(unreal.Vector(0, 0, 0))",
    "light-radius": f"light = {SPAWN.format('PointLight')}.get_component_by_class(unreal.PointLightComponent)\n"
    "light.set_editor_property('attenuation_radius', 1e308)\nlight.set_editor_property('source_radius', 1e308)",
    "material-vector": "tools = unreal.AssetToolsHelpers.get_asset_tools()\n"
    "made = tools.create_asset('MI_Huge', '/Game/Made', unreal.MaterialInstanceConstant, "
    "unreal.MaterialInstanceConstantFactoryNew())\n"
    "unreal.MaterialEditingLibrary.set_material_instance_parent(made, PARENT)\n"
    "unreal.MaterialEditingLibrary.set_material_instance_vector_parameter_value(made, 'BaseColor', "
    "unreal.LinearColor(1e308, 1e308, 1e308, 1e308))\n"
    "unreal.EditorAssetLibrary.save_asset('/Game/Made/MI_Huge')\nCUBE.static_mesh_component.set_material(0, made)",
    "material-parents": "tools, above = unreal.AssetToolsHelpers.get_asset_tools(), PARENT\n"
    "for number in range(1500):\n"
    "    made = tools.create_asset(f'MI_{number}', '/Game/Made', unreal.MaterialInstanceConstant, "
    "unreal.MaterialInstanceConstantFactoryNew())\n"
    "    unreal.MaterialEditingLibrary.set_material_instance_parent(made, above)\n"
    "    unreal.EditorAssetLibrary.save_asset(f'/Game/Made/MI_{number}')\n"
    "    above = made\nCUBE.static_mesh_component.set_material(0, above)",
    "label": "CUBE.set_actor_label('x' * (30 << 20))",
    "mountain": "mesh = unreal.EditorAssetLibrary.load_asset('/Engine/BasicShapes/Sphere')\n"
    "for _ in range(1000):\n"
    f"    {ACTORS}.spawn_actor_from_object(mesh, unreal.Vector(0, 0, 0))",
}
"""What an agent's script may do in an engine before it saves the scene."""
PRELUDE = """
import unreal
cube = unreal.EditorAssetLibrary.load_asset("/Engine/BasicShapes/Cube")
PARENT = unreal.EditorAssetLibrary.load_asset("/Engine/BasicShapes/BasicShapeMaterial")
world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
"""
START = f"unreal.EditorLoadingAndSavingUtils.new_blank_map(False)\nCUBE = {ACTORS}.spawn_actor_from_object(" + (
    "cube, unreal.Vector(0, 0, 50))\nfor n in range(40):\n"
    f"    {ACTORS}.spawn_actor_from_object(cube, unreal.Vector(300 + 150 * n, 0, 50))\n"
)
SAVE = "world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()\n" + (
    "assert unreal.EditorLoadingAndSavingUtils.save_map(world, '/Game/SavedScenes/{}')\n"
)


def _abstract(level: dict[str, Any]) -> None:
    """A component of a class that cannot be made."""
    level["actors"][0]["components"][0] = {
        "name": "Light",
        "class_path": "/Script/Engine.LightComponent",
        "properties": {"intensity": 8.0},
    }


def _vast(level: dict[str, Any]) -> None:
    """A light that is larger than the world."""
    level["actors"][0]["components"].append(
        {
            "name": "Lamp",
            "class_path": "/Script/Engine.PointLightComponent",
            "properties": {"attenuation_radius": 1e308, "source_radius": 1e308},
        }
    )


def _named(level: dict[str, Any]) -> None:
    """A label of 30 MiB."""
    level["actors"][0]["label"] = "x" * (30 << 20)


def _dressed(asset: str) -> Callable[[dict[str, Any]], None]:
    def edit(level: dict[str, Any]) -> None:
        level["actors"][0]["components"][0]["materials"] = {"0": f"/Game/Made/{asset}.{asset}"}

    return edit


EDITS: dict[str, Callable[[dict[str, Any]], None]] = {
    "abstract-light": _abstract,
    "written-light-radius": _vast,
    "written-label": _named,
    "written-material-vector": _dressed("MI_Written"),
    "written-material-parents": _dressed("MI_1499"),
}
"""What agent code may write into the document of a level that it saved, past the engine that refuses it."""
REFUSED = {"label", "light-radius", "material-vector", "material-parents"}
"""What the engine does not save, nor the material library make."""
ODD = (*SCRIPTS, *EDITS)


def _write_materials(made: Path) -> None:
    """The materials of those levels: one of boundless colour, and a chain of 1,500."""
    whole = (made / "MI_0.asset.json").read_text()
    for number in range(1, 1500):
        text = whole.replace(
            "/Engine/BasicShapes/BasicShapeMaterial.BasicShapeMaterial", f"/Game/Made/MI_{number - 1}.MI_{number - 1}"
        )
        (made / f"MI_{number}.asset.json").write_text(
            text.replace('/Game/Made/MI_0.MI_0",', f'/Game/Made/MI_{number}.MI_{number}",', 1)
        )
    written = json.loads(whole.replace("MI_0", "MI_Written"))
    (made / "MI_Written.asset.json").write_text(json.dumps(written | {"vectors": {"BaseColor": [1e308] * 4}}))


def _saved(root: Path, pack: Path) -> dict[str, str]:
    """Save every odd scene in one engine; what the engine said of those that it did not save."""
    refused = {}
    with open_engine("headless", packs=[pack], content=root / "content", scratch=root / "scratch") as engine:
        for name in ODD:
            script = PRELUDE + START + SCRIPTS.get(name, "") + "\n" + SAVE.format(name)
            reply = engine.execute(script)
            if reply["status"] != "ok":
                refused[name] = str(reply.get("error"))
    _write_materials(root / "content/Game/Made")
    for name, edit in EDITS.items():
        path = root / "content" / "Game/SavedScenes" / f"{name}.level.json"
        level = json.loads(path.read_text())
        edit(level)
        path.write_text(json.dumps(level))
    return refused


def _submit(trial: Trial, content: Path, pack: Path) -> None:
    """Two attempts that ended with this scene, as the program of a trial finds them."""
    for number in (1, 2):
        folder = trial.folder.attempt(number)
        folder.submission.mkdir(parents=True)
        for part in ("Game/SavedScenes", "Game/Made"):
            if (content / part).is_dir():
                shutil.copytree(content / part, folder.submission / part)
        folder.manifest.write_text(
            json.dumps({"packs": {pack.name: Pack.read(pack / "pack.json").sha256()}, "engine": "headless"})
        )
        AttemptOutcome(
            attempt=number,
            ended_by="finished",
            submission=f"/Game/SavedScenes/{trial.configuration.name}",
            submission_sha256=freeze_submission(folder),
        ).write(folder.outcome)


@pytest.fixture(scope="module")
def outcomes(
    home: Path, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[tuple[dict[str, TrialFolder], list[Pending]]]:
    """What became of each odd scene as a submission, all in one run."""
    root = tmp_path_factory.mktemp("odd")
    pack, suite = home / "packs" / "c4s-home", SuiteFolder(home / "suites" / "small")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("C4S_HOME", str(home))
        refused = _saved(root, pack)
        assert set(refused) == REFUSED and "pydantic" not in str(refused), refused
        plan: Plan = make_plan(
            suite,
            [Configuration(name=name, client="noop") for name in ODD if name not in REFUSED],
            run_id="odd",
            policy=DEFAULT_POLICY,
            judge="rule",
            engine="headless",
            cases=[CASE],
        )
        open_run(root / "run", plan)
        found = list(trials(root / "run", suite.root, plan))
        for trial in found:
            _submit(trial, root / "content", pack)

        async def run() -> list[Pending]:
            async with Pool(2) as pool:
                return await run_trials(found, plan, pool, stage_functions())

        pending = asyncio.run(run())
        yield {trial.configuration.name: trial.folder for trial in found}, pending


@pytest.mark.parametrize("name", [name for name in ODD if name not in REFUSED])
def test_an_odd_scene_has_a_score(outcomes: tuple[dict[str, TrialFolder], list[Pending]], name: str) -> None:
    folders, pending = outcomes
    assert [one.reason for one in pending if one.trial.configuration.name == name] == []
    folder = folders[name]
    score = TrialScore.read(folder.score)
    gates = [Verdict.read(attempt.integrity) for attempt in folder.attempts() if attempt.integrity.is_file()]
    print(name, score.status, score.score, score.reason, [(gate.status, gate.reason[:200]) for gate in gates])
    assert score.status != "pending"
    assert not folder.faults.exists()
