"""What left a trial pending is recorded, and an attempt has a bounded number of repeats (policy: ``c4s.errors``)."""

from __future__ import annotations

import time
from typing import Any

from c4s.errors import MOST_REPEATS, BadInput, MachineryFault, Place
from c4s.files import append_json_line, parse_json
from c4s.records.attempt import AttemptOutcome
from c4s.records.fault import FaultRecord
from c4s.records.folder import TrialFolder
from c4s.run.faults import of_machinery, whose
from c4s.run.limits import LIMITS, Stage
from c4s.run.plan import Trial
from c4s.trajectory import analyse


def note(trial: Trial, stage: Stage, arguments: tuple[Any, ...], error: Exception) -> None:
    """Record what failed. A disk that does not take the record leaves a note on the error."""
    attempt = arguments[0] if stage in ("attempt", "integrity") else None
    place: Place = "attempt" if stage == "attempt" else "scene" if LIMITS[stage].of_scene else "elsewhere"
    by_whom = whose(error, place)
    record = FaultRecord(
        time=round(time.time(), 3),
        stage=stage,
        attempt=attempt,
        whose=by_whom,
        counted=stage == "attempt" and by_whom == "doubt" and _acted(trial.folder, arguments[0]),
        error=type(error).__name__,
        line=of_machinery(error, where=trial.name).line(),
        traceback="\n".join(getattr(error, "__notes__", ())),
    )
    try:
        append_json_line(trial.folder.faults, record.plain())
    except OSError as full:
        error.add_note(f"and it could not be recorded: {full}")


def note_lost(trial: Trial, error: MachineryFault) -> None:
    """Record that the trial's work was lost with the worker that had it. It counts no attempt."""
    append_json_line(
        trial.folder.faults,
        FaultRecord(
            time=round(time.time(), 3), stage="worker", whose="machinery", error=type(error).__name__, line=error.line()
        ).plain(),
    )


def spent(trial: Trial, number: int) -> bool:
    """Whether an attempt has had all its repeats: one more failure in doubt than there are."""
    return sum(record.counted and record.attempt == number for record in faults(trial.folder)) > MOST_REPEATS


def end(trial: Trial, number: int) -> None:
    """The outcome of an attempt whose repeats are spent: no submission, whatever it saved."""
    folder = trial.folder.attempt(number)
    causes = [record.line for record in faults(trial.folder) if record.counted and record.attempt == number]
    AttemptOutcome(
        attempt=number,
        ended_by="repeats_spent",
        submission=None,
        tool_calls=analyse(folder.trajectory).calls,
        client=trial.working.client,
        model=trial.working.model,
        message=f"{len(causes)} runs failed, the last: {causes[-1]}"[:2000],
    ).write(folder.outcome)


def faults(folder: TrialFolder) -> list[FaultRecord]:
    """What is on record. A line that a killed process or a full disk cut short is no record, and is left out."""
    if not folder.faults.is_file():
        return []
    found = (_record(line) for line in folder.faults.read_bytes().split(b"\n"))
    return [record for record in found if record is not None]


def _record(line: bytes) -> FaultRecord | None:
    try:
        return FaultRecord.parse(parse_json(line))
    except (ValueError, BadInput):
        return None


def _acted(folder: TrialFolder, number: int) -> bool:
    """Whether the agent called a tool in the attempt that has just failed."""
    return analyse(folder.attempt(number).trajectory).calls > 0
