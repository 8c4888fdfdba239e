"""Stage 2 on the starter texts: which views claims get, by the real engine, on the scenes that the oracle saves."""

from __future__ import annotations

import json
import math
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from c4s.evidence import Shots, open_level
from c4s.files import read_json, write_json
from c4s.protocol.bundle import Requirements, read_requirements
from c4s.records.captures import Captures
from c4s.records.evidence import catalog_facts
from c4s.records.folder import EvidenceFolder
from c4s.records.pack import Pack
from c4s.records.suite import SuiteFolder, WithheldFolder
from c4s.semantics.kinds import Facts
from c4s.semantics.sight import overview_plan, sight_plan
from c4s.semantics.sight.looks import APART_DEG
from c4s.semantics.sight.needs import MOST_THINGS, urgency
from c4s.semantics.sight.plan import MOST_VIEWS
from c4s.semantics.state import StateDecider
from c4s.semantics.views import SEEN_SHARE
from cases.starter.suite import SUITE_ID
from tests.starter import starter_home

FLAT, FARM = "text-flat-family", "text-small-farm"
Probed = Callable[[Sequence[Mapping[str, Any]]], Sequence[Mapping[str, Any]]]


class Shipped:
    """A text case of the starter suite, as the evaluator has it."""

    def __init__(self, home: Path, case_id: str) -> None:
        suite = SuiteFolder(home / "suites" / SUITE_ID)
        self.withheld = WithheldFolder(suite.withheld(case_id))
        case = suite.agent_case(suite.withheld_case(case_id).alias)
        self.packs = [home / "packs" / pack.pack_id for pack in case.packs]
        self.bundle = read_json(self.withheld.requirements)
        self.requirements: Requirements = read_requirements(self.bundle)
        self.catalog: dict[str, Facts] = dict(catalog_facts(Pack.read(folder / "pack.json") for folder in self.packs))

    def look(self, out: Path, plan: Any, level: Path | None = None) -> tuple[dict[str, Any], Captures]:
        """What a plan has photographed of the case's own scene, or of another level."""
        with open_level(engine="headless", packs=self.packs, level=level or self.withheld.truth_level) as clean:
            snapshot = clean.export(out)
            clean.look(out, plan)
        return snapshot, Captures.read(EvidenceFolder(out).captures_index)


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the starter suite is built."""
    return starter_home(tmp_path_factory)


@pytest.fixture(scope="module")
def farm(home: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Shipped, dict[str, Any], Captures, Path]:
    """The farm of the oracle, looked at as its claims need."""
    case, out = Shipped(home, FARM), tmp_path_factory.mktemp("farm") / "evidence"
    snapshot, captures = case.look(out, sight_plan(case.requirements, case.catalog))
    return case, snapshot, captures, out


def test_every_claim_that_sight_may_be_needed_for_has_a_view_or_a_reason(farm: Any) -> None:
    case, snapshot, captures, _ = farm
    judge = StateDecider(case.requirements, snapshot, case.catalog)
    asked = {node for node in case.requirements.scored if urgency(judge, node) is not None}
    assert set(captures.claims) == asked
    assert asked >= {node for node in case.requirements.scored if judge.decide(node).status == "UNKNOWN"}
    for found in captures.claims.values():
        assert bool(found.primary) != bool(found.reason)
        assert found.primary or found.reason.startswith("no object of the scene is bound to"), "the farm hides nothing"


def test_the_views_of_a_case_are_few_and_shared(farm: Any) -> None:
    _, _, captures, _ = farm
    assert len(captures.of("overview")) == 4 and len(captures.of("claim")) <= MOST_VIEWS
    users = Counter(name for found in captures.claims.values() for name in (*found.primary, *found.alternate))
    assert set(users) >= {view.name for view in captures.of("claim")}, "no picture is taken for nothing"
    assert max(users.values()) > 2


def test_views_show_what_claims_need_by_the_mask_of_the_picture(farm: Any) -> None:
    _, _, captures, out = farm
    views = {view.name: view for view in captures.views}
    shown, sought = 0, 0
    for found in captures.claims.values():
        sees = {actor for name in found.primary for actor, n in (views[name].visible or {}).items() if n >= 30}
        shown += len(sees & set(found.targets))
        sought += found.coverage.sought
        assert found.coverage.seen <= found.coverage.sought == len(found.targets) <= found.coverage.targets
        assert len(found.targets) <= 2 * MOST_THINGS * 3
    assert shown >= 0.85 * sought
    claim = captures.of("claim")[0]
    with Image.open(EvidenceFolder(out).captures / claim.file) as picture:
        assert picture.size == (claim.camera.width, claim.camera.height) == (640, 360)
    mask = np.load(EvidenceFolder(out).captures / str(claim.actors))
    counts = {str(mask["names"][n]): int((mask["actor"] == n).sum()) for n in np.unique(mask["actor"]) if n >= 0}
    assert counts == claim.visible


def test_an_alternate_looks_from_another_side(farm: Any) -> None:
    _, snapshot, captures, _ = farm
    views = {view.name: view for view in captures.views}
    bounds = {actor["name"]: actor["bounds"]["origin_cm"] for actor in snapshot["actors"] if actor.get("bounds")}
    angles = []
    for found in captures.claims.values():
        centre = np.mean([bounds[actor] for actor in found.targets], axis=0) if found.targets else None
        if len(found.primary) == 1 and found.alternate and centre is not None:
            one, other = (
                np.subtract(centre, views[name].camera.location_cm) for name in (*found.primary, *found.alternate)
            )
            angles.append(math.degrees(math.acos(one @ other / np.linalg.norm(one) / np.linalg.norm(other))))
    assert len(angles) > 5 and np.median(angles) >= APART_DEG


def test_the_same_scene_has_the_same_views(farm: Any, tmp_path: Path) -> None:
    case, _, captures, _ = farm
    _, again = case.look(tmp_path / "evidence", sight_plan(case.requirements, case.catalog))
    assert again == captures


def test_a_claim_about_what_is_not_there_has_no_view(home: Path, tmp_path: Path) -> None:
    case = Shipped(home, FARM)
    level = json.loads(case.withheld.truth_level.read_text())
    level["actors"] = [actor for actor in level["actors"] if "Silo" not in json.dumps(actor)]
    write_json(tmp_path / "bare.level.json", level)
    _, captures = case.look(
        tmp_path / "evidence", sight_plan(case.requirements, case.catalog), tmp_path / "bare.level.json"
    )
    of_silos = [node for node in captures.claims if "steel silos" in case.requirements.predicates[node].text]
    assert of_silos
    for node in of_silos:
        found = captures.claims[node]
        assert found.targets == [] and found.coverage.seen == 0
        assert bool(found.primary) != bool(found.reason)
        assert all(name.startswith("overview") for name in found.primary), "where state leaves it open"


def test_the_overview_shows_the_objects_of_the_flat_under_a_ceiling_too(home: Path, tmp_path: Path) -> None:
    case = Shipped(home, FLAT)
    level = json.loads(case.withheld.truth_level.read_text())
    shown = {}
    for name, more in (("open", []), ("roofed", _ceiling(level))):
        write_json(tmp_path / f"{name}.level.json", {**level, "actors": [*level["actors"], *more]})
        snapshot, captures = case.look(tmp_path / name, overview_plan, tmp_path / f"{name}.level.json")
        shown[name] = _share_seen(snapshot, captures, case.catalog)
    assert shown["open"] >= 0.97
    assert shown["roofed"] >= 0.5, "without a look inside nothing but walls is seen"


def _ceiling(level: dict[str, Any]) -> list[dict[str, Any]]:
    """A slab over all rooms, as an actor like the level's floors."""
    floor = next(actor for actor in level["actors"] if "FloorParquet" in (actor["components"][0]["static_mesh"] or ""))
    place = {"location_cm": [0.0, 0.0, 272.0], "rotation_deg": [0.0, 0.0, 0.0], "scale": [7.0, 5.0, 1.0]}
    return [{**floor, "name": "Ceiling_1", "label": "Ceiling_1", "guid": "0" * 32, "tags": [], "transform": place}]


