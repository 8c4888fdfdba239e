"""Checks of the bridge: requests and replies, jobs and their logs, calls, and how an engine ends."""

from __future__ import annotations

import time
from collections.abc import Mapping
from typing import Any

from c4s.engine.bridge import FAILED
from c4s.engine.conformance.check import Failed, Group, need
from c4s.engine.conformance.ground import Ground
from c4s.engine.faults import EngineCallError, EngineDied

_LATE_S = 30.0
_PAUSE_S = 0.1
"""Longer than a tick."""
_LOOP = "import time\nprint('begun', flush=True)\nwhile True:\n    time.sleep(0.01)\n"

check = Group("bridge")
CHECKS = check.checks


@check("An engine says which kind and version it is")
def kind_and_version_are_told(ground: Ground) -> None:
    need(ground.engine.kind == ground.kind, f"it calls itself {ground.engine.kind!r}")
    need(bool(ground.engine.version), "it tells no version")


@check("What a script prints comes back as whole lines, in order")
def printed_lines_come_back(ground: Ground) -> None:
    lines = ground.engine.execute("for i in range(500):\n    print('line', i)")["result"]["python_logs"]
    told = [line for line in lines if line.startswith("line ")]
    need(told == [f"line {i}" for i in range(500)], f"{len(told)} of 500 lines came back, or out of order")


@check("Scripts of a session share one namespace")
def scripts_share_a_namespace(ground: Ground) -> None:
    ground.engine.execute("kept_for_later = 41")
    lines = ground.engine.execute("print('kept', kept_for_later + 1)")["result"]["python_logs"]
    need("kept 42" in lines, f"the second script printed {lines}")


@check("A script that raises is answered with its exception and its line")
def errors_name_the_line(ground: Ground) -> None:
    reply = ground.engine.execute("x = 1\nraise ValueError('no good')")
    need(reply["status"] in FAILED, f"the status is {reply['status']!r}")
    text = str(reply.get("error"))
    need("ValueError: no good" in text and "line 2" in text, f"the error reads {text!r}")


@check("A script that runs longer than it was waited for is a job whose log can be read on")
def long_scripts_become_jobs(ground: Ground) -> None:
    script = "import time\nprint('one', flush=True)\ntime.sleep(0.5)\nprint('two', flush=True)"
    reply = ground.engine.request("execute_python_script", {"script": script, "wait_s": 0})
    need(reply["status"] == "running" and "job_id" in reply, f"it was answered with {_short(reply)}")
    lines = list(reply["result"]["python_logs"])
    while reply["status"] == "running":
        offset = reply["result"]["next_offset"]
        reply = ground.engine.request("read_job_log", {"job_id": reply["job_id"], "offset": offset, "wait_s": _LATE_S})
        lines += reply["result"]["python_logs"]
    need(lines == ["one", "two"], f"its log is {lines}")


@check("A log can be read again from any byte")
def logs_are_read_from_an_offset(ground: Ground) -> None:
    reply = ground.engine.execute("print('first')\nprint('second')")
    again = ground.engine.request("read_job_log", {"job_id": reply["job_id"], "offset": len("first\n")})
    need(again["result"]["python_logs"] == ["second"], f"from byte 6 on it reads {again['result']['python_logs']}")


@check("An engine says that it is busy while a script runs, and idle afterwards")
def busy_and_idle_are_told(ground: Ground) -> None:
    job = _begin_loop(ground)
    told = ground.engine.request("editor_status")
    ground.engine.request("abandon_job", {"job_id": job})
    _until_ended(ground, job)
    need(told["state"] == "busy" and told["job_id"] == job, f"while a script ran it said {_short(told)}")
    after = ground.engine.request("editor_status")
    need(after["state"] == "idle", f"afterwards it said {_short(after)}")


@check("A script that is abandoned ends, and the next one runs")
def abandoned_scripts_end(ground: Ground) -> None:
    job = _begin_loop(ground)
    ground.engine.request("abandon_job", {"job_id": job})
    ended = _until_ended(ground, job)
    need(ended["status"] in FAILED, f"the abandoned script ended with status {ended['status']!r}")
    need(ground.engine.execute("print('next')")["result"]["python_logs"] == ["next"], "the next script did not run")


