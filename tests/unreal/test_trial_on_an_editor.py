"""A whole trial through the program of a trial, with a real suite, a baseline agent and stand-in editors."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
import yaml

from c4s.engine import backend, open_engine
from c4s.engine.unreal.host.session import EditorSession
from c4s.engine.unreal.standin.content import add_content
from c4s.errors import BadInput
from c4s.evidence import SceneUnreadable, open_clean, open_level
from c4s.files import read_json
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import SAVES, EvidenceFolder
from c4s.records.level import Level
from c4s.records.pack import Pack
from c4s.records.plan import Configuration
from c4s.records.score import TrialScore
from c4s.records.suite import SuiteFolder
from c4s.run.drive import run_trials, stage_functions
from c4s.run.plan import Trial, make_plan, open_run, trials
from c4s.run.pool import Pool
from cases.code4scene import importer
from tests.standin import behaving

PALETTE = (
    "- box | Box | props | 1x1x1 m | /Game/P/SM_Box.SM_Box",
    "- post | Post | props | 1x1x2 m | /Game/P/SM_Post.SM_Post",
)
TASK = {
    "id": "yard",
    "kind": "scene_generation",
    "inputs": {
        "prompt": "\n".join(("A yard with boxes and posts.", "", "=== ASSET PALETTE ===", "", *PALETTE, "")),
        "init_map": "/Game/Blank",
        "size_m": 200,
        "budget": {"tool_calls": 60, "wall_minutes": 5},
    },
}
VIEW = {
    "name": "view",
    "location_cm": [-400, -300, 300],
    "target_cm": [150, 0, 50],
    "fov_deg": 60,
    "width": 160,
    "height": 90,
}
AIMED = {key: value for key, value in VIEW.items() if key != "target_cm"} | {"rotation_deg": [-22.0, 28.6, 0.0]}
BUILD = """
import unreal
actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
box = unreal.EditorAssetLibrary.load_asset("/Game/P/SM_Box")
for number in range(12):
    actors.spawn_actor_from_object(box, unreal.Vector(300 * number, 0, 0)).set_actor_label(f"Box {number}")
