"""Logs as JSON lines: a file for each process that works on a run, and standard error where ``C4S_LOG`` is ``json``.

A line has time, level, host, pid, what happened and, of a trial, its id, stage and attempt. All text is ASCII with
escapes, so nothing that an agent, a model or a file chose can end a line or steer a terminal.
"""

from __future__ import annotations

import json
import logging
import logging.handlers
import os
import platform
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, Final

from c4s.errors import BadInput
from c4s.records.folder import RunFolder
from c4s.records.journal import Event
from c4s.run.journal import process_name
from c4s.run.owner import this_process

CHOICE: Final = "C4S_LOG"
LOGGER: Final = logging.getLogger("c4s")
FILE_BYTES, FILES = 8 << 20, 4
"""A log file's size, and how many older ones of a process are kept."""
_LEVELS = {"failed": logging.WARNING, "pending": logging.ERROR, "stopped": logging.WARNING, "paused": logging.WARNING}


class JsonLines(logging.Formatter):
    """A record as one line of JSON."""

    def __init__(self, always: Mapping[str, Any]) -> None:
        super().__init__()
        self._always = dict(always)

    def format(self, record: logging.LogRecord) -> str:
        """The line, without its end."""
        told = {
            "time": datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds"),
            "level": record.levelname.lower(),
            **self._always,
            "message": record.getMessage(),
            **getattr(record, "fields", {}),
        }
        if record.exc_info:
            told["traceback"] = self.formatException(record.exc_info)
        return json.dumps(told, default=str)


def as_json() -> bool:
    """Whether standard error takes JSON lines. ``BadInput`` for a choice that is none."""
    told = os.environ.get(CHOICE, "").strip()
    if told not in ("", "json"):
        raise BadInput(f"{CHOICE} is {told!r}", todo="set it to json, or unset it")
    return told == "json"


@contextmanager
def logging_to(run: Path, trial_id: Callable[[str], str]) -> Iterator[Callable[[Event], None]]:
    """Log for the block; gives the listener that logs a run's events.

    Args:
        run: the run folder; it has its plan.
        trial_id: the id of a trial by its path below the run's folder.
    """
    owner, folder = this_process(), RunFolder(run)
    always = {"host": platform.node(), "pid": owner.pid, "run": folder.root.name}
    folder.logs.mkdir(parents=True, exist_ok=True)
    handlers: list[logging.Handler] = [
        logging.handlers.RotatingFileHandler(
            folder.logs / f"{process_name(owner)}.jsonl", maxBytes=FILE_BYTES, backupCount=FILES, delay=True
        )
    ]
    if as_json():
        handlers.append(logging.StreamHandler(sys.stderr))
    before = LOGGER.level, LOGGER.propagate
    LOGGER.setLevel(logging.INFO)
    LOGGER.propagate = False
    for handler in handlers:
        handler.setFormatter(JsonLines(always))
        LOGGER.addHandler(handler)
    try:
        yield lambda event: _log(event, trial_id)
    finally:
        for handler in handlers:
            LOGGER.removeHandler(handler)
            handler.close()
        LOGGER.level, LOGGER.propagate = before


def _log(event: Event, trial_id: Callable[[str], str]) -> None:
    told = event.model_dump(mode="json", exclude_none=True, exclude={"time", "owner"})
    if event.trial is not None:
        told["trial_id"] = trial_id(event.trial)
    what = " ".join(str(part) for part in (event.stage, event.verifier, event.attempt) if part is not None)
    LOGGER.log(_LEVELS.get(event.event, logging.INFO), " ".join((what, event.event)).strip(), extra={"fields": told})
