"""A snapshot is taken again exactly when a job, a tick function or a thread may have changed the level."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from c4s.engine.headless.host.session import EngineSession
from c4s.records.suite import AgentCase
from c4s.toolbox.catalog import CaseCatalog
from c4s.toolbox.workbench import Workbench


@pytest.fixture(scope="module")
def engine(tmp_path_factory: pytest.TempPathFactory) -> Iterator[EngineSession]:
    root = tmp_path_factory.mktemp("revision")
    with EngineSession.start(packs=[], content=root / "content", scratch=root / "scratch") as session:
        yield session


def taken(engine: EngineSession, known: int | None = None) -> tuple[int | None, bool]:
    """The level's state, and whether a snapshot came with it."""
    told: dict[str, Any] = engine.call("snapshot.export_if_changed", known=known)
    return told["revision"], told["snapshot"] is not None


def settled(engine: EngineSession) -> None:
    """A thread that was joined may take a moment more to be gone."""
    assert any(taken(engine)[0] is not None for _ in range(1000))


def run(engine: EngineSession, script: str) -> None:
    reply = engine.execute(f"import unreal, threading\n{script}")
    assert reply["status"] == "ok", reply


SPAWN = "unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.PointLight, unreal.Vector())"


def test_reading_leaves_the_state_and_everything_else_makes_a_new_one(engine: EngineSession) -> None:
    state, fresh = taken(engine)
    assert state is not None and fresh and taken(engine, state) == (state, False)
    engine.call("scene_tools.list_actors")
    engine.call("scene_tools.find_actors", pattern="*")
    engine.request("take_screenshot", {"width": 64, "height": 48})
    assert taken(engine, state) == (state, False)
    states = [state]
    for script in (SPAWN, "print('nothing')", "unreal.load_asset('/Nowhere')", "def broken(): pass"):
        run(engine, script)
        state, fresh = taken(engine, states[-1])
        assert fresh and state not in states
        assert state is not None
        states.append(state)
    engine.call("scene_tools.save_scene", package="/Game/SavedScenes/revision")
    assert taken(engine, states[-1])[1], "actors have other paths now"
    assert engine.execute(f"{SPAWN}\n1 / 0")["status"] == "error"
    assert taken(engine, states[-1])[1]


def test_tick_functions_and_threads_leave_no_state(engine: EngineSession) -> None:
    run(engine, "handle = unreal.register_slate_post_tick_callback(lambda seconds: None)")
    assert taken(engine) == (None, True) == taken(engine, None)
    run(engine, "unreal.unregister_slate_post_tick_callback(handle)")
    settled(engine)
    run(engine, "go = threading.Event(); thread = threading.Thread(target=go.wait, daemon=True); thread.start()")
    assert taken(engine) == (None, True)
    run(engine, "go.set(); thread.join()")
    settled(engine)
    run(
        engine,
        "import _thread; begun, lock, done = (_thread.allocate_lock() for _ in range(3))\n"
        "begun.acquire(); lock.acquire(); done.acquire()\n"
        "def wait():\n    begun.release(); lock.acquire(); done.release()\n"
        "_thread.start_new_thread(wait, ()); begun.acquire()",
    )
    assert taken(engine) == (None, True), "a thread that the module threading does not know"
    run(engine, "lock.release(); done.acquire()")
    settled(engine)


def test_the_workbench_measures_again_only_then(engine: EngineSession, tmp_path: Path) -> None:
    case = AgentCase.parse(
        {
            "alias": "bench",
            "setting": "text-to-scene",
            "prompt": "-",
            "start_map": "/Temp/None",
            "packs": [],
            "catalog": [],
            "budget": {"tool_calls": 9, "wall_minutes": 1.0},
        }
    )
    bench = Workbench(case, tmp_path, CaseCatalog.load(case, []), engine, tmp_path)
    first = bench.measured()
    assert bench.measured() is first
    run(engine, "for a in unreal.EditorLevelLibrary.get_all_level_actors(): a.set_actor_label('Renamed')")
    second = bench.measured()
    assert second is not first and {actor["label"] for actor in second.actors} == {"Renamed"}
    assert second.snapshot == engine.call("snapshot.export_snapshot")
