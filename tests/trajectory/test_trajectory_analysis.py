"""Trajectory analysis: what counts as a call, what scripts attempt, and which feedback belongs to which script."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.trajectory import FAMILIES, analyse, families_of
from c4s.trajectory.analysis import analyse_lines
from c4s.trajectory.feedback import error_families

TRACEBACK = 'Traceback (most recent call last):\n  File "<script>", line 3, in <module>\n'


def _call(
    number: int, tool: str, result: Any = None, *, request: str | None = None, outcome: str = "ok", **arguments: Any
) -> dict[str, Any]:
    return {
        "event": "call",
        "counted": True,
        "call": number,
        "tool": tool,
        "outcome": outcome,
        "arguments": arguments,
        "request": request or f"id {number}",
        "result": json.dumps({"result": result}),
    }


def _script(number: int, script: str, job: str = "job-1", **more: Any) -> dict[str, Any]:
    return _call(number, "execute_python_script", {"job_id": job, "status": "started"} | more, script=script)


def _log(number: int, job: str, status: str, output: str = "", error: str | None = None) -> dict[str, Any]:
    told = {"job_id": job, "status": status, "output": output} | ({"error": error} if error else {})
    return _call(number, "read_job_log", told, job_id=job)


def test_calls_count_once_failed_and_unfinished_too() -> None:
    lines = [
        _call(1, "search_assets"),
        _call(2, "set_actor_transform", outcome="error"),
        _call(3, "spawn_actor", outcome="ended"),
        _call(4, "spawn_actor", request="id 1"),
        {"event": "refused", "counted": False, "tool": "spawn_actor", "request": "x"},
        {"event": "duplicate", "counted": False, "tool": "search_assets", "request": "id 1"},
        _log(5, "job-1", "running"),
    ]
    found = analyse_lines(lines)
    assert (found.calls, found.polling, found.non_polling, found.failed) == (4, 1, 3, 2)
    assert found.named_transform_calls == 1
    assert found.by_tool == {"read_job_log": 1, "search_assets": 1, "set_actor_transform": 1, "spawn_actor": 1}


def _started(number: int, tool: str, **arguments: Any) -> dict[str, Any]:
    return {
        "event": "started",
        "counted": False,
        "call": number,
        "tool": tool,
        "outcome": "unfinished",
        "arguments": arguments,
        "request": f"id {number}",
    }


@pytest.mark.parametrize("cut", [0, 1, 40])
def test_a_call_that_its_process_left_behind_counts_as_unfinished(tmp_path: Path, cut: int) -> None:
    lines = [
        _started(1, "search_assets"),
        _call(1, "search_assets"),
        _started(2, "execute_python_script", script="a()"),
        _started(3, "spawn_actor"),
        _call(3, "spawn_actor", outcome="ended"),
        {"event": "duplicate", "counted": False, "tool": "spawn_actor", "request": "id 3", "outcome": "duplicate"},
    ]
    text = "".join(json.dumps(line) + "\n" for line in lines)
    path = tmp_path / "trajectory.jsonl"
    path.write_text(text + json.dumps(_call(2, "execute_python_script", script="a()"))[:cut])
    found = analyse(path)
    assert (found.calls, found.failed, found.unfinished, found.python) == (3, 2, 2, 1)
    assert found.submissions[0].parseable and not found.submissions[0].feedback


@pytest.mark.parametrize(
    ("script", "families"),
    [
        ("import unreal\nx.set_actor_location(v, False, True)", ["pose_editing"]),
        ("move = actor.set_actor_rotation\nmove(r, False)", ["pose_editing"]),
        ("getattr(actor, 'set_actor_scale3d')(v)", ["pose_editing"]),
        ("# set_actor_location\nprint('destroy_actor')", []),
        (
            "registry = unreal.AssetRegistryHelpers.get_asset_registry()\nregistry.get_assets_by_path('/Game')",
            ["catalog_lookup"],
        ),
        (
            "m = unreal.load_asset(p)\na = sub.spawn_actor_from_object(m, v)\nsub.destroy_actor(b)\n"
            "les.save_current_level()",
            ["asset_loading", "actor_creation", "actor_removal", "level_io"],
        ),
        (
            "for a in eas.get_all_level_actors():\n    c.set_material(0, m)",
            ["scene_inspection", "appearance_and_properties"],
        ),
    ],
)
def test_families_are_told_by_names_that_are_used(script: str, families: list[str]) -> None:
    found = families_of(script)
    assert found is not None and list(found) == families


@given(st.permutations(["x.set_actor_location(a)", "x.destroy_actor(b)", "list_assets(c)", "save_map(d)"]))
def test_order_of_statements_changes_nothing(lines: list[str]) -> None:
    assert families_of("\n".join(lines)) == tuple(
        family for family in FAMILIES if family in {"pose_editing", "actor_removal", "catalog_lookup", "level_io"}
    )


@pytest.mark.parametrize("script", ["def f(:", "x = (\0)", "(" * 5000, "  x = 1\n y = 2"])
def test_what_does_not_parse_has_no_families_and_is_kept(script: str) -> None:
    assert families_of(script) is None
    only = analyse_lines([_script(1, script)]).submissions[0]
    assert not only.parseable and only.families == [] and not only.feedback


def test_a_startup_acknowledgement_is_no_feedback_and_logs_find_their_script() -> None:
    late = _log(4, "job-2", "error", "halfway\n", TRACEBACK + "AttributeError: 'Actor' object has no attribute 'x'")
    found = analyse_lines(
        [
            _script(1, "a()", "job-1"),
            _script(2, "b()", "job-2"),
            _log(3, "job-2", "running"),
            late,
            late | {"call": 5, "request": "again"},
        ]
    )
    first, second = found.submissions
    assert (first.feedback, first.errors, first.failed) == (False, [], False)
    assert (second.feedback, second.errors, second.failed) == (True, ["AttributeError"], True)


def test_a_synchronous_answer_is_feedback() -> None:
    told = _script(
        1, "c()", status="error", error=TRACEBACK + "unreal.PythonError: TypeError: bad\nTypeError: worse", output=""
    )
    only = analyse_lines([told]).submissions[0]
    assert only.feedback and only.failed and only.errors == ["PythonError", "TypeError"]


def test_an_answer_that_was_cut_short_is_read_as_far_as_it_goes() -> None:
    line = _script(1, "d()", status="error", error=TRACEBACK + "KeyError: 'a'", output="x" * 1000)
    line["result"] = line["result"][:400]
    with pytest.raises(ValueError, match="Unterminated"):
        json.loads(line["result"])
    only = analyse_lines([line, _log(2, "job-1", "done")]).submissions[0]
    assert only.feedback and only.failed and only.errors == ["KeyError"]


def test_errors_are_told_by_the_last_line_of_a_traceback() -> None:
    text = TRACEBACK + "ValueError\n" + TRACEBACK + "mod.CustomError: no\nsaid TypeError: inside a sentence\n"
    assert error_families(text + text) == ["ValueError", "CustomError"]


def test_no_trajectory_is_an_attempt_without_calls(tmp_path: Path) -> None:
    assert analyse(tmp_path / "trajectory.jsonl").calls == 0
    lines = tmp_path / "t.jsonl"
    lines.write_text(json.dumps(_script(1, "x = '\u2028'"), ensure_ascii=False) + "\n", encoding="utf-8")
    assert analyse(lines).python == 1