@check("A call returns a value, apart from what is printed")
def calls_return_values(ground: Ground) -> None:
    value = ground.engine.call("capture.viewport_camera")
    need(isinstance(value, dict) and len(value["location_cm"]) == 3, f"it returned {value!r}")


@check("A call whose function raises says which exception it was")
def failed_calls_name_the_exception(ground: Ground) -> None:
    try:
        ground.engine.call("capture.capture_views", cameras=[], folder=str(ground.scratch), mode="no such mode")
    except EngineCallError as error:
        need(error.kind == "ValueError" and "mode must be one of" in error.what, f"it said {error.kind}: {error.what}")
    else:
        raise Failed("it returned")


@check("A call of a function that there is not is an error of that call")
def unknown_functions_are_refused(ground: Ground) -> None:
    try:
        ground.engine.call("scene_tools.no_such_function")
    except EngineCallError:
        return
    raise Failed("it returned")


@check("A request of an unknown kind, and one without its fields, are answered with an error")
def wrong_requests_are_answered(ground: Ground) -> None:
    for kind in ("no_such_request", "execute_python_script", "read_job_log"):
        reply = ground.engine.request(kind, {})
        need(reply["status"] in FAILED and bool(reply.get("error")), f"{kind} was answered with {_short(reply)}")


@check("A tick function runs between jobs, with the seconds since the last tick, until it is taken back")
def tick_functions_run_between_jobs(ground: Ground) -> None:
    ground.facts(
        "seen = []\nhandle = unreal.register_slate_post_tick_callback(seen.append)\nfact('now', len(seen))", clear=False
    )
    deadline = time.monotonic() + _LATE_S
    while not ground.facts("fact('seconds', list(seen))", clear=False)["seconds"]:
        need(time.monotonic() < deadline, f"no tick in {_LATE_S:g} s")
        time.sleep(_PAUSE_S)
    found = ground.facts(
        "unreal.unregister_slate_post_tick_callback(handle)\nfact('positive', min(seen) > 0)\nfact('n', len(seen))",
        clear=False,
    )
    time.sleep(_PAUSE_S)
    after = ground.facts("fact('n', len(seen))", clear=False)
    need(found["positive"] and after["n"] == found["n"], f"it ran {after['n'] - found['n']} times more")


@check("An engine that a script ends is told as dead at once, with what the script had printed")
def an_engine_that_ends_is_told(ground: Ground) -> None:
    engine = ground.engine
    try:
        engine.execute("import os\nprint('last words', flush=True)\nos._exit(7)")
    except EngineDied as death:
        need("last words" in death.lines, f"its lines are {death.lines}")
    else:
        raise Failed("the script came back")
    need(not engine.alive, "it says that it is alive")


@check("An engine that is killed answers nothing any more, and its logs stay")
def a_killed_engine_is_gone(ground: Ground) -> None:
    engine = ground.engine
    engine.execute("print('kept')")
    engine.kill()
    need(not engine.alive, "it says that it is alive")
    need(any(b"kept" in file.read_bytes() for file in engine.logs.glob("*.log")), "its logs are gone")
    try:
        engine.request("editor_status")
    except EngineDied:
        return
    raise Failed("it answered")


def _begin_loop(ground: Ground) -> str:
    """The job of a script that runs for ever, which has begun."""
    reply = ground.engine.request("execute_python_script", {"script": _LOOP, "wait_s": 0})
    deadline = time.monotonic() + _LATE_S
    while "begun" not in reply["result"]["python_logs"]:
        need(time.monotonic() < deadline, f"a script did not begin in {_LATE_S:g} s")
        reply = ground.engine.request("read_job_log", {"job_id": reply["job_id"], "offset": 0, "wait_s": 0.1})
    return str(reply["job_id"])


def _until_ended(ground: Ground, job: str) -> dict[str, Any]:
    reply = ground.engine.request("read_job_log", {"job_id": job, "offset": 0, "wait_s": _LATE_S})
    need(reply["status"] != "running", f"it still ran {_LATE_S:g} s after it was abandoned")
    return reply


def _short(reply: Mapping[str, Any]) -> str:
    return str(dict(reply))[:200]
