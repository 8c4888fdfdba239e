"""One piece of work for an engine, and its state as the host knows it."""

from __future__ import annotations

import threading
from collections.abc import Mapping
from typing import Any

import orjson

from c4s.engine.host.joblog import JobLog


class EngineJob:
    """One piece of work for the engine's main thread."""

    def __init__(self, number: int, request: Mapping[str, Any], log: JobLog, limit_s: float | None = None) -> None:
        self.number = number
        self.id = f"job-{number}"
        self.request = request
        self.log = log
        self.limit_s = limit_s
        """How long it may run once it has started; None for no end."""
        self.asked_to_end: float | None = None
        """``time.monotonic()`` of the last request to end because its time was over."""
        self.done = threading.Event()
        self.started: float | None = None
        """``time.monotonic()`` of its start."""
        self.value: bytes | None = None
        """What it returned, as JSON."""
        self.error: str | None = None
        self.fault: str | None = None
        """Class name of the exception behind ``error``."""
        self.ended = False
        """Whether the engine ended before the job did."""
        self.abandoned = False

    def reply(self, offset: int | None = None, most: int | None = None) -> dict[str, Any]:
        """The state of the job as a bridge reply.

        With whole lines of its output from byte ``offset`` on; with ``most`` that many bytes, the last without offset.
        """
        finished = self.done.is_set()
        read = self.log.read(offset or 0, complete=finished) if most is None else self.log.part(offset, most)
        reply: dict[str, Any] = {"status": "running", "job_id": self.id, "result": read}
        if not finished and self.started is None:
            reply["queued"] = True
        if finished and self.error is None:
            reply |= {"status": "ok", "value": orjson.Fragment(self.value or b"null")}
        elif finished:
            reply |= {"status": "error", "error": self.error, "fault": self.fault}
            if self.ended:
                reply["engine_ended"] = True
        return reply
