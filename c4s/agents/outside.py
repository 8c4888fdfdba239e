"""A client that nobody here starts: the gateway is open, and whoever knows its address and token does the work.

What a client needs lies in the agent's folder: ``connect.json`` (address and token of the gateway, for its owner's eyes
only), ``task.md`` (what every agent is told first) and the reference views. The client is not confined.
"""

from __future__ import annotations

import os
import time
from pathlib import Path

from pydantic import Field

from c4s.agents.base import AgentContext, AgentReport
from c4s.agents.briefing import SERVER, briefing, copied_pictures
from c4s.files import json_lines, json_text
from c4s.records.base import Record
from c4s.records.folder import AttemptFolder
from c4s.records.plan import Configuration

OUTSIDE = "outside"
"""Name of the client."""
LOOK_S = 0.2


class Options(Record):
    """The options of the client ``outside``."""

    port: int = Field(default=0, ge=0, le=65535)
    """Port of the gateway; 0 for any that is free."""
    after_save_s: float = Field(default=300.0, ge=0, allow_inf_nan=False)
    """Seconds without a call after a save until the agent counts as done."""


class Connection(Record):
    """What a client from outside needs: where the gateway is, and where the task lies."""

    url: str
    token: str
    url_with_token: str
    """The same for a client that cannot send headers."""
    task: str
    """Path of the text that the agent is told first."""
    pictures: list[str]
    """Paths of the reference views."""


class DeskFolder:
    """The agent's folder as the client from outside and its owner see it."""

    def __init__(self, root: Path) -> None:
        self.root = root

    @property
    def connection(self) -> Path:
        """Where the ``Connection`` lies once the gateway is open."""
        return self.root / "connect.json"

    @property
    def done(self) -> Path:
        """A file that tells that no more work will come."""
        return self.root / "done"

    @property
    def task(self) -> Path:
        """What the agent is told first."""
        return self.root / "task.md"


class Outside:
    """The agent ``outside``. Options: ``port``, ``after_save_s``."""

    def port_of(self, configuration: Configuration) -> int:
        """The port that the gateway shall have; 0 for any."""
        return _options(configuration).port

    def run(self, context: AgentContext) -> AgentReport:
        """Say where the gateway is; wait until the run ends, its owner says so, or nothing comes after a save."""
        desk, options = DeskFolder(context.folder), _options(context.configuration)
        pictures = copied_pictures(context.case, context.agent_folder, desk.root)
        desk.task.write_text(briefing(context.case, SERVER, pictures=len(pictures)))
        told = Connection(
            url=context.endpoint.url,
            token=context.endpoint.token,
            url_with_token=context.endpoint.url_with_token,
            task=str(desk.task),
            pictures=[str(picture) for picture in pictures],
        )
        _write_private(desk.connection, json_text(told.plain()))
        attempt = AttemptFolder(context.folder.parent)
        while not context.stopped(LOOK_S):
            if desk.done.exists():
                return AgentReport(message="its owner ended it")
            if _is_quiet(attempt, options.after_save_s):
                return AgentReport(message=f"no call came in the {options.after_save_s:g} s after it had saved")
        return AgentReport()


def _options(configuration: Configuration) -> Options:
    return Options.parse(dict(configuration.options), where=configuration.name)


def _write_private(path: Path, text: str) -> None:
    """Write a file that only its owner can read; it is whole as soon as it is there."""
    part = path.with_name(f".{path.name}")
    with os.fdopen(os.open(part, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600), "w", encoding="utf-8") as file:
        file.write(text)
    part.rename(path)


def _is_quiet(attempt: AttemptFolder, seconds: float) -> bool:
    """Whether something was saved, no call is being answered, and none came for so long."""
    if not attempt.saves.is_file() or time.time() - attempt.trajectory.stat().st_mtime < seconds:
        return False
    with attempt.trajectory.open(encoding="utf-8") as lines:
        events = [line["event"] for line in json_lines(lines)]
    return events.count("started") == events.count("call")
