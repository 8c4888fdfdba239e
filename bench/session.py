"""A session of tool calls on a level of 6,700 actors, through the gateway as an agent's client makes them.

``python -m bench.session [--actors N]`` prints one JSON object. The mix is what builders do most: spawn, move, delete,
find, short scripts, job logs. Listing, saving and the geometric checks are timed one by one, and the checks once more
on the same level. A second part saves the level, opens it in a clean process, and compares the two snapshots.
"""

from __future__ import annotations

import argparse
import json
import random
import statistics
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from bench.row import Row
from c4s.engine.headless.host.session import EngineSession
from c4s.files import write_json
from c4s.protocol.settings import OUTDOOR_REPAIR
from c4s.records.folder import AttemptFolder
from c4s.records.level import Level, LevelActor, LevelComponent, Transform
from c4s.records.suite import AgentCase, Budget
from c4s.toolbox.catalog import CaseCatalog
from c4s.toolbox.client import GatewayClient
from c4s.toolbox.gateway import Gateway
from c4s.toolbox.gateway_run import Run
from c4s.toolbox.workbench import Workbench

ACTORS = 6700
MEDIAN_S = 0.050
REOPEN_S = 2.0
PACKAGE = "/Game/Bench/City"
SAVED = "/Game/SavedScenes/bench"
_SHAPES = ("Cube", "Sphere", "Cylinder", "Cone")
_ROUNDS = 15
_CHECKS = ("check_floating", "check_collisions", "measure_scene")
_SLOW = (("get_actors_in_level", {}), ("save_scene_as", {"name": "bench"}), *((name, {}) for name in _CHECKS))
WARM_S = 1.0
"""A check of a level that has not changed since the last one."""


