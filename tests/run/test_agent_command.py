"""``c4s agent``: the clients, a trial to watch, an attempt played again."""

from __future__ import annotations

import json
import re
from collections import Counter
from pathlib import Path
from urllib.parse import urlparse

from rich.console import Console

from c4s.agents.base import CLIENTS, MODEL_CLIENTS, ModelClient, agent_of
from c4s.cli.live import LiveView
from c4s.records.attempt import AttemptOutcome
from c4s.records.plan import Configuration
from tests.run.conftest import Command
from warehouse.database import rows

CASE = "text-flat-family"


def test_a_try_is_watched_scored_and_shown_apart_from_the_leaderboard(c4s: Command, home: Path) -> None:
    published = {name: sorted((home / name).rglob("*")) for name in ("runs", "site", "warehouse")}
    done = c4s("agent", "try", "planner", "--case", CASE, "--suite", "small", "--no-open")
    assert done.returncode == 0, done.stderr
    calls = re.findall(
        r"^ +(\d+)  (\w+) .*  (ok|error)(?: \d+ ms)?.*\[(\d+) calls, \d+ min \d+ s left", done.stdout, re.MULTILINE
    )
    assert [int(number) for number, *_ in calls] == list(range(1, len(calls) + 1)) and len(calls) >= 4
    assert calls[-1][1:3] == ("save_scene_as", "ok") and int(calls[0][3]) == int(calls[-1][3]) + len(calls) - 1
    assert "attempt 1: finished" in done.stdout and "saved /Game/SavedScenes/submission" in done.stdout
    page = Path(urlparse(done.stdout.strip().splitlines()[-1]).path)
    assert page.is_relative_to(home / "tries") and CASE in page.name
    assert "planner" in page.read_text()
    assert published == {name: sorted((home / name).rglob("*")) for name in published}

    attempt = next((home / "tries").glob("planner-*/run/planner/*/r1/attempt-1"))
    stored = attempt.parents[4] / "warehouse"
    usage = rows(stored, "SELECT * FROM tool_usage")
    assert [(row["runs"], row["mean_calls"], row["mean_polling_calls"]) for row in usage] == [(1, len(calls), 0)]
    by_tool = rows(stored, "SELECT tool, calls FROM tool_use")
    assert Counter(tool for _, tool, *_ in calls) == {row["tool"]: row["calls"] for row in by_tool}
    assert rows(stored, "SELECT * FROM python_operations") == rows(stored, "SELECT * FROM execution_errors") == []

    again = c4s("agent", "replay", str(attempt), "--json")
    told = json.loads(again.stdout)
    assert again.returncode == 0 and told["equal"] and told["tool_calls"] == len(calls)
    outcome = AttemptOutcome.read(attempt / "outcome.json")
    outcome.model_copy(update={"submission_sha256": "0" * 64}).write(attempt / "outcome.json")
    other = c4s("agent", "replay", str(attempt))
    assert other.returncode == 1 and "another one" in other.stdout


def test_wrong_requests_are_one_line(c4s: Command, tmp_path: Path) -> None:
    for arguments in (
        ("try", "nobody", "--case", CASE, "--suite", "small"),
        ("try", "noop", "--case", "absent", "--suite", "small"),
        ("try", "noop", "--case", CASE, "--suite", "absent"),
        ("replay", str(tmp_path)),
    ):
        done = c4s("agent", *arguments)
        assert done.returncode == 2 and len(done.stderr.strip().splitlines()) == 1, done.stderr
        assert done.stderr.startswith("c4s: ")


def test_every_client_is_listed_with_what_it_lacks(c4s: Command) -> None:
    listed = json.loads(c4s("agent", "list", "--json").stdout)
    assert {"noop", "planner", "replay", "api", "codex"} <= {row["client"] for row in listed}
    for row in listed:
        assert row["ready"] == (row["problem"] == "") and (row["model"] or row["ready"])


def test_the_clients_that_use_a_model_are_those_that_say_so() -> None:
    made = {name: agent_of(Configuration(name=name, client=name)) for name in CLIENTS}
    assert {name for name, agent in made.items() if isinstance(agent, ModelClient)} == set(MODEL_CLIENTS)


def test_a_line_is_shown_when_it_is_whole_and_a_picture_as_half_blocks(tmp_path: Path) -> None:
    from PIL import Image

    line = {
        "event": "call",
        "call": 1,
        "tool": "take_screenshot",
        "arguments": {},
        "outcome": "ok",
        "error": "",
        "duration_s": 0.5,
        "tool_calls_left": 9,
        "seconds_left": 61,
        "images": [{"sha256": "ab", "bytes": 3}],
    }
    (tmp_path / "images").mkdir()
    Image.new("RGB", (64, 32), (200, 10, 10)).save(tmp_path / "images" / "ab.png")
    (tmp_path / "usage.jsonl").write_text(
        json.dumps({"wire": "chat", "input_tokens": 1, "output_tokens": 1, "cost_usd": None}) + "\n"
    )
    console = Console(record=True, force_terminal=True, color_system="truecolor", width=120)
    view = LiveView(console, tmp_path)
    (tmp_path / "trajectory.jsonl").write_text(json.dumps(line)[:30])
    view.poll()
    assert "take_screenshot" not in console.export_text(clear=False)
    (tmp_path / "trajectory.jsonl").write_text(json.dumps(line) + "\n")
    view.poll()
    shown = console.export_text()
    assert shown.count("take_screenshot") == 1 and "cost unknown" in shown and "1 min 1 s left" in shown
    assert shown.count("▀") == 64 * 16
