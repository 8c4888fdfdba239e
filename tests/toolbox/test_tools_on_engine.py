"""The tools against a real engine, through a real gateway and a real MCP client."""

from __future__ import annotations

import io
import json
from collections.abc import Callable

import pytest
from made_case import START, path_of
from PIL import Image

from c4s.toolbox.client import CallRefused
from tests.shared import SHARED

PAGING = {
    "get_actors_in_level": {"offset", "limit"},
    "find_actors_by_name": {"offset", "limit"},
    "search_assets": {"offset"},
    "read_job_log": {"offset", "action"},
}
"""Optional arguments beside those of the reference: for long lists, and for the jobs."""
REFERENCE = SHARED / "reference/tools.yaml"


def test_the_tools_are_those_of_the_reference(open_run: Callable) -> None:
    if not REFERENCE.is_file():
        pytest.skip("the reference table of tools is not on this machine")
    import yaml

    listed = {tool.name: tool.input_schema for tool in open_run().client.tools()}
    wanted = {
        tool["name"]: tool for group in yaml.safe_load(REFERENCE.read_text())["groups"] for tool in group["tools"]
    }
    assert listed.keys() == wanted.keys() and len(listed) == 25
    for name, schema in listed.items():
        assert schema.get("required", []) == wanted[name]["required"], name
        assert set(schema["properties"]) - PAGING.get(name, set()) == {
            *wanted[name]["required"],
            *wanted[name]["optional"],
        }, name
        assert schema["additionalProperties"] is False
        assert all(_described(argument) for argument in schema["properties"].values()), name


def _described(argument: dict) -> bool:
    return bool(argument.get("description")) and ("type" in argument or "enum" in argument or "anyOf" in argument)


def test_long_lists_come_in_parts(open_run: Callable) -> None:
    client = open_run().client
    first = client.call("get_actors_in_level", limit=4).data
    assert (first["count"], first["total"], first["next"]) == (4, 6, 4)
    rest = client.call("get_actors_in_level", offset=first["next"], limit=4).data
    assert (rest["count"], rest["next"]) == (2, None)
    every = client.call("get_actors_in_level").data
    assert first["actors"] + rest["actors"] == every["actors"] == client.actors() and every["next"] is None
    twins = client.call("find_actors_by_name", pattern="twin", offset=1, limit=1).data
    assert (twins["actors"][0]["name"], twins["total"], twins["next"]) == ("StaticMeshActor_6", 2, None)
    with pytest.raises(CallRefused, match="past the end"):
        client.call("get_actors_in_level", offset=6)
    found = client.call("search_assets", query="wood", k=2).data
    more = client.call("search_assets", query="wood", k=2, offset=found["next"]).data
    assert found["total"] == more["total"] >= 4
    assert not {row["id"] for row in found["assets"]} & {row["id"] for row in more["assets"]}