world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
print(unreal.EditorLoadingAndSavingUtils.save_map(world, "/Game/SavedScenes/yard"))
"""


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory, editor: Path) -> Iterator[Path]:
    """A home with the suite ``yard``, whose pack has content for the stand-in."""
    root = tmp_path_factory.mktemp("home")
    (root / "tasks/yard").mkdir(parents=True)
    (root / "tasks/yard/task.yaml").write_text(yaml.safe_dump(TASK))
    build = importer.build_proxy_pack

    def with_content(pack_id: str, *arguments: object) -> Pack:
        build(pack_id, *arguments)  # type: ignore[arg-type]
        folder = Path(str(arguments[2])) / pack_id
        add_content(folder)
        return Pack.read(folder / "pack.json")

    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("C4S_HOME", str(root))
        patch.setattr(importer, "build_proxy_pack", with_content)
        importer.import_code4scene(root / "tasks/yard", root / "suites/yard", root / "packs", lambda line: None)
        yield root


@pytest.fixture(scope="module")
def pack(home: Path) -> Path:
    (folder,) = (home / "packs").iterdir()
    return folder


@pytest.fixture(scope="module")
def done(home: Path) -> list[Trial]:
    """The trials of a run that is done."""
    suite = SuiteFolder(home / "suites/yard")
    agents = [Configuration(name="planner", client="planner")]
    plan = make_plan(suite, agents, run_id="editor", policy=DEFAULT_POLICY, judge="rule", engine="unreal-standin")
    run = home / "runs/editor"
    open_run(run, plan)
    waiting = list(trials(run, suite.root, plan))

    async def drive() -> None:
        async with Pool(1) as pool:
            assert await run_trials(waiting, plan, pool, stage_functions()) == []

    asyncio.run(drive())
    return waiting


def test_a_scene_built_in_an_editor_is_scored(done: list[Trial]) -> None:
    score = TrialScore.read(done[0].folder.score)
    assert (score.engine, score.retained_attempt) == ("unreal-standin", 1)
    assert score.components["physics"] and score.components["overview"] == 0.0, "of a prompt without requirements"
    attempt = done[0].folder.attempt(1)
    outcome = AttemptOutcome.read(attempt.outcome)
    assert outcome.ended_by == "finished" and outcome.engine_version == "5.6.0-standin"
    assert outcome.submission is not None and (attempt.submission / f"{outcome.submission[1:]}.umap").is_file()
    evidence = done[0].folder.evidence
    assert read_json(evidence.snapshot)["c4s"]["engine_version"] == "5.6.0-standin"
    assert read_json(evidence.captures_index)["engine_version"] == "5.6.0-standin"
    assert len(list(evidence.captures.glob("*.png"))) == len(list(evidence.captures.glob("*.actors.npz"))) == 4


def test_a_pack_without_unreal_content_is_refused_in_one_line(pack: Path, tmp_path: Path, editor: Path) -> None:
    manifest = Pack.read(pack / "pack.json")
    bare = tmp_path / "bare"
    manifest.model_copy(update={"files": {}}).write(bare / "pack.json")
    with pytest.raises(BadInput, match="no Unreal content") as told:
        EditorSession.start("unreal-standin", packs=[bare], content=tmp_path / "c", scratch=tmp_path / "s")
    assert "\n" not in told.value.line() and "docs/unreal.md" in told.value.line()


def test_content_of_another_engine_is_refused(pack: Path, tmp_path: Path, editor: Path) -> None:
    other = tmp_path / "other"
    Pack.read(pack / "pack.json").write(other / "pack.json")
    told = read_json(pack / "unreal/content.json")
    (other / "unreal").mkdir()
    (other / "unreal/content.json").write_text(json.dumps({**told, "engine": "5.6"}))
    with pytest.raises(BadInput, match=r"saved by engine 5\.6, and this editor is 5\.6\.0-standin"):
        EditorSession.start("unreal-standin", packs=[other], content=tmp_path / "c", scratch=tmp_path / "s")


def test_only_what_a_case_offers_is_there(pack: Path, tmp_path: Path, editor: Path) -> None:
    tell = "import unreal\nhas = unreal.EditorAssetLibrary.does_asset_exist\n"
    tell += "print(has('/Game/P/SM_Box'), has('/Game/P/SM_Post'))"
    with EditorSession.start(
        "unreal-standin",
        packs=[pack],
        content=tmp_path / "c",
        scratch=tmp_path / "s",
        offered=["/Game/P/SM_Box.SM_Box"],
    ) as session:
        assert session.execute(tell)["result"]["python_logs"] == ["True False"]


def test_a_second_clean_editor_exports_what_the_first_saved(pack: Path, tmp_path: Path, editor: Path) -> None:
    content = tmp_path / "content"
    with EditorSession.start("unreal-standin", packs=[pack], content=content, scratch=tmp_path / "scratch") as first:
        assert first.execute(BUILD)["result"]["python_logs"] == ["True"]
        assert (content / "Game/SavedScenes/yard.umap").is_file()
        assert json.loads((content / SAVES).read_text()) == {"package": "/Game/SavedScenes/yard"}
    before = (content / "Game/SavedScenes/yard.umap").read_bytes()
    with open_clean(
        engine="unreal-standin", packs=[pack], submission_content=content, package="/Game/SavedScenes/yard"
    ) as clean:
        snapshot = clean.export(tmp_path / "evidence")
    assert snapshot["actor_count"] == 12 and snapshot["c4s"]["meshes"]["/Game/P/SM_Box.SM_Box"]["sha256"]
    assert (content / "Game/SavedScenes/yard.umap").read_bytes() == before


def test_half_a_package_is_kept_and_is_the_scenes_fault(pack: Path, tmp_path: Path, editor: Path) -> None:
    content = tmp_path / "content"
    with behaving(editor, torn_saves=True):
        session = EditorSession.start("unreal-standin", packs=[pack], content=content, scratch=tmp_path / "scratch")
        with session, pytest.raises(Exception, match="the disk went away"):
            session.execute(BUILD)
    assert (content / "Game/SavedScenes/yard.umap").is_file()
    with (
        pytest.raises(SceneUnreadable, match="cannot be opened"),
        open_clean(engine="unreal-standin", packs=[pack], submission_content=content, package="/Game/SavedScenes/yard"),
    ):
        pass


def test_a_level_document_becomes_the_level_that_it_says_and_no_submission(
    pack: Path, tmp_path: Path, editor: Path
) -> None:
    document = Level.parse(
        {
            "package": "/Game/Start/Yard",
            "actors": [
                {
                    "name": f"StaticMeshActor_{number}",
                    "label": label,
                    "class_path": "/Script/Engine.StaticMeshActor",
                    "guid": f"{number:032X}",
                    "transform": {"location_cm": [100 * number, 0, 50], "rotation_deg": [0, 30, 0], "scale": [1, 2, 1]},
                    "tags": [f"sca.stable_actor_id=thing-{number}"],
                    "folder": "Things",
                    "parent": "StaticMeshActor_1" if number == 2 else None,
                    "components": [
                        {
                            "name": "StaticMeshComponent0",
                            "class_path": "/Script/Engine.StaticMeshComponent",
                            "static_mesh": "/Game/P/SM_Box.SM_Box",
                        }
                    ],
                }
                for number, label in ((1, "One"), (2, "Two"))
            ],
        }
    )
    document.write(tmp_path / "start.level.json")
    options = {"levels": [tmp_path / "start.level.json"], "start_map": "/Game/Start/Yard"}
    with open_engine(
        "unreal-standin",
        packs=[pack],
        content=tmp_path / "c",
        scratch=tmp_path / "s",
        **options,  # type: ignore[arg-type]
    ) as engine:
        assert engine.call("scene_tools.current_level") == "/Game/Start/Yard"
    assert list((tmp_path / "c").iterdir()) == []
    found, glimpses = [], []
    for kind in ("headless", "unreal-standin"):
        out = EvidenceFolder(tmp_path / kind)
        with open_level(engine=kind, packs=[pack], level=tmp_path / "start.level.json") as clean:
            actors = clean.export(out.root)["actors"]
            clean.look(out.root, [VIEW])
            glimpses.append(clean.probe([AIMED]))
        masks = [np.load(path) for path in sorted(out.captures.glob("*.actors.npz"))]
        found.append(([{**actor, "actor_guid": ""} for actor in actors], masks))
    (told, seen), (told_by_editor, traced) = found
    assert told_by_editor == told
    assert glimpses[0] == glimpses[1] and glimpses[0][0]["visible"]
    assert len(seen) == len(traced) == 1
    for own, other in zip(seen, traced, strict=True):
        assert (own["actor"] >= 0).any() and list(own["names"]) == list(other["names"])
        np.testing.assert_array_equal(own["actor"], other["actor"])


def test_a_warmed_cache_is_written_by_no_later_editor(home: Path, pack: Path, tmp_path: Path) -> None:
    cache = backend("unreal-standin").warm([pack])
    assert cache.is_relative_to(home / "cache") and cache.is_dir()
    (cache / "shaders").write_text("compiled")
    spoil = f"open({str(cache / 'shaders')!r}, 'w').write('spoilt')"
    with EditorSession.start("unreal-standin", packs=[pack], content=tmp_path / "c", scratch=tmp_path / "s") as session:
        assert session.execute(spoil)["status"] == "error"
    assert (cache / "shaders").read_text() == "compiled"
