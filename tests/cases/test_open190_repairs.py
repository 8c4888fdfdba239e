"""The repairs of open-190: a plan with the paper's counts, and units that are the same each time and survive a kill."""

from __future__ import annotations

import multiprocessing
import os
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.files import read_json, write_json
from c4s.geometry.transform import affine
from c4s.packs.meshes import Mesh
from c4s.packs.store import PackStore
from c4s.records.level import Level, Vector
from c4s.records.pack import STAMP
from c4s.records.suite import SuiteFolder, WithheldFolder
from c4s.render import Instance, Lights, Renderer, SurfaceMaterial
from c4s.render.masks import camera_of
from c4s.trees import listing_digest, read_listing
from cases.admissible import LEAST_PIXELS, TargetSighting, score_refusals
from cases.model import CaseView
from cases.open190.build import sources
from cases.open190.library import SCENES
from cases.open190.repairs.difficulty import Hardness, hardness
from cases.open190.repairs.lookouts import screened
from cases.open190.repairs.plan import NESTED, PUBLIC_SEED, WantedRepair, histogram, planned, planned_texts
from cases.open190.repairs.unit import UNIT
from cases.open190.secret import VARIABLE, private_seed
from cases.open190.suite import UnitPlan, build_units, unit_plans
from cases.sharing import link_tree, share_equal
from cases.views import camera
from catalog.build import build_pack

ROOMS = {kind: [name for name, spec in SCENES.items() if spec.kind == kind] for kind in ("indoor", "outdoor")}
SEED = "a secret of the operator, 0123456789"
SCENE = "loft"
PUBLIC = WantedRepair("loft-1", SCENE, "indoor", "Restore", 1, "easy", "public", 61)
PRIVATE = WantedRepair("loft-3", SCENE, "indoor", "Layout", 1, "easy", "private", 190)


def plan(seed: str = SEED) -> list[WantedRepair]:
    """Both halves."""
    return [*planned(ROOMS, "public"), *planned(ROOMS, "private", seed)]  # type: ignore[arg-type]


@settings(max_examples=20, deadline=None)
@given(st.text(min_size=1, max_size=40))
def test_the_counts_are_those_of_the_paper_whatever_the_private_seed(seed: str) -> None:
    repairs = plan(seed)
    indoor, outdoor = histogram(repairs, "indoor"), histogram(repairs, "outdoor")
    assert indoor["groups"] == {"Restore": 20, "Lifecycle": 20, "Layout": 10, "Symmetry": 10, "Transform": 20}
    assert outdoor["groups"] == {"Restore": 25, "Lifecycle": 16, "Layout": 19, "Symmetry": 7, "Transform": 13}
    assert outdoor["chains"] == {1: 25, 2: 3, 3: 26, 4: 25, 5: 1}
    assert indoor["tiers"] == outdoor["tiers"] == {"easy": 27, "medium": 26, "hard": 27}
    assert indoor["visibility"] == {"public": 25, "private": 55}
    assert outdoor["visibility"] == {"public": 50, "private": 30}
    assert set(Counter(one.scene_id for one in repairs).values()) == {8}
    assert len({one.case_id for one in repairs}) == 160
    assert sum(one.group == "Symmetry" and one.visibility == "public" for one in repairs) == 8


def test_the_sets_are_nested_and_of_the_papers_sizes() -> None:
    texts = planned_texts([name for name, spec in SCENES.items() if spec.kind == "text"])
    repairs = plan()
    for size, counts in NESTED.items():
        assert sum(one.nested <= size for one in repairs if one.environment == "indoor") == counts["indoor"]
        assert sum(one.nested <= size for one in repairs if one.environment == "outdoor") == counts["outdoor"]
        assert sum(nested <= size for _, nested in texts.values()) == counts["text"]
        assert sum(counts.values()) == size
    assert all((one.nested <= 95) == (one.visibility == "public") for one in repairs)
    assert Counter(half for half, _ in texts.values()) == {"public": 20, "private": 10}


def test_a_private_seed_deals_the_private_half_anew_and_leaves_the_public_one() -> None:
    other = plan("another secret of another operator")
    assert [one for one in other if one.visibility == "public"] == planned(ROOMS, "public")  # type: ignore[arg-type]
    assert other != plan()
    assert plan() == plan()