def test_three_hundred_nodes_are_planned_and_built(open_run: Callable) -> None:
    client = open_run(setting="text-to-scene").client
    nodes = [
        {
            "id": f"n{i}",
            "asset": ("crate", "sofa", "oak_table", "stacked_table")[i % 4],
            "at": [(i % 18) * 0.9 - 8, (i // 18) * 0.9 - 8],
        }
        for i in range(300)
    ]
    nodes += [
        {"id": "ghost", "asset": "no_such_thing"},
        {"id": "hat", "asset": "crate", "on": "ghost"},
        {"id": "many", "asset": "crate", "at": [0, 0], "count": 60, "layout": {"kind": "scatter"}},
    ]
    report = client.call("validate_scene_graph", graph={"nodes": nodes}).data
    assert not report["valid"] and {"ghost", "hat"} <= set(report["dropped"])
    assert all(problem["problem"] for problem in report["problems"])
    told = client.call("solve_scene_graph", graph={"nodes": nodes}).data
    assert told["total"] == 360 and 40 < told["shown"] == len(told["solved"]["entries"]) < 360 and told["hint"]
    assert sum(told["solved"]["tier_counts"].values()) == 360
    built = 0
    for tier in told["solved"]["tier_counts"]:
        answer = client.call("build_tier", tier=tier).data
        assert answer["failed"] == []
        built += answer["count"]
    assert built == 360 == client.call("get_actors_in_level", limit=1).data["total"]
    assert client.call("delete_all_spawned").data["count"] == 360


def test_an_entry_that_no_catalog_has_does_not_stop_the_rest(open_run: Callable) -> None:
    client = open_run(setting="text-to-scene").client
    answer = client.call(
        "build_tier",
        entries=[
            {"name": "A", "asset": "crate", "location": [0, 0, 0], "scale": 2},
            {"name": "B", "asset": "unicorn", "location": [0, 0, 0]},
        ],
    ).data
    assert answer["spawned"] == ["A"] and "search_assets" in answer["failed"][0]["error"]
    with pytest.raises(CallRefused, match=r"spawn_actor takes name\*, static_mesh\*, location\*, rotation, scale"):
        client.call("spawn_actor", name="C")


def test_assets_are_found_by_words_and_described(open_run: Callable) -> None:
    client = open_run().client
    assert client.call("search_assets", query="couch").data["assets"][0]["id"] == "sofa"
    assert client.call("search_assets", query="wooden boxes", k=1).data["assets"][0]["id"] == "crate"
    assert client.call("search_assets", query="tables", category="storage").data["count"] == 0
    assert {"category": "Tables", "count": 2, "description": "To eat and work at"} in client.call(
        "get_categories"
    ).data["categories"]
    told = client.call("get_asset_metadata", ids=["oak_table", "nothing"]).data
    assert told["assets"][0]["size_m"] == [1.6, 0.8, 0.75] and told["missing"][0]["id"] == "nothing"
    assert told["assets"][0]["spawn_path"] == path_of("SM_oak_table")
    assert Image.open(io.BytesIO(client.call("get_asset_preview", id="crate").images[0])).size == (32, 32)
    with pytest.raises(CallRefused, match="no preview"):
        client.call("get_asset_preview", id="sofa")


def test_actors_are_placed_moved_and_deleted(open_run: Callable) -> None:
    client = open_run().client
    made = client.call(
        "spawn_actor", name="New", static_mesh="crate", location=[100, 50, 0], rotation=[10, 20, 30], scale=2
    ).data["actor"]
    assert made["label"] == "New" and made["name"] and made["static_meshes"] == [path_of("SM_crate")]
    assert made["rotation"] == pytest.approx([10, 20, 30]) and made["scale"] == [2, 2, 2]
    with pytest.raises(CallRefused, match="already there"):
        client.call("spawn_actor", name="New", static_mesh="crate", location=[0, 0, 0])
    built = client.call(
        "spawn_blueprint_actor", actor_name="Stack", blueprint_id="stacked_table", location=[300, 0, 0]
    ).data["actor"]
    assert len(built["static_meshes"]) == 2
    moved = client.call("set_actor_transform", name="New", location=[1, 2, 3]).data["actor"]
    assert moved["location"] == [1, 2, 3] and moved["rotation"] == pytest.approx([10, 20, 30])
    assert client.call("delete_actor", name=made["name"]).data["deleted"]["label"] == "New"
    with pytest.raises(CallRefused, match="no actor"):
        client.call("delete_actor", name="New")
    with pytest.raises(CallRefused, match="not a static mesh"):
        client.call("spawn_actor", name="Ghost", static_mesh="/Game/Test/SM_ghost", location=[0, 0, 0])


def test_an_ambiguous_label_is_refused_and_the_object_name_works(open_run: Callable) -> None:
    client = open_run().client
    with pytest.raises(CallRefused, match=r"2 actors have the label 'Twin'.*StaticMeshActor_5"):
        client.call("delete_actor", name="Twin")
    assert client.call("delete_actor", name="StaticMeshActor_5").data["deleted"]["label"] == "Twin"
    found = client.call("find_actors_by_name", pattern="tWin").data["actors"]
    assert [(actor["name"], actor["matched"]) for actor in found] == [("StaticMeshActor_6", ["label"])]


def test_a_name_is_found_in_whatever_case_where_one_fits(open_run: Callable) -> None:
    client = open_run().client
    assert client.call("set_actor_transform", name="sofa", location=[1, 2, 3]).data["actor"]["label"] == "Sofa"
    assert client.call("check_floating", actor_names=["SOFA"]).data["checked"] == 1
    with pytest.raises(CallRefused, match="2 actors have the label 'twin'"):
        client.call("delete_actor", name="twin")
    with pytest.raises(CallRefused, match=r"no actor has the label or name 'Tabel': near are Table"):
        client.call("delete_actor", name="Tabel")
    client.call("spawn_actor", name="sofa", static_mesh="crate", location=[0, 0, 500])
    assert client.call("delete_actor", name="sofa").data["deleted"]["static_meshes"] == [path_of("SM_crate")]


def test_a_scale_of_nothing_is_refused_by_every_tool(open_run: Callable) -> None:
    client = open_run().client
    place = {"name": "Flat", "static_mesh": "crate", "location": [0, 0, 0]}
    for scale in (0, [1, 0, 1]):
        with pytest.raises(CallRefused, match="scale must not be 0"):
            client.call("spawn_actor", scale=scale, **place)
        with pytest.raises(CallRefused, match="scale must not be 0"):
            client.call("set_actor_transform", name="Sofa", scale=scale)
        with pytest.raises(CallRefused, match="scale must not be 0"):
            client.call(
                "build_tier", entries=[{"name": "Flat", "asset": "crate", "location": [0, 0, 0], "scale": scale}]
            )
    assert client.call("get_actors_in_level").data["total"] == 6
    assert client.call("spawn_actor", scale=[1, -1, 1], **place).data["actor"]["scale"] == [1, -1, 1]


WRONG = [
    ("setup_environment", {"time_of_day": "dusk"}, "'dusk' is not allowed: it must be `morning` / `noon`"),
    ("search_assets", {"query": "a", "k": 0}, r"0 is not allowed: it must be integer \(1 to 100\) - How many results"),
    ("search_assets", {"query": "a", "limit": 5}, "there is no 'limit'"),
    ("spawn_actor", {"name": "a", "static_mesh": "b", "locaton": [0, 0, 0]}, "did you mean 'location'|'location' is a"),
    ("delete_actor", {"name": "Sofa", "nam": "Sofa"}, "there is no 'nam': did you mean 'name'"),
    (
        "set_actor_transform",
        {"name": "Sofa", "scale": "big"},
        r"'big' is not allowed: it must be number .* or list of 3",
    ),
    ("set_actor_transform", {"name": "Sofa", "location": [0, 0]}, r"must be list of 3 numbers.*World location"),
    ("save_scene_as", {"name": "a b"}, "'a b' is not allowed: it must be string.*Letters, digits"),
    ("read_job_log", {"action": "stop"}, "must be `read` / `list` / `cancel`"),
    ("execute_python_script", {"script": 5}, "5 is not allowed: it must be string - Python source"),
]


@pytest.mark.parametrize(("tool", "arguments", "said"), WRONG)
def test_wrong_arguments_are_told_what_is_allowed(open_run: Callable, tool: str, arguments: dict, said: str) -> None:
    with pytest.raises(CallRefused, match=said):
        open_run().client.call(tool, **arguments)


def test_delete_all_spawned_spares_the_start_level(open_run: Callable) -> None:
    client = open_run().client
    before = {actor["name"] for actor in client.call("get_actors_in_level").data["actors"]}
    client.call("spawn_actor", name="One", static_mesh="crate", location=[0, 0, 0])
    script = (
        "import unreal\na = unreal.get_editor_subsystem(unreal.EditorActorSubsystem).spawn_actor_from_class("
        "unreal.StaticMeshActor, unreal.Vector(0, 0, 0))\na.set_actor_label('Two')\nprint('made', 2)"
    )
    assert "made 2" in client.call("execute_python_script", script=script, execution_mode="sync").data["output"]
    assert sorted(client.call("delete_all_spawned").data["deleted"]) == ["One", "Two"]
    assert {actor["name"] for actor in client.call("get_actors_in_level").data["actors"]} == before


def test_scripts_are_jobs_with_a_log(open_run: Callable) -> None:
    client = open_run().client
    job = client.call("execute_python_script", script="kept = 41\nprint('hello')\nraise ValueError('wrong')").data
    assert job["status"] == "started"
    state = client.call("read_job_log", log_path=job["log_path"], wait_s=30).data
    assert state["status"] == "error" and "ValueError: wrong" in state["error"] and "hello" in state["output"]
    client.call("execute_python_script", script="print(kept + 1)")
    assert client.call("read_job_log", wait_s=30).data["output"].strip() == "42"
    client.call("execute_python_script", script="print('x' * 5000)")
    cut = client.call("read_job_log", wait_s=30, max_bytes=10).data
    assert cut["truncated"] and len(cut["output"]) <= 10
    with pytest.raises(CallRefused, match="no job"):
        client.call("read_job_log", job_id="job-9999")


def test_the_checks_use_the_collision_bodies(open_run: Callable) -> None:
    client = open_run().client
    floating = client.call("check_floating").data
    assert (floating["floating"], floating["stood_so_at_start"]["floating"]) == ([], 1)
    assert [(row["label"], row["gap_cm"]) for row in floating["stood_so_at_start"]["examples"]] == [("Sofa", 40.0)]
    client.call("set_actor_transform", name="Sofa", location=[50, 120, 41])
    floating = client.call("check_floating").data
    assert [(item["label"], item["gap_cm"]) for item in floating["floating"]] == [("Sofa", 41.0)]
    assert floating["stood_so_at_start"] == {"floating": 0}
    assert client.call("check_floating", threshold_cm=50).data["count"] == 0
    assert client.call("check_collisions").data["pairs"] == []
    client.call("set_actor_transform", name="Box", location=[0, 0, 55])
    pairs = client.call("check_collisions", actor_names=["Box"]).data["pairs"]
    assert [(pair["a"]["label"], pair["b"]["label"]) for pair in pairs] == [("Table", "Box")]
    assert pairs[0]["depth_cm"] == pytest.approx(20, abs=0.1)
    measured = client.call("measure_scene").data
    assert measured["actors"] == 6 and measured["collision_rate"] > 0
    assert {"label": "Sofa", "name": "StaticMeshActor_4"} in measured["floating"]
    assert measured["extent"]["size_m"][0] >= 4 and measured["changed_or_added"] == 2
    (box,) = measured["colliding"]
    assert (box["label"], box["contacts"][0]["label"]) == ("Box", "Table")
    client.call("delete_actor", name="Table")
    fallen = client.call("measure_scene").data["floating"]
    assert {row["label"] for row in fallen} == {"Sofa", "Box"}


def test_what_an_agent_takes_away_unsettles_what_stood_on_it(open_run: Callable) -> None:
    client = open_run().client
    assert client.call("measure_scene").data["floating"] == []
    client.call("delete_actor", name="Table")
    (box,) = client.call("measure_scene").data["floating"]
    assert box["label"] == "Box" and "what held it" in box["why"]
    told = client.call("check_floating").data
    assert [row["label"] for row in told["floating"]] == ["Box"] and told["stood_so_at_start"]["floating"] == 1


def test_the_planner_builds_in_tiers(open_run: Callable) -> None:
    client = open_run(setting="text-to-scene").client
    graph = {
        "nodes": [{"id": "desk", "asset": "oak_table", "at": [0, 0]}, {"id": "box", "asset": "crate", "on": "desk"}]
    }
    report = client.call("validate_scene_graph", graph=graph).data
    solved = client.call("solve_scene_graph", graph=graph).data["solved"]
    assert solved["entries"], report
    assert client.call("render_plan").images[0].startswith(b"\x89PNG")
    tiers = client.call("tier_derivation").data
    built = [
        label
        for tier in tiers["order"]
        if tiers["tiers"][tier]
        for label in client.call("build_tier", tier=tier).data["spawned"]
    ]
    assert sorted(built) == sorted(entry["name"] for entry in solved["entries"])
    assert client.call("ground_pass", scene_text="a concrete floor", half_extent_m=8).data["count"] == 16
    one = client.call(
        "build_tier",
        entries=[
            {"name": "Extra", "asset": "sofa", "location": [0, 400, 0]},
            {"name": "Extra", "asset": "sofa", "location": [0, 600, 0]},
        ],
    ).data
    assert one["spawned"] == ["Extra"] and "already there" in one["failed"][0]["error"]


def test_the_environment_adds_only_what_is_missing(open_run: Callable) -> None:
    client = open_run(setting="text-to-scene").client
    first = client.call("setup_environment", time_of_day="noon").data
    assert len(first["added"]) == 5 and first["already_there"] == []
    assert client.call("setup_environment").data["added"] == []
    sun = client.call("find_actors_by_name", pattern="Arena_Env_Sun").data["actors"][0]
    assert sun["rotation"] == pytest.approx([-75, -30, 0])
    later = client.call("setup_environment", time_of_day="sunset").data
    assert later["turned"] == ["Arena_Env_Sun"] and later["added"] == []
    assert client.call("setup_environment").data["turned"] == []
    sun = client.call("find_actors_by_name", pattern="Arena_Env_Sun").data["actors"][0]
    assert sun["rotation"] == pytest.approx([-10, 60, 0])


def test_a_time_of_day_for_a_sun_of_somebody_else_is_refused(open_run: Callable) -> None:
    client = open_run(setting="text-to-scene").client
    script = (
        "import unreal\nsun = unreal.get_editor_subsystem(unreal.EditorActorSubsystem).spawn_actor_from_class("
        "unreal.DirectionalLight, unreal.Vector())\nsun.set_actor_label('My sun')"
    )
    client.call("execute_python_script", script=script, execution_mode="sync")
    with pytest.raises(CallRefused, match=r"the sun 'My sun' is not this tool's.*rotation \[-75, -30, 0\]"):
        client.call("setup_environment", time_of_day="noon")
    assert client.call("get_actors_in_level").data["total"] == 1
    assert len(client.call("setup_environment").data["added"]) == 4


def test_tiles_are_a_ground(open_run: Callable) -> None:
    client = open_run(setting="text-to-scene").client
    client.call("ground_pass", scene_text="a concrete floor", half_extent_m=10)
    assert "Arena_Env_Ground" in client.call("setup_environment").data["already_there"]


def test_a_picture_is_taken_and_kept_in_the_run(open_run: Callable) -> None:
    opened = open_run()
    shot = opened.client.call("take_screenshot", filename="view")
    assert Image.open(io.BytesIO(shot.images[0])).size == (1280, 720) and shot.data["filename"] == "view.png"
    assert opened.client.call("take_screenshot", filepath="/etc/other.png").data["filename"] == "other.png"
    with pytest.raises(CallRefused, match="file name"):
        opened.client.call("take_screenshot", filename="../../escape.png")


def test_saving_warns_of_duplicates_that_kept_their_identity(open_run: Callable) -> None:
    client = open_run().client
    script = """import unreal
editor = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
sofa = next(actor for actor in editor.get_all_level_actors() if actor.get_actor_label() == "Sofa")
sofa.tags.append("simcodearena.stable_actor_id=sca_source_1")
copy = editor.duplicate_actor(sofa)
"""
    client.call("execute_python_script", script=script, execution_mode="sync")
    warning = client.call("save_scene_as", name="doubled").data["warning"]
    assert "Sofa" in warning and warning.count("Sofa") == 2 and "cannot be judged" in warning
    client.call("execute_python_script", script="copy.tags = []", execution_mode="sync")
    assert "warning" not in client.call("save_scene_as", name="mended").data


def test_saving_writes_a_level_and_can_revert(open_run: Callable) -> None:
    opened = open_run()
    opened.client.call("delete_actor", name="Sofa")
    saved = opened.client.call("save_scene_as", name="mine-1").data
    assert saved == {"package": "/Game/SavedScenes/mine-1", "actors": 5}
    level = json.loads((opened.folder / "content/Game/SavedScenes/mine-1.level.json").read_text())
    assert "Sofa" not in [actor["label"] for actor in level["actors"]]
    again = opened.client.call("save_scene_as", name="mine-2", revert_to_original=True).data
    assert again["open_level"] == START
    assert "Sofa" in [actor["label"] for actor in opened.client.call("get_actors_in_level").data["actors"]]
    for bad in ("../x", "a/b", "", "a b"):
        with pytest.raises(CallRefused, match="invalid arguments"):
            opened.client.call("save_scene_as", name=bad)
