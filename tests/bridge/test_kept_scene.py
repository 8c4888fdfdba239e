"""What is drawn of a level is built once while jobs only read it, and is gone once anything may have changed it."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from c4s.engine.headless.host.session import EngineSession

CAMERA = {"location_cm": [-600, 0, 0], "rotation_deg": [0, 0, 0], "fov_deg": 60, "width": 64, "height": 48}
PLACE = """
mesh = unreal.load_asset("/Engine/BasicShapes/Cube")
actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
cube = actors.spawn_actor_from_object(mesh, unreal.Vector())
"""
AWAY = "cube.set_actor_location(unreal.Vector(-5000, 0, 0), False, False)"


@pytest.fixture
def engine(tmp_path: Path) -> Iterator[EngineSession]:
    with EngineSession.start(packs=[], content=tmp_path / "content", scratch=tmp_path / "scratch") as session:
        yield session


def run(engine: EngineSession, script: str) -> str:
    reply = engine.execute(f"import unreal, threading\n{script}")
    assert reply["status"] == "ok", reply
    return "\n".join(reply["result"]["python_logs"])


def seen(engine: EngineSession) -> int:
    """How many actors a camera sees."""
    told: list[dict[str, Any]] = engine.call("capture.probe_views", cameras=[CAMERA])
    return len(told[0]["visible"])


def test_every_script_is_seen(engine: EngineSession) -> None:
    assert seen(engine) == seen(engine) == 0
    run(engine, PLACE)
    assert seen(engine) == seen(engine) == 1
    run(engine, AWAY)
    assert seen(engine) == 0


def test_what_runs_between_jobs_is_seen(engine: EngineSession) -> None:
    run(engine, PLACE)
    assert seen(engine) == 1
    run(engine, f"handle = unreal.register_slate_post_tick_callback(lambda seconds: {AWAY})")
    assert any(seen(engine) == 0 for _ in range(1000))
    run(engine, "unreal.unregister_slate_post_tick_callback(handle); cube.set_actor_location(unreal.Vector(), 0, 0)")
    assert seen(engine) == 1
    run(engine, f"go = threading.Event(); threading.Thread(target=lambda: (go.wait(), {AWAY}), daemon=True).start()")
    assert seen(engine) == 1
    run(engine, "go.set()")
    assert any(seen(engine) == 0 for _ in range(1000))


def test_a_script_that_looks_twice_sees_its_own_change(engine: EngineSession) -> None:
    look = f"print(len(capture.probe_views(cameras=[{CAMERA}])[0]['visible']))"
    assert run(engine, f"from c4s.editor import capture\n{PLACE}{look}\n{AWAY}\n{look}").split() == ["1", "0"]


def test_readers_build_what_is_drawn_once(tmp_path: Path) -> None:
    code = f"""
from pathlib import Path
from c4s.engine.headless.process.boot import boot
boot([], Path({str(tmp_path)!r}))
from c4s.engine.headless.process import revision
from c4s.engine.headless.process.offers import HOST
from tests.work import calls_in

def looks():
    for _ in range(3):
        revision.begin({{"function": "capture.probe_views"}})
        HOST.pictures.probe([{CAMERA}])

print(calls_in(looks)["open_level"])
revision.begin({{"function": "scene_tools.save_scene"}})
print(calls_in(looks)["open_level"], calls_in(looks)["open_level"])
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["1", "1", "0"]