@settings(max_examples=20, deadline=None)
@given(st.text(min_size=16, max_size=40))
def test_no_seed_changes_which_groups_a_place_is_dealt(seed: str) -> None:
    dealt = [(one.case_id, one.group) for one in plan(seed)]
    assert dealt == [(one.case_id, one.group) for one in plan()]
    assert not [case for case, group in dealt if group == "Symmetry" and case.startswith("forest-ruins-")]


def test_without_a_seed_there_is_no_private_half() -> None:
    assert {one.visibility for one in unit_plans(None)} == {"public"}
    assert sum(len(one.wanted) or 1 for one in unit_plans(None)) == 95
    assert sum(len(one.wanted) or 1 for one in unit_plans(SEED)) == 190


@pytest.mark.parametrize("seed", ["", "short", "aaaaaaaaaaaaaaaaaaaaaaaa"])
def test_a_seed_that_can_be_guessed_is_refused(seed: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, seed)
    with pytest.raises(BadInput, match="can be guessed"):
        private_seed()


def test_the_file_of_the_seed_is_for_the_operator_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path))
    monkeypatch.delenv(VARIABLE, raising=False)
    assert private_seed() is None
    place = tmp_path / "private-seed"
    place.write_text(SEED + "\n")
    place.chmod(0o644)
    with pytest.raises(BadInput, match="others may read"):
        private_seed()
    place.chmod(0o600)
    assert private_seed() == SEED
    place.unlink()
    place.symlink_to(tmp_path / "elsewhere")
    with pytest.raises(BadInput, match="no plain file"):
        private_seed()