def city(actors: int, *, seed: int = 5) -> Level:
    """Shapes that stand on a plane, each turned its own way."""
    rng = random.Random(seed)

    def actor(number: int, shape: str, place: Transform) -> LevelActor:
        return LevelActor(
            name=f"StaticMeshActor_{number}",
            label=f"{shape}{number}",
            guid=f"{number:032X}",
            class_path="/Script/Engine.StaticMeshActor",
            transform=place,
            components=[
                LevelComponent(
                    name="StaticMeshComponent0",
                    class_path="/Script/Engine.StaticMeshComponent",
                    static_mesh=f"/Engine/BasicShapes/{shape}.{shape}",
                )
            ],
        )

    side = int(actors**0.5) + 1
    ground = actor(0, "Plane", Transform(scale=(side * 4.0, side * 4.0, 1.0)))
    return Level(
        package=PACKAGE,
        actors=[
            ground,
            *(
                actor(
                    n,
                    _SHAPES[n % len(_SHAPES)],
                    Transform(
                        location_cm=(200.0 * (n % side - side / 2), 200.0 * (n // side - side / 2), 50.0),
                        rotation_deg=(0.0, rng.uniform(-180, 180), 0.0),
                    ),
                )
                for n in range(1, actors)
            ),
        ],
    )


def mix(number: int) -> Iterator[tuple[str, dict[str, Any]]]:
    """The calls of one round of the mix."""
    yield (
        "spawn_actor",
        {"name": f"New{number}", "static_mesh": "/Engine/BasicShapes/Cube.Cube", "location": [0, 0, 500 + number]},
    )
    yield "set_actor_transform", {"name": f"New{number}", "location": [10, 0, 500], "rotation": [0, 45, 0]}
    yield "find_actors_by_name", {"pattern": f"Cube{40 * number}"}
    yield "set_actor_transform", {"name": "Sphere1001", "rotation": [0, number, 0]}
    yield (
        "execute_python_script",
        {
            "execution_mode": "sync",
            "script": "import unreal\nactors = unreal.get_editor_"
            "subsystem(unreal.EditorActorSubsystem)\nprint(len(actors.get_all_level_actors()))",
        },
    )
    yield "read_job_log", {}
    yield "delete_actor", {"name": f"New{number}"}


def session(root: Path, actors: int) -> dict[str, Any]:
    """Latencies (seconds) of the mix and of the slow tools, as the client sees them."""
    agent_folder = root / "agent" / "bench"
    city(actors).write(agent_folder / "start.level.json")
    case = AgentCase.parse(
        {
            "alias": "bench",
            "setting": OUTDOOR_REPAIR,
            "prompt": "-",
            "start_map": PACKAGE,
            "packs": [],
            "catalog": [],
            "budget": Budget(tool_calls=10_000, wall_minutes=60).plain(),
        }
    )
    write_json(agent_folder / "case.json", case.plain())
    took: dict[str, list[float]] = {}
    with (
        EngineSession.start(
            packs=[],
            content=root / "content",
            scratch=root / "scratch",
            start_map=PACKAGE,
            levels=[agent_folder / "start.level.json"],
        ) as engine,
        Gateway() as gateway,
    ):
        bench = Workbench(case, agent_folder, CaseCatalog.load(case, []), engine, root / "scratch")
        endpoint = gateway.open_run(Run("bench", bench, case.budget, AttemptFolder(root).trajectory))
        with GatewayClient(endpoint) as client:
            for number in range(_ROUNDS):
                for name, arguments in mix(number):
                    took.setdefault(name, []).append(_timed(client, name, arguments))
            every = sorted(seconds for all_of_one in took.values() for seconds in all_of_one)
            slow = {name: round(_timed(client, name, arguments), 3) for name, arguments in _SLOW}
            warm = {name: round(_timed(client, name, {}), 3) for name in _CHECKS}
    return {
        "calls": len(every),
        "median_s": round(statistics.median(every), 4),
        "p95_s": round(every[int(0.95 * len(every))], 4),
        "median_by_tool_s": {name: round(statistics.median(all_of_one), 4) for name, all_of_one in took.items()},
        "slow_s": slow,
        "unchanged_s": warm,
    }


def _timed(client: GatewayClient, name: str, arguments: dict[str, Any]) -> float:
    started = time.perf_counter()
    client.call(name, **arguments)
    return time.perf_counter() - started


def reopened(root: Path, actors: int) -> dict[str, Any]:
    """Seconds to save a level under a new name and to open that in a clean process; whether the snapshots are equal."""
    given = root / "given.level.json"
    city(actors).write(given)
    with EngineSession.start(
        packs=[], content=root / "content", scratch=root / "first", levels=[given], start_map=PACKAGE
    ) as engine:
        started = time.perf_counter()
        engine.call("scene_tools.save_scene", package=SAVED)
        saved_s = time.perf_counter() - started
        first = engine.call("snapshot.export_snapshot")
    started = time.perf_counter()
    with EngineSession.start(packs=[], content=root / "content", scratch=root / "second", start_map=SAVED) as engine:
        opened_s = time.perf_counter() - started
        second = engine.call("snapshot.export_snapshot")
    return {
        "saved_s": round(saved_s, 3),
        "opened_s": round(opened_s, 3),
        "equal": first == second,
        "actors": second["actor_count"],
    }


def run(actors: int = ACTORS) -> dict[str, Any]:
    """Both parts."""
    with tempfile.TemporaryDirectory(prefix="c4s-session-") as folder:
        return {
            "actors": actors,
            **session(Path(folder) / "session", actors),
            "save_and_reopen": reopened(Path(folder) / "reopen", actors),
        }


def rows() -> list[Row]:
    """The median call, the checks of a level that did not change, and a level saved and opened in a clean process."""
    found = run()
    level = found["save_and_reopen"]
    seconds = round(level["saved_s"] + level["opened_s"], 3)
    return [
        Row(
            f"a tool call on {found['actors']} actors, median of {found['calls']} (95 %: {found['p95_s']} s)",
            found["median_s"],
            f"under {MEDIAN_S:g} s",
            found["median_s"] < MEDIAN_S,
        ),
        Row(
            f"the slowest check of {found['actors']} actors that have not changed since the last check",
            max(found["unchanged_s"].values()),
            f"under {WARM_S:g} s",
            max(found["unchanged_s"].values()) < WARM_S,
        ),
        Row(
            f"{level['actors']} actors saved, and open in a clean process"
            f" ({'equal' if level['equal'] else 'UNEQUAL'} snapshot)",
            seconds,
            f"under {REOPEN_S:g} s, equal",
            seconds < REOPEN_S and level["equal"],
        ),
    ]


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--actors", type=int, default=ACTORS)
    print(json.dumps(run(parser.parse_args().actors), indent=1))
