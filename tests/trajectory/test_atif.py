"""Attempts as ATIF documents: every call once and in order, its picture beside it. Harbor's own models read them in
``make test-clients``."""

from __future__ import annotations

import json
from pathlib import Path

from c4s.harness.atif import write_atif
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import AttemptFolder
from c4s.records.plan import Configuration

PICTURE = "a" * 64


def line(event: str, call: int, outcome: str, **more: object) -> str:
    told = {"seq": 1, "time": 1_800_000_000.5, "event": event, "tool": "take_screenshot", "request": f"r{call}"}
    told |= {"counted": event == "call", "call": call, "outcome": outcome, "arguments": {"view": call}}
    return json.dumps(told | more)


def test_an_attempt_is_a_prompt_and_a_step_a_call(tmp_path: Path) -> None:
    attempt = AttemptFolder(tmp_path / "attempt-1")
    attempt.images.mkdir(parents=True)
    (attempt.images / f"{PICTURE}.png").write_bytes(b"png")
    lines = [
        line("started", 1, "unfinished"),
        line("started", 2, "unfinished"),
        line("call", 2, "error", error="no view", result='{"error":"no view"}', duration_s=0.5),
        line("call", 1, "ok", result='{"result":{}}', images=[{"sha256": PICTURE, "bytes": 3}], duration_s=1.5),
        json.dumps({"event": "refused", "tool": "shell", "request": "r9", "counted": False, "outcome": "refused"}),
        line("started", 3, "unfinished"),
    ]
    attempt.trajectory.write_text("\n".join(lines) + "\n")
    AttemptOutcome(attempt=1, ended_by="finished", submission=None, tool_calls=3, client="codex").write(attempt.outcome)
    chosen = Configuration(name="mine", client="codex", model="m", harness="harbor")
    made = write_atif(attempt, tmp_path / "out", session="mine/case/r1", configuration=chosen, prompt="Build a yard.")
    assert json.loads((tmp_path / "out/trajectory.json").read_text()) == made
    assert [step["step_id"] for step in made["steps"]] == [1, 2, 3, 4]
    assert made["steps"][0] == {"step_id": 1, "source": "user", "message": "Build a yard."}
    first, second, third = (step["observation"]["results"][0] for step in made["steps"][1:])
    path = first["content"][1]["source"]["path"]
    assert (tmp_path / "out" / path).read_bytes() == b"png"
    assert second["content"] == '{"error":"no view"}' and third["extra"] == {"outcome": "unfinished"}
    assert made["steps"][1]["timestamp"] == "2027-01-15T07:59:59+00:00"
    assert made["agent"]["extra"]["harness"] == "harbor" and "model_name" not in made["agent"]