@given(st.lists(st.integers(min_value=LEAST_PIXELS, max_value=900_000), min_size=1, max_size=8))
def test_a_target_that_is_harder_to_see_never_makes_a_repair_easier(pixels: list[int]) -> None:
    def prior(shown: list[int]) -> Hardness:
        return hardness((), (), 0, [TargetSighting("a", (), one, None, None) for one in shown])

    fainter = [max(LEAST_PIXELS, one // 2) for one in pixels]
    assert 0 <= prior(pixels).prior <= prior(fainter).prior <= 1


def test_equal_files_are_stored_once(tmp_path: Path) -> None:
    for name, text in (("a/truth.json", "x" * 99), ("b/truth.json", "x" * 99), ("b/start.json", "y" * 99)):
        (tmp_path / "one" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "one" / name).write_text(text)
    assert share_equal(tmp_path / "one") == 99
    assert (tmp_path / "one/a/truth.json").samefile(tmp_path / "one/b/truth.json")
    link_tree(tmp_path / "one", tmp_path / "two")
    assert read_listing(tmp_path / "one") == read_listing(tmp_path / "two")
    assert share_equal(tmp_path / "one") == 0


# units


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A home with the pack of the smallest room."""
    root = tmp_path_factory.mktemp("open190")
    place = SCENES[SCENE].place()
    build_pack(place.assortment.pack(place.pack_id, "Loft"), root / "packs", previews=False)
    write_json(root / "packs" / place.pack_id / STAMP, {"sources": sources()})
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("C4S_HOME", str(root))
        yield root


def unit(wanted: WantedRepair, seed: str) -> UnitPlan:
    """A unit of one repair."""
    return UnitPlan(SCENES[SCENE], wanted.visibility, seed, (wanted,))


HALVES = [unit(PUBLIC, PUBLIC_SEED), unit(PRIVATE, SEED)]


def _killed_in_the_private_half(packs: Path) -> None:
    def step(message: str) -> None:
        if message.startswith("loft (private)"):
            os._exit(9)

    build_units(HALVES, packs, step)


@pytest.fixture(scope="module")
def units(home: Path) -> tuple[list[Path], list[str], float]:
    """Both halves of a build that was killed and went on: their folders, the steps, and when the first was made."""
    killed = multiprocessing.get_context("fork").Process(target=_killed_in_the_private_half, args=(home / "packs",))
    killed.start()
    killed.join()
    assert killed.exitcode == 9
    made = (home / "cache/open-190/loft-public" / UNIT).stat().st_mtime_ns
    steps: list[str] = []
    return build_units(HALVES, home / "packs", steps.append), steps, made


def test_a_build_that_was_killed_goes_on_where_it_was(units: tuple[list[Path], list[str], float]) -> None:
    folders, steps, made = units
    assert (folders[0] / UNIT).stat().st_mtime_ns == made
    assert not any("public" in step for step in steps) and any("private" in step for step in steps)


def test_a_unit_is_the_same_bytes_twice(
    units: tuple[list[Path], list[str], float], home: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path))
    again = build_units(HALVES[:1], home / "packs", lambda _: None)
    assert listing_digest(read_listing(again[0])) == listing_digest(read_listing(units[0][0]))


@pytest.mark.parametrize("half", [0, 1])
def test_what_ships_is_admissible(units: tuple[list[Path], list[str], float], home: Path, half: int) -> None:
    folder, wanted = SuiteFolder(units[0][half]), (PUBLIC, PRIVATE)[half]
    withheld = folder.withheld_case(wanted.case_id)
    agent = folder.agent_case(withheld.alias)
    trees = WithheldFolder(folder.withheld(wanted.case_id))
    store = PackStore([home / "packs/open-loft"])
    snapshots = read_json(trees.truth_snapshot), read_json(trees.input_snapshot)
    assert score_refusals(wanted.case_id, agent.setting, *snapshots, store, {}) == []
    assert withheld.difficulty == wanted.tier and withheld.operation_group == wanted.group
    assert len(withheld.operations) == wanted.chain and withheld.visibility == wanted.visibility
    assert len(agent.reference_views) == 2
    seen = read_json(folder.sightings)[wanted.case_id]
    assert seen and all(row["pixels"] >= LEAST_PIXELS for row in seen)
    terms = read_json(folder.root / UNIT)["cases"][wanted.case_id]["difficulty"]
    assert Hardness(**{name: value for name, value in terms.items() if name != "prior"}).tier == wanted.tier


def test_the_halves_of_a_scene_share_no_place_of_what_stands_free(units: tuple[list[Path], list[str], float]) -> None:
    """Who has the public truth of a scene knows little of the private one."""
    truths = [
        Level.read(WithheldFolder(SuiteFolder(folder).withheld(one.case_id)).truth_level)
        for folder, one in zip(units[0], (PUBLIC, PRIVATE), strict=True)
    ]
    names = [{actor.name for actor in truth.actors} for truth in truths]
    places = [{tuple(np.round(actor.transform.location_cm, 1)) for actor in truth.actors} for truth in truths]
    assert len(places[0] - places[1]) > 0.2 * len(places[0])
    ids = [{tag for actor in truth.actors for tag in actor.tags if "id" in tag and "=" in tag} for truth in truths]
    assert names[0] != names[1] and not {one for one in ids[0] & ids[1] if "stable" in one}


@pytest.mark.parametrize(
    ("block", "size", "hidden"),
    [
        ((300.0, 0.0, 150.0), (20.0, 260.0, 300.0), True),
        ((1200.0, 0.0, 150.0), (20.0, 2600.0, 900.0), False),
        ((300.0, 0.0, 150.0), (20.0, 40.0, 300.0), False),
    ],
    ids=["a board before the things", "a wall behind them", "a post"],
)
def test_no_view_has_a_screen_before_its_things(block: Vector, size: Vector, hidden: bool) -> None:
    box, white = trimesh.creation.box((100, 100, 100)), (SurfaceMaterial(),)
    corners, normals = box.vertices.astype(np.float32), box.vertex_normals.astype(np.float32)
    faces = box.faces.astype(np.int32)
    mesh = Mesh(corners, faces, normals, np.zeros((8, 2), np.float32), np.zeros(12, np.int32))
    placed = [
        Instance(0, affine((0, 0, -5), (0, 0, 0), (60, 60, 0.1)), white, 0),
        Instance(0, affine((900, 500, 50), (0, 0, 0), (1, 1, 1)), white, 1),
        Instance(0, affine(block, (0, 0, 0), [side / 100 for side in size]), white, 2),
    ]
    view = CaseView("eye", (0.0, 0.0, 165.0), (900.0, 0.0, 100.0), 70.0, width=320, height=180)
    renderer = Renderer([mesh], placed, Lights())
    picture = renderer.render(camera_of(camera(view)), mode="base_color", samples=1)
    renderer.close()
    assert (picture.actor == 1).sum() > 100
    assert screened(view, picture, [1]) == hidden
