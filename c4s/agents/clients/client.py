"""An agent client that is a program of its own: prepare, run confined, tell how it ended. One small file a client."""

from __future__ import annotations

import json
from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from c4s.agents.base import AgentContext, AgentReport
from c4s.agents.briefing import SERVER, briefing, copied_pictures
from c4s.agents.clients import confined
from c4s.agents.clients.programs import Install, Program, find
from c4s.errors import AgentFault, MachineryFault
from c4s.records.plan import Configuration

TOOL_TIMEOUT_S = 600
ANSWER_BYTES = 200_000
"""What a client's own bound of a tool's answer is set to, where it has one: above any answer of the gateway."""
MOST_TOLD_CHARACTERS = 400


@dataclass(frozen=True)
class Setup:
    """What an adapter writes a configuration from. ``home`` is ``/home/agent`` for the client."""

    program: Program
    home: Path
    prompt: str
    pictures: tuple[str, ...]
    """Reference views, as the client sees them."""
    model: str
    model_url: str
    """The meter, without a path."""
    model_token: str
    tools_url: str
    tools_token: str
    options: Mapping[str, Any]

    def write(self, name: str, text: str) -> str:
        """Write a file under HOME; its path as the client sees it."""
        path = self.home / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return str(confined.HOME / name)

    def write_json(self, name: str, value: Any) -> str:
        """Write a JSON file under HOME; its path as the client sees it."""
        return self.write(name, json.dumps(value, indent=1))


class ExternalClient(ABC):
    """An adapter. Its file says how the client is configured and what is switched off."""

    name: ClassVar[str]
    """The client's name in configurations."""
    install: ClassVar[Install]
    """How it is installed."""
    wire: ClassVar[str]
    """The wire format that it speaks to its model."""
    sandbox: ClassVar[str] = "bubblewrap"
    """What confines its processes, for the attempt's manifest."""
    endpoint: ClassVar[str]
    """The model endpoint where the configuration names none."""

    @abstractmethod
    def command(self, setup: Setup) -> confined.Command:
        """Write the client's configuration and say what to run."""

    def closing(self, lines: Iterator[Mapping[str, Any]]) -> str:
        """The client's closing words or its error, from the JSON lines that it printed."""
        return ""

    def wire_of(self, configuration: Configuration) -> str:
        """The wire format that it speaks to its model."""
        return self.wire

    def program(self, options: Mapping[str, Any]) -> Program:
        """The installed client; ``BadInput`` with the installing command where there is none."""
        return find(self.install, options)

    def ready(self, configuration: Configuration) -> None:
        """``BadInput`` where the client is not installed, ``MachineryFault`` where it cannot be confined."""
        self.program(configuration.options)
        confined.check()

    def run(self, context: AgentContext) -> AgentReport:
        """Run the client until it ends or its run does."""
        access = context.model
        if access is None:
            raise MachineryFault("no model was opened for this client", where=self.name)
        home = context.folder / "home"
        home.mkdir()
        setup = Setup(
            self.program(context.options),
            home,
            briefing(context.case, SERVER, pictures=len(context.case.reference_views)),
            tuple(
                str(confined.HOME / picture.name)
                for picture in copied_pictures(context.case, context.agent_folder, home)
            ),
            access.model,
            access.url,
            access.token,
            context.endpoint.url,
            context.endpoint.token,
            context.options,
        )
        command = self.command(setup)
        out = context.folder / self.name
        status = confined.run(command, home, out, servers=(access.url, context.endpoint.url), stop=context.stopped)
        words = " ".join(self.closing(_json_lines(out.with_suffix(".stdout"))).split())[:MOST_TOLD_CHARACTERS]
        version = f"{self.name} {setup.program.version}".strip()
        if not context.stopped(0):
            asked = access.run.last_generation
            if status or asked is None:
                told = words or _last_line(out.with_suffix(".stderr"))
                what = f"{self.name} ended with status {status}" + (f": {told}" if told else "")
                access.blame(what)
                raise AgentFault(what)
        return AgentReport(client_version=version, message=words)


def _json_lines(path: Path) -> Iterator[Mapping[str, Any]]:
    """The JSON objects among a client's lines of output; what else it prints is left in the file."""
    with path.open(encoding="utf-8", errors="replace") as lines:
        for line in lines:
            if line.startswith("{"):
                try:
                    value = json.loads(line)
                except ValueError:
                    continue
                if isinstance(value, dict):
                    yield value


def _last_line(path: Path) -> str:
    """The last line of a client's errors that says something."""
    lines = path.read_text(encoding="utf-8", errors="replace").strip().splitlines()
    return " ".join(lines[-1].split())[:MOST_TOLD_CHARACTERS] if lines else ""
