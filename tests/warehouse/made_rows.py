"""Rows of made trials, as parts of a warehouse."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from c4s.protocol.settings import SETTINGS
from warehouse.parquet import write_part
from warehouse.records import OutcomeRow, PictureRow, ScheduleRow


def trial_row(number: int, configuration: str = "alpha", **other: Any) -> dict[str, Any]:
    """What every row of a trial carries."""
    return {
        "trial_id": f"{configuration}-{number}",
        "run_id": "run",
        "suite": "s",
        "suite_digest": "d",
        "configuration": configuration,
        "configuration_digest": configuration,
        "case_id": f"case-{number}",
        "repeat": 1,
    } | other


def _shared(number: int) -> dict[str, Any]:
    setting = SETTINGS[number % len(SETTINGS)]
    return {"setting": setting, "scene_id": "x", "policy": "p", "judge": "rule", "engine": "headless", "ranked": True}


def store_outcome(root: Path, number: int, score: float, configuration: str = "alpha") -> Path:
    """The outcome of a trial; returns its part."""
    row = OutcomeRow(
        **trial_row(number, configuration),
        **_shared(number),
        status="measured",
        score=score,
        reason="",
        attempts=1,
        retained_attempt=1,
        tool_calls=1,
        attempt_wall_s=1.0,
        evaluation_s=1.0,
        orchestration_s=0.0,
        input_tokens=None,
        output_tokens=None,
        cost_usd=None,
        score_sha256="0",
    )
    return write_part(root, "outcomes", [row], suite="s", configuration=configuration, key=row.trial_id)


def store_schedule(
    root: Path, numbers: range, configuration: str = "alpha", *, run: str = "run", planned_at: str = "2026-01-01"
) -> Path:
    """The plan of a configuration's trials, as one part."""
    rows = [
        ScheduleRow(
            **trial_row(number, configuration, run_id=run),
            **_shared(number),
            planned_at=planned_at,
            client="noop",
            model=None,
            title="",
            prompt="",
            operations="",
            operation_group=None,
            difficulty=None,
            visibility="public",
            proxy_assets=False,
        )
        for number in numbers
    ]
    return write_part(root, "schedule", rows, suite="s", configuration=configuration, key=run)


def store_picture(root: Path, number: int, jpeg: bytes, configuration: str = "alpha") -> Path:
    """A picture of a trial."""
    row = PictureRow(**trial_row(number, configuration), role="submission", view="v", width=1, height=1, jpeg=jpeg)
    return write_part(root, "pictures", [row], suite="s", configuration=configuration, key=row.trial_id)
