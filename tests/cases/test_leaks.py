"""The leak audit: a leak of every kind is planted in a built case and found as that kind; built suites have none."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from PIL import Image
from PIL.PngImagePlugin import PngInfo

from c4s.errors import BadInput
from c4s.records.level import Level, LevelActor
from c4s.records.suite import AgentCase, SuiteFolder
from cases.leaks import CHECKS, check_leaks, leaks
from tests.cases.test_case_suite import paddock_home
from tests.starter import starter_home

COW = "paddock-cow"


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return paddock_home(tmp_path_factory) / "suites/small"


@pytest.fixture
def suite(built: Path, tmp_path: Path) -> SuiteFolder:
    """A copy to plant in."""
    return SuiteFolder(Path(shutil.copytree(built, tmp_path / "small")))


def agent(suite: SuiteFolder) -> Path:
    return suite.agent(suite.case(COW).alias)


def put(suite: SuiteFolder, name: str, data: bytes = b"{}") -> None:
    path = agent(suite) / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)


def edit(suite: SuiteFolder, change: Callable[[LevelActor], LevelActor]) -> None:
    """The first actor of the start level is another."""
    path = agent(suite) / "start.level.json"
    level = Level.read(path)
    level.model_copy(update={"actors": [change(level.actors[0]), *level.actors[1:]]}).write(path)


def truth_as_start(suite: SuiteFolder) -> None:
    shutil.copy(suite.withheld(COW) / "truth.level.json", agent(suite) / "start.level.json")


def of_class(path: str) -> Callable[[LevelActor], LevelActor]:
    return lambda actor: actor.model_copy(update={"class_path": path})


def names_a_world(actor: LevelActor) -> LevelActor:
    return actor.model_copy(update={"properties": {"world_asset": "/Game/Maps/Original.Original"}})


def tagged(actor: LevelActor) -> LevelActor:
    return actor.model_copy(update={"tags": ["simcodearena.actor_origin=inserted"]})


def labelled(actor: LevelActor) -> LevelActor:
    return actor.model_copy(update={"label": COW})


def start_picture_as_reference(suite: SuiteFolder) -> None:
    shutil.copy(
        suite.withheld(COW) / "views/start/reference.png",
        agent(suite) / suite.agent_case(suite.case(COW).alias).reference_views[0],
    )


def commented(suite: SuiteFolder) -> None:
    path = agent(suite) / suite.agent_case(suite.case(COW).alias).reference_views[0]
    words = PngInfo()
    words.add_text("Comment", "the cow was turned by 90")
    Image.open(path).save(path, pnginfo=words)


def lengthened(suite: SuiteFolder) -> None:
    path = agent(suite) / suite.agent_case(suite.case(COW).alias).reference_views[0]
    path.write_bytes(path.read_bytes() + b"turned by 90")


def told_by_prompt(suite: SuiteFolder) -> None:
    path = agent(suite) / "case.json"
    case = AgentCase.read(path)
    case.model_copy(update={"prompt": f"{case.prompt} A COW TURNED ROUND."}).write(path)


PLANTED: list[tuple[str, Callable[[SuiteFolder], None]]] = [
    ("original maps", lambda suite: put(suite, "Original.umap")),
    ("original maps", lambda suite: put(suite, "maps/old.level.json")),
    ("original maps", truth_as_start),
    ("externally stored actors", lambda suite: put(suite, "Content/__ExternalActors__/Maps/A/0/XY.uasset")),
    ("externally stored actors", lambda suite: put(suite, "__externalobjects__/one")),
    ("level instances and packed actors", lambda suite: edit(suite, of_class("/Script/Engine.LevelInstance"))),
    ("level instances and packed actors", lambda suite: edit(suite, of_class("/Script/Engine.PackedLevelActor"))),
    ("level instances and packed actors", lambda suite: edit(suite, names_a_world)),
    ("prefabs", lambda suite: put(suite, "SM_Cow.uasset")),
    ("prefabs", lambda suite: put(suite, "references/Cow.GLB")),
    ("prefabs", lambda suite: edit(suite, of_class("/Game/Original/BP_Cow.BP_Cow_C"))),
    ("cached layouts", lambda suite: put(suite, "Saved/layout.json")),
    ("cached layouts", lambda suite: put(suite, ".cache", b"x")),
    (
        "cached layouts",
        lambda suite: put(suite, "start.json", (suite.withheld(COW) / "truth.snapshot.json").read_bytes()),
    ),
    ("screenshots", lambda suite: put(suite, "references/truth-02.png", b"")),
    ("screenshots", lambda suite: put(suite, "Saved/Screenshots/HighRes.JPG", b"")),
    ("screenshots", start_picture_as_reference),
    ("telling metadata", commented),
    ("telling metadata", lengthened),
    ("telling metadata", told_by_prompt),
    ("telling metadata", lambda suite: edit(suite, tagged)),
    ("telling metadata", lambda suite: edit(suite, labelled)),
    ("telling metadata", lambda suite: put(suite, f"{COW}.txt")),
]


def test_there_is_a_planted_leak_of_every_kind() -> None:
    assert list(dict.fromkeys(kind for kind, _ in PLANTED)) == list(CHECKS)


@pytest.mark.parametrize(("kind", "plant"), PLANTED, ids=[f"{n}-{kind}" for n, (kind, _) in enumerate(PLANTED)])
def test_a_planted_leak_is_found_as_what_it_is(
    suite: SuiteFolder, kind: str, plant: Callable[[SuiteFolder], None]
) -> None:
    assert leaks(suite) == []
    plant(suite)
    found = leaks(suite)
    assert kind in {leak.kind for leak in found} and {leak.case_id for leak in found} == {COW}
    with pytest.raises(BadInput, match="leaks; the first"):
        check_leaks(found)


def test_the_starter_suite_has_no_leak(tmp_path_factory: pytest.TempPathFactory) -> None:
    home = starter_home(tmp_path_factory)
    found = leaks(SuiteFolder(home / "suites/starter"))
    check_leaks(found)
    assert found == []
