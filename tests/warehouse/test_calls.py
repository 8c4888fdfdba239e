"""What the warehouse keeps of an attempt's calls: bounded, whole lengths told, no key, nothing of private cases."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from c4s.files import digest_bytes
from c4s.records.plan import Configuration, PlannedCase
from c4s.run.plan import Trial
from tests.warehouse.made_rows import trial_row
from warehouse.calls import (
    ANSWER,
    ARGUMENTS,
    ATTEMPT_TEXT,
    HIDDEN,
    MOST_CALLS,
    MOST_SCREENSHOTS,
    SCREENSHOT_WIDTH,
    SCRIPT,
    call_rows,
    screenshot_rows,
)
from warehouse.parquet import write_part
from warehouse.records import AttemptRow, CallRow
from warehouse.trial_part import trial_part

HOSTILE = "</script><img src=x onerror=alert(1)>\u202e javascript:alert(2) \0 \x1b[31m"


def attempt(number: int = 1) -> AttemptRow:
    return AttemptRow(
        **trial_row(1),
        attempt=number,
        ended_by="finished",
        recorded=True,
        client="c",
        model=None,
        client_version="",
        engine_version="",
        sandbox="",
        submission=None,
        valid=None,
        tool_calls=1,
        polling_calls=0,
        python_calls=0,
        failed_calls=0,
        named_transform_calls=0,
        wall_s=1.0,
        input_tokens=None,
        output_tokens=None,
        cost_usd=None,
        message="",
    )


@pytest.fixture
def trial(tmp_path: Path) -> Trial:
    case = PlannedCase(
        case_id="case-1", alias="case-a", setting="text-to-scene", scene_id="x", agent_digest="", withheld_digest=""
    )
    made = Trial(tmp_path / "runs/run", tmp_path, Configuration(name="alpha", client="noop"), case, 1)
    made.folder.attempt(1).root.mkdir(parents=True)
    return made


def record(trial: Trial, calls: list[dict[str, Any]]) -> list[CallRow]:
    """The rows of calls that are written as a trajectory."""
    lines = [
        {
            "event": "call",
            "counted": True,
            "request": str(number),
            "call": number,
            "tool": "spawn_actor",
            "arguments": {},
            "outcome": "ok",
            "start_s": 0.5,
            "duration_s": 0.25,
            "tool_calls_left": 9,
            "seconds_left": 60,
            **call,
        }
        for number, call in enumerate(calls, start=1)
    ]
    trial.folder.attempt(1).trajectory.write_text("".join(json.dumps(line) + "\n" for line in lines))
    return call_rows(trial, [attempt()], trial_row(1))


def test_a_call_is_kept_as_it_was_sent_and_answered(trial: Trial) -> None:
    (row,) = record(trial, [{"arguments": {"name": "A"}, "result": '{"result":1}', "result_characters": 12}])
    assert (row.call, row.tool, row.outcome, row.arguments, row.answer) == (
        1,
        "spawn_actor",
        "ok",
        '{"name":"A"}',
        '{"result":1}',
    )
    assert (row.start_s, row.duration_s, row.calls_left, row.seconds_left) == (0.5, 0.25, 9, 60)
    (script,) = record(trial, [{"tool": "execute_python_script", "arguments": {"script": "x = 1", "wait": True}}])
    assert (script.script, script.arguments) == ("x = 1", '{"wait":true}')


def test_huge_texts_are_cut_and_their_length_told(trial: Trial) -> None:
    huge = "x" * 10_000_000
    call = {"tool": "execute_python_script", "arguments": {"script": huge, "more": huge}, "result": huge}
    (row,) = record(trial, [{**call, "result_characters": 20_000_000}])
    assert [len(row.script), len(row.arguments), len(row.answer)] == [SCRIPT, ARGUMENTS, ANSWER]
    assert (row.script_characters, row.answer_characters) == (10_000_000, 20_000_000)
    assert row.arguments_characters > 10_000_000


def test_no_attempt_can_fill_the_warehouse(trial: Trial) -> None:
    found = record(trial, [{"arguments": {"a": "x" * 5_000}, "result": "y" * 5_000}] * (MOST_CALLS + 5))
    assert len(found) == MOST_CALLS
    assert sum(len(row.arguments) + len(row.answer) for row in found) < ATTEMPT_TEXT + MOST_CALLS * 400 + ARGUMENTS


@pytest.mark.parametrize(
    "secret",
    [
        "sk-abcdefghijklmnop1234",
        "ghp_abcdefghijklmnop1234",
        "AKIAABCDEFGHIJKLMNOP",
        "-----BEGIN PRIVATE KEY-----\nMIIabc\n-----END PRIVATE KEY-----",
    ],
)
def test_what_looks_like_a_key_is_left_out(trial: Trial, secret: str) -> None:
    at_the_cut = "x" * (ANSWER - 12) + " " + secret
    for text in (f"key={secret} end", at_the_cut):
        (row,) = record(trial, [{"arguments": {"a": secret}, "result": text, "error": secret}])
        told = row.arguments + row.answer + row.error
        assert secret[:10] not in told and HIDDEN in told


def test_a_bearer_and_the_place_of_the_run_are_left_out(trial: Trial) -> None:
    place = str(trial.run.parent.absolute())
    (row,) = record(trial, [{"result": f"Authorization: Bearer abcdefghijklmnopqrstuvwxyz {place}/run/alpha"}])
    assert row.answer == f"Authorization: Bearer {HIDDEN} …/run/alpha"


def test_names_of_content_are_no_keys(trial: Trial) -> None:
    names = "/Game/A/SK_Wooden_Chair_With_Cushion_01 sk_wooden_chair_with_cushion task-force-of-seventeen-people"
    (row,) = record(trial, [{"result": names}])
    assert row.answer == names


def test_hostile_texts_can_be_written_and_read(trial: Trial, tmp_path: Path) -> None:
    found = record(trial, [{"tool": HOSTILE, "arguments": {HOSTILE: HOSTILE}, "result": HOSTILE, "error": HOSTILE}])
    write_part(tmp_path / "w", "calls", found, suite="s", configuration="alpha", key="alpha-1")
    (read,) = trial_part(tmp_path / "w", "calls", suite="s", configuration="alpha", trial_id="alpha-1")
    assert read["answer"] == read["error"] == HOSTILE and HOSTILE in json.loads(read["arguments"])
    assert trial_part(tmp_path / "w", "calls", suite="s", configuration="alpha", trial_id="alpha-2") == []


def test_screenshots_are_small_and_an_even_choice(trial: Trial) -> None:
    from PIL import Image

    images = trial.folder.attempt(1).images
    images.mkdir()
    names = []
    for number in range(MOST_SCREENSHOTS + 20):
        Image.new("RGB", (1600, 900), (number, 0, 0)).save(images / "one.png")
        names.append(digest_bytes((images / "one.png").read_bytes()))
        (images / "one.png").rename(images / f"{names[-1]}.png")
    found = record(trial, [{"images": [{"sha256": name, "bytes": 1}]} for name in names])
    kept = list(screenshot_rows(trial, [attempt()], trial_row(1)))
    assert len(kept) == MOST_SCREENSHOTS and {row.width for row in kept} == {SCREENSHOT_WIDTH}
    assert {row.view for row in kept} == {view for row in found for view in row.screenshots.split()}
    assert found[0].screenshots and found[-1].screenshots
    assert all(len(row.jpeg) < 20_000 for row in kept)
