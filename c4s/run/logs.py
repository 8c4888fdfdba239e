"""Logs as JSON lines: a file for each process that works on a run, and standard error where ``C4S_LOG`` is ``json``.

A line has time, level, host, pid, what happened and, of a trial, its id, stage and attempt. All text is ASCII with
escapes, so nothing that an agent, a model or a file chose can end a line or steer a terminal.
"""

from __future__ import annotations

import logging
import logging.handlers
import platform
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Final

from c4s.records.folder import RunFolder
from c4s.records.journal import Event
from c4s.run.journal import process_name
from c4s.run.owner import this_process
from c4s.stderr import as_json, json_line, tell

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
        fields = self._always | getattr(record, "fields", {})
        if record.exc_info:
            fields["traceback"] = self.formatException(record.exc_info)
        return json_line(record.levelname.lower(), record.getMessage(), record.created, **fields)


class LogFile(logging.handlers.RotatingFileHandler):
    """A log file that tells in one line, once, when it takes nothing more."""

    _told = False

    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802
        """A full disk stops no run."""
        if not self._told:
            self._told = True
            tell(f"c4s: the log takes nothing, so it is incomplete: {sys.exc_info()[1]}")


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
        LogFile(folder.logs / f"{process_name(owner)}.jsonl", maxBytes=FILE_BYTES, backupCount=FILES, delay=True)
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
