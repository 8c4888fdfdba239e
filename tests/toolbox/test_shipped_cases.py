"""Every asset that a case of the starter suite offers is found, described, shown and spawned by the tools."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from c4s.agents.baselines.palette import description
from c4s.engine import open_engine
from c4s.records.suite import AgentCase, SuiteFolder
from c4s.toolbox.catalog import CaseCatalog
from c4s.toolbox.client import GatewayClient
from c4s.toolbox.gateway import Gateway
from c4s.toolbox.gateway_run import Run
from c4s.toolbox.ground import choose_ground
from c4s.toolbox.refusal import ToolRefused
from c4s.toolbox.workbench import Workbench
from tests.starter import starter_home

Built = tuple[SuiteFolder, Path]
pytestmark = pytest.mark.timeout(900)
"""The whole suite is built where it is not there yet, with every preview."""
PART = 15
"""Assets that one answer describes."""
SPAWNED_WITH = {"spawn_actor": ("name", "static_mesh"), "spawn_blueprint_actor": ("actor_name", "blueprint_id")}
"""The arguments of a spawning tool that take the label and the asset."""


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Built:
    home = starter_home(tmp_path_factory)
    return SuiteFolder(home / "suites/starter"), home / "packs"


def _load(built: Built, case_id: str) -> tuple[AgentCase, list[Path], CaseCatalog]:
    suite, packs = built
    case = suite.agent_case(suite.case(case_id).alias)
    folders = [packs / pack.pack_id for pack in case.packs]
    return case, folders, CaseCatalog.load(case, folders)


def test_the_catalog_of_every_case_is_what_the_case_offers(built: Built) -> None:
    cases = [case.case_id for case in built[0].suite().cases]
    assert len(cases) >= 16
    blueprints = 0
    for case_id in cases:
        case, _, catalog = _load(built, case_id)
        assert sorted(entry.asset.spawn_path for entry in catalog.entries) == sorted(case.catalog)
        for path in case.catalog:
            found = catalog.find(path)
            assert found.asset.spawn_path == path and catalog.find(found.asset.path) is found
            blueprints += found.asset.kind == "blueprint"
    assert blueprints >= 32


GROUNDS = {
    "text-flat-family": "floor_parquet200",
    "text-harbour-street": "cobble_tile",
    "text-office-open-plan": "floor_carpet200",
    "text-small-farm": "grass_tile",
}


@pytest.mark.parametrize(
    ("case_id", "text", "ground"),
    [
        ("text-harbour-street", "a cobbled square by the canal", "cobble_tile"),
        ("text-harbour-street", "an asphalt car park", "road_tile"),
        ("text-small-farm", "a farm", "grass_tile"),
        ("text-small-farm", "ploughed fields", "field_tile"),
        ("text-small-farm", "a courtyard with stone paving", "flagstone_tile"),
        ("text-flat-family", "a bathroom", "floor_bath200"),
        ("text-office-open-plan", "an office", "floor_carpet200"),
    ],
)
def test_the_ground_is_chosen_by_meaning(built: Built, case_id: str, text: str, ground: str) -> None:
    assert choose_ground(text, _load(built, case_id)[2].entries).entry.asset.id == ground


@pytest.mark.parametrize("text", ["a desert with dunes", "a rain forest", "!!!"])
def test_where_no_ground_fits_none_is_laid(built: Built, text: str) -> None:
    with pytest.raises(ToolRefused):
        choose_ground(text, _load(built, "text-office-open-plan")[2].entries)


def test_rugs_ponds_and_ceilings_are_no_ground(built: Built) -> None:
    for case_id in GROUNDS:
        entries = _load(built, case_id)[2].entries
        loose = [entry for entry in entries if re.search("rug|pond|water|ceiling", entry.asset.id)]
        with pytest.raises(ToolRefused, match="no asset that is a ground"):
            choose_ground("a rug by the pond", loose)


@pytest.mark.parametrize("case_id", GROUNDS)
def test_what_a_case_offers_is_found_described_shown_planned_and_spawned(
    built: Built, case_id: str, tmp_path: Path
) -> None:
    case, folders, catalog = _load(built, case_id)
    agent_folder = built[0].agent(case.alias)
    with (
        open_engine(
            "headless",
            packs=folders,
            content=tmp_path / "content",
            scratch=tmp_path / "scratch",
            levels=[agent_folder / "start.level.json"],
            start_map=case.start_map,
        ) as engine,
        Gateway() as gateway,
    ):
        engine.call("scene_tools.open_level", package=case.start_map)
        bench = Workbench(case, agent_folder, catalog, engine, tmp_path / "scratch")
        endpoint = gateway.open_run(Run(case_id, bench, case.budget, tmp_path / "trajectory.jsonl"))
        with GatewayClient(endpoint) as client:
            assets: list[dict[str, Any]] = []
            for at in range(0, len(case.catalog), PART):
                told = client.call("get_asset_metadata", ids=case.catalog[at : at + PART]).data
                assert told["missing"] == []
                assets += told["assets"]
            assert [asset["spawn_path"] for asset in assets] == case.catalog
            for number, asset in enumerate(assets):
                found = client.call("search_assets", query=asset["name"]).data["assets"]
                assert asset["spawn_path"] in [row["spawn_path"] for row in found], asset["name"]
                assert client.call("get_asset_preview", id=asset["id"]).images[0].startswith(b"\x89PNG")
                name, key = SPAWNED_WITH[asset["spawn_with"]]
                client.call(
                    asset["spawn_with"], **{name: f"One_{number}", key: asset["spawn_path"]}, location=[0, 0, 0]
                )
            ground = client.call("ground_pass", scene_text=description(case.prompt), half_extent_m=10)
            assert ground.data["laid"]["id"] == GROUNDS[case_id] and ground.data["count"] > 0
            assert ground.images[0].startswith(b"\x89PNG") and ground.data["laid"]["why"]
            graph = {
                "nodes": [{"id": f"n{n}", "asset": path, "at": [n - 40, 0]} for n, path in enumerate(case.catalog)]
            }
            solved = client.call("solve_scene_graph", graph=graph, mode="exact").data["solved"]
            assert solved["dropped"] == [] and len(solved["entries"]) == len(case.catalog)
            built_up = client.call("build_tier", entries=solved["entries"]).data
            assert built_up["count"] == len(case.catalog) and built_up["failed"] == []