def _share_seen(snapshot: dict[str, Any], captures: Captures, catalog: Mapping[str, Facts]) -> float:
    """Share of the actors of catalog assets that some overview view shows clearly."""
    pixels = {view.name: view.camera.width * view.camera.height for view in captures.views}
    seen = {
        actor
        for view in captures.of("overview")
        for actor, count in (view.visible or {}).items()
        if count >= SEEN_SHARE * pixels[view.name]
    }
    objects = [actor["name"] for actor in snapshot["actors"] if set(actor["component_asset_paths"]) & set(catalog)]
    return sum(name in seen for name in objects) / len(objects)


def test_an_empty_scene_has_four_views_and_no_claim_view(home: Path, tmp_path: Path) -> None:
    case = Shipped(home, FARM)
    level = {**json.loads(case.withheld.truth_level.read_text()), "actors": []}
    write_json(tmp_path / "empty.level.json", level)
    _, captures = case.look(
        tmp_path / "evidence", sight_plan(case.requirements, case.catalog), tmp_path / "empty.level.json"
    )
    assert [view.purpose for view in captures.views] == ["overview"] * 4
    assert all(not found.targets for found in captures.claims.values())


def test_a_camera_is_no_evidence(farm: Any) -> None:
    """What is captured tells where cameras stand and what they see, never whether a claim holds."""
    _, _, captures, _ = farm
    told = {key for found in captures.claims.values() for key in found.plain()}
    assert told == {"primary", "alternate", "targets", "coverage", "reason"}
    assert isinstance(Shots([]).claims, dict)
