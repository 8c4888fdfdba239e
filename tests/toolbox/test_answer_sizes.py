"""No answer of a tool is longer than a client shows: on what ships, on 6,700 actors, and whatever somebody writes."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from made_case import path_of

from bench.answers import ACTORS, PACK, calls, opened, size_of
from bench.town import town
from c4s.records.level import Level
from c4s.records.pack import Pack
from c4s.toolbox.client import GatewayClient
from c4s.toolbox.gateway import SIZE
from c4s.toolbox.refusal import ToolRefused
from c4s.toolbox.registry import ALL_TOOLS, TOOLS
from c4s.toolbox.size import ANSWER_SIZE, ASKED_SIZE, ERROR_SIZE
from c4s.toolbox.tool import ToolResult
from cases.starter import harbour_scene
from tests.built import built_packs

OPEN = "import unreal\neditor = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)\n"
LONG = 30_000


@pytest.fixture(scope="module")
def packs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built_packs(tmp_path_factory, PACK)


@pytest.fixture(params=["harbour", "town"], scope="module")
def shipped(
    request: pytest.FixtureRequest, packs: Path, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[tuple[GatewayClient, Pack, Level]]:
    """A run on the largest shipped scene, and on a town of its meshes."""
    pack = Pack.read(packs / PACK / "pack.json")
    level = harbour_scene.build().level if request.param == "harbour" else town(pack, ACTORS)
    with opened(tmp_path_factory.mktemp(request.param), level, packs) as client:
        yield client, pack, level


def run(client: GatewayClient, script: str) -> Any:
    return client.answer("execute_python_script", {"script": script, "execution_mode": "sync"})


def test_every_tool_answers_within_the_bound_on_what_ships(shipped: tuple[GatewayClient, Pack, Level]) -> None:
    client, pack, level = shipped
    found = [(size_of(client.answer(name, arguments)), name) for name, arguments in calls(pack)]
    assert {name for _, name in found} == set(TOOLS)
    assert max(found)[0] <= ANSWER_SIZE, sorted(found)[-10:]
    first = client.call("get_actors_in_level").data
    assert first["count"] >= 60 and first["next"] == first["count"]
    assert max(first["most_frequent_meshes"].values()) >= 10
    asked = client.answer("get_actors_in_level", {"limit": 1000})
    assert ANSWER_SIZE < size_of(asked) <= ASKED_SIZE
    assert len(client.actors()) == first["total"] >= len(level.actors)


def test_the_sizes_are_declared_where_clients_read_them(open_run: Callable) -> None:
    told = {tool.name: (tool.meta or {}).get(SIZE) for tool in open_run().client.tools()}
    large = {"get_actors_in_level", "find_actors_by_name", "read_job_log"}
    assert told == {name: ASKED_SIZE if name in large else ANSWER_SIZE for name in TOOLS}


GIVEN: dict[str, Any] = {
    "lists": {"rows": [{"label": f"row {number}"} for number in range(100_000)], "count": 100_000},
    "one text": {"text": "x" * 3_000_000},
    "texts": {"rows": ["y" * 30_000] * 200},
    "control characters": {"text": "\x01" * 300_000, "rows": ["\x02" * 20_000] * 50},
    "no Latin letters": {"rows": ["\U0001f600" * 10_000] * 50},
    "half characters": {"text": "\ud800" * 100_000},
    "deep": {"a": {"b": {"c": [["z" * 9_000] * 30] * 30}}},
    "many keys": {f"key {number}": number for number in range(50_000)},
    "long keys": {"k" * 100_000: 1},
}


@pytest.mark.parametrize("given", GIVEN)
def test_the_gateway_holds_whatever_a_tool_gives(
    open_run: Callable, monkeypatch: pytest.MonkeyPatch, given: str
) -> None:
    run = open_run(calls=100)
    for tool in ALL_TOOLS:
        monkeypatch.setitem(TOOLS, tool.name, replace(tool, run=lambda *_: ToolResult(GIVEN[given])))
    asked: dict[str, Any] = {}
    for name, arguments in calls(Pack.read(run.pack / "pack.json")):
        asked.setdefault(name, arguments)
    for name, arguments in asked.items():
        answer = run.client.answer(name, arguments)
        assert not answer.is_error and size_of(answer) <= ANSWER_SIZE, name
        told = json.loads(answer.content[0].text)
        assert told["budget"]["tool_calls_left"] < 100 and told["result"]["cut"]["bytes"] > ANSWER_SIZE
    assert asked.keys() == TOOLS.keys()
    ended = [line for line in run.trajectory() if line["event"] == "call"]
    assert all(line["cut_from"] > line["result_characters"] for line in ended) and len(ended) == len(TOOLS)


@pytest.mark.parametrize("error", [ToolRefused, ValueError])
def test_the_gateway_holds_errors(open_run: Callable, monkeypatch: pytest.MonkeyPatch, error: type[Exception]) -> None:
    def fail(*_: object) -> ToolResult:
        raise error("\x01" * 1_000_000 + "the reason" * 200_000)

    run = open_run()
    monkeypatch.setitem(TOOLS, "get_categories", replace(TOOLS["get_categories"], run=fail))
    answer = run.client.answer("get_categories", {})
    assert answer.is_error and size_of(answer) <= ERROR_SIZE + 200 and "the reason" in answer.content[0].text


def test_hostile_scenes_and_scripts_have_answers_of_the_usual_size(open_run: Callable) -> None:
    opened = open_run(calls=200)
    client = opened.client
    name = f"chr(34) * {LONG}"
    makes = (
        OPEN + f"for i in range(40):\n a = editor.spawn_actor_from_class(unreal.StaticMeshActor, unreal.Vector())\n"
        f" a.set_actor_label({name} + str(i))\n a.tags = [{name}] * 5\n a.set_folder_path({name})\n"
        f" a.static_mesh_component.set_static_mesh(unreal.load_asset({path_of('SM_crate')!r}))"
    )
    scripts = [
        makes,
        "raise ValueError('x' * 3_000_000)",
        "raise ValueError('\\x01' * 300_000)",
        "print('y' * 3_000_000)",
        "import sys\nsys.stderr.write('\\x07' * 1_000_000)",
        "def f(n): return f(n + 1)\nf(0)",
        "errors = [SyntaxError(f'compile error {i}') for i in range(10_000)]\nraise ExceptionGroup('all', errors)",
        "\n".join(["x = ("] * 10_000),
        f"v{'w' * 100_000} = nowhere.{'z' * 100_000}",
    ]
    for script in scripts:
        answer = run(client, script)
        assert size_of(answer) <= ANSWER_SIZE, script[:60]
        assert size_of(client.answer("read_job_log", {})) <= ANSWER_SIZE
    label = '"' * LONG
    for tool, arguments in [
        ("get_actors_in_level", {}),
        ("find_actors_by_name", {"pattern": "*"}),
        ("delete_actor", {"name": label}),
        ("delete_actor", {"name": "x" * 1_000_000}),
        ("set_actor_transform", {"name": f"{label}0", "location": [0, 0, 0]}),
        ("check_floating", {}),
        ("check_floating", {"actor_names": [f"{label}1", f"{label}2"]}),
        ("check_collisions", {}),
        ("measure_scene", {}),
        ("search_assets", {"query": "z" * 500, "category": "c" * 100_000}),
        ("get_asset_metadata", {"ids": [f"{number}" * 5_000 for number in range(100)]}),
        ("spawn_actor", {"name": "n", "static_mesh": "/Game/" + "m" * 1_000_000, "location": [0, 0, 0]}),
        ("spawn_actor", {"name": "n", "static_mesh": 7, "location": ["o" * 1_000_000]}),
        ("spawn_actor", {"k" * 1_000_000: 1}),
        ("build_tier", {"entries": [{"name": "e" * 200, "asset": "a" * 5_000, "location": [0, 0, 0]}] * 100}),
        ("build_tier", {"tier": "t" * 100_000}),
        ("render_plan", {"solved": {"entries": [{"name": "e" * 100_000}]}}),
        ("validate_scene_graph", {"graph": {"nodes": [{"id": "n" * 50_000, "asset": "a" * 50_000}] * 5}}),
        ("read_job_log", {"job_id": "j" * 1_000_000}),
        ("take_screenshot", {"filename": "f" * 1_000_000}),
        ("save_scene_as", {"name": "s" * 1_000_000}),
        ("t" * 1_000_000, {}),
        ("delete_all_spawned", {}),
    ]:
        assert size_of(client.answer(tool, arguments)) <= ANSWER_SIZE, tool
    assert opened.run.end_reason is None


def test_an_output_can_be_read_on_from_anywhere(open_run: Callable) -> None:
    client = open_run().client
    run(client, "for number in range(30_000): print('line', number)")
    wanted = "".join(f"line {number}\n" for number in range(30_000))
    last = client.call("read_job_log").data
    assert last["truncated"] and last["output_bytes"] == len(wanted) and wanted.endswith(last["output"] + "\n")
    assert last["next"] is None and wanted[last["begins"] :].startswith(last["output"])
    assert whole_output(client) == wanted


def whole_output(client: GatewayClient) -> str:
    """The output of the last job, read from its first byte on."""
    read, offset = b"", 0
    while offset is not None:
        part = client.answer("read_job_log", {"offset": offset, "max_bytes": 150_000})
        assert size_of(part) <= ASKED_SIZE
        told = json.loads(part.content[0].text)["result"]
        assert told["begins"] == offset == len(read)
        offset = told["next"]
        read += told["output"].encode() + b"\n" * (offset is None or offset > len(read) + len(told["output"].encode()))
    return read.decode()


def test_an_output_that_is_longer_in_json_is_read_on_without_a_gap(open_run: Callable) -> None:
    client = open_run().client
    run(client, "for number in range(3_000): print('\\x01' * 40, number)")
    assert whole_output(client) == "".join(f"{chr(1) * 40} {number}\n" for number in range(3_000))
