"""How large the answers of the tools are, as the client of a run receives them: ``python -m bench.answers``.

Every tool is called on the largest shipped scene and on a town of 6,700 actors, as an agent would at first: without
arguments that ask for more or for less. An answer's size is what a model may get of it: all its texts, and
``structuredContent`` where there is any. Bytes of UTF-8, which no client counts as more characters.
"""

from __future__ import annotations

import json
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import mcp_types as wire

from bench.row import Row
from bench.town import town
from c4s.engine import DEFAULT_ENGINE, open_engine
from c4s.home import packs_root
from c4s.protocol.settings import OUTDOOR_REPAIR
from c4s.records.folder import AttemptFolder
from c4s.records.level import Level
from c4s.records.pack import Pack
from c4s.records.suite import AgentCase, Budget, PackRef
from c4s.toolbox.catalog import CaseCatalog
from c4s.toolbox.client import GatewayClient
from c4s.toolbox.gateway import Gateway
from c4s.toolbox.gateway_run import Run
from c4s.toolbox.registry import ALL_TOOLS
from c4s.toolbox.size import ANSWER_SIZE
from c4s.toolbox.workbench import Workbench
from cases.starter import harbour_scene
from catalog.build import ensure_pack

ACTORS = 6700
LARGEST = 10
PACK = "c4s-harbour"
_WORDS = "import unreal\nfor number in range(200_000): print('line', number)\nraise ValueError('x' * 3_000_000)"


def size_of(answer: wire.CallToolResult) -> int:
    """Bytes of an answer's texts and of its structured content."""
    texts = sum(len(block.text.encode()) for block in answer.content if isinstance(block, wire.TextContent))
    structured = answer.structured_content
    return texts + (len(json.dumps(structured)) if structured else 0)


def calls(pack: Pack) -> Iterator[tuple[str, dict[str, Any]]]:
    """A call of every tool, some with what makes their answer large."""
    meshes = [asset.id for asset in pack.assets if asset.kind == "static_mesh"]
    place = {"location": [0, 0, 0]}
    rows = [
        {"name": f"E{i}", "asset": meshes[0], "location": [500 * (i % 40), 500 * (i // 40), 0]} for i in range(1000)
    ]
    nodes = [{"id": f"n{i}", "asset": meshes[i % len(meshes)], "at": [i % 40 - 20, i // 40 - 20]} for i in range(1600)]
    ghosts = [{"id": f"ghost{i}", "asset": f"no such thing {i}"} for i in range(1000)]
    yield "search_assets", {"query": "a thing", "k": 100}
    yield "get_categories", {}
    yield "get_asset_metadata", {"ids": [asset.id for asset in pack.assets][:200]}
    yield "get_asset_preview", {"id": meshes[0]}
    yield "get_actors_in_level", {}
    yield "find_actors_by_name", {"pattern": "*"}
    yield "spawn_actor", {"name": "New", "static_mesh": meshes[0], **place}
    yield "spawn_blueprint_actor", {"actor_name": "Newer", "blueprint_id": "none", **place}
    yield "set_actor_transform", {"name": "New", **place}
    yield "delete_actor", {"name": "New"}
    yield "execute_python_script", {"script": _WORDS, "execution_mode": "sync"}
    yield "read_job_log", {}
    yield "validate_scene_graph", {"graph": {"nodes": nodes + ghosts}}
    yield "solve_scene_graph", {"graph": {"nodes": nodes}, "mode": "exact"}
    yield "render_plan", {}
    yield "tier_derivation", {}
    yield "build_tier", {"entries": rows}
    yield "build_tier", {"entries": rows}
    yield "measure_scene", {}
    yield "check_floating", {}
    yield "check_collisions", {}
    yield "ground_pass", {"scene_text": "a harbour with a cobbled square", "half_extent_m": 40}
    yield "delete_all_spawned", {}
    yield "setup_environment", {}
    yield "take_screenshot", {}
    yield "save_scene_as", {"name": "bench"}


@contextmanager
def opened(root: Path, level: Level, packs_folder: Path) -> Iterator[GatewayClient]:
    """A run on a level of the harbour's meshes, with its client."""
    pack = ensure_pack(PACK, packs_folder)
    folder = root / "agent" / "bench"
    level.write(folder / "start.level.json")
    case = AgentCase.parse(
        {
            "alias": "bench",
            "setting": OUTDOOR_REPAIR,
            "prompt": "-",
            "start_map": level.package,
            "packs": [PackRef(pack_id=pack.pack_id, digest=pack.sha256()).plain()],
            "catalog": [asset.path for asset in pack.assets],
            "budget": Budget(tool_calls=10_000, wall_minutes=60).plain(),
        }
    )
    packs = [packs_folder / PACK]
    with (
        open_engine(
            DEFAULT_ENGINE,
            packs=packs,
            content=root / "content",
            scratch=root / "scratch",
            start_map=level.package,
            levels=[folder / "start.level.json"],
        ) as engine,
        Gateway() as gateway,
    ):
        bench = Workbench(case, folder, CaseCatalog.load(case, packs), engine, root / "scratch")
        run = Run("bench", bench, case.budget, AttemptFolder(root).trajectory)
        with GatewayClient(gateway.open_run(run)) as client:
            yield client


def sizes(level: Level) -> list[tuple[int, str]]:
    """Size and tool of every answer, the largest first."""
    pack = ensure_pack(PACK, packs_root())
    with (
        tempfile.TemporaryDirectory(prefix="c4s-answers-") as folder,
        opened(Path(folder), level, packs_root()) as client,
    ):
        found = [(size_of(client.answer(name, arguments)), name) for name, arguments in calls(pack)]
    assert {name for _, name in found} == {tool.name for tool in ALL_TOOLS}
    return sorted(found, reverse=True)


def scenes() -> dict[str, Level]:
    """The largest shipped scene, and a town of its meshes."""
    pack = ensure_pack(PACK, packs_root())
    return {"harbour": harbour_scene.build().level, "town": town(pack, ACTORS)}


def rows() -> list[Row]:
    """The largest answer on each scene."""
    made = []
    for name, level in scenes().items():
        (largest, tool), *_ = sizes(level)
        goal, met = f"at most {ANSWER_SIZE:,}", largest <= ANSWER_SIZE
        what = f"the largest answer of a tool on the {name} of {len(level.actors)} actors ({tool})"
        made.append(Row(what, largest, goal, met, unit="characters"))
    return made


if __name__ == "__main__":
    for scene, level in scenes().items():
        print(f"{scene}, {len(level.actors)} actors")
        for size, tool in sizes(level)[:LARGEST]:
            print(f"{size:>12,}  {tool}")
