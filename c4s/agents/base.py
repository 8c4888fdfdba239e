"""What an agent is: something that is given a case and an endpoint, and works on the scene through the tools."""

from __future__ import annotations

import importlib
import threading
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, runtime_checkable

from c4s.agents.joining import joined
from c4s.errors import BadInput
from c4s.protocol.baselines import CHEATS
from c4s.records.plan import Configuration
from c4s.records.suite import AgentCase

if TYPE_CHECKING:
    from c4s.agents.model import ModelAccess
    from c4s.toolbox.client import GatewayClient
    from c4s.toolbox.gateway import Endpoint

SUBMISSION_NAME = "submission"
"""Name under which the baselines save their scene."""


@dataclass(frozen=True)
class AgentContext:
    """What an agent is given. Everything else it learns through the tools."""

    case: AgentCase
    agent_folder: Path
    """The case's agent folder: the prompt's facts and the reference views."""
    endpoint: Endpoint
    configuration: Configuration
    attempt: int
    """1 or 2."""
    folder: Path
    """A folder of its own for logs and client state."""
    truth_package: str | None = None
    """Package of the truth level; given to ``oracle`` alone."""
    model: ModelAccess | None = None
    """The model's meter; given to clients that use a model."""
    stopped: Callable[[float], bool] = lambda seconds: threading.Event().wait(seconds)
    """Waits up to so many seconds; True once the run takes no more calls."""

    @property
    def options(self) -> Mapping[str, Any]:
        """The configuration's options."""
        return self.configuration.options

    def connect(self) -> GatewayClient:
        """A client of the run's tools (a context manager)."""
        from c4s.toolbox.client import GatewayClient

        return GatewayClient(self.endpoint)


@dataclass(frozen=True)
class AgentReport:
    """What an agent tells of its work; ``usage`` has one record a model request."""

    client_version: str = ""
    message: str = ""
    usage: list[dict[str, Any]] = field(default_factory=list)
    """Records with ``input_tokens``, ``output_tokens`` and ``cost_usd`` where they are known."""


class Agent(Protocol):
    """An agent client. ``run`` returns when the agent is done, and raises ``AgentFault`` when it fails.

    It must end when a call raises ``RunStopped``: the run takes no more calls.
    """

    def run(self, context: AgentContext) -> AgentReport:
        """Work on the case until done."""
        ...


@runtime_checkable
class ModelClient(Protocol):
    """An agent that uses a model: it says what it needs before an engine is started for it."""

    endpoint: str
    """Name of the model endpoint where its configuration names none."""

    def wire_of(self, configuration: Configuration) -> str:
        """The wire format that it speaks to its model."""
        ...

    def ready(self, configuration: Configuration) -> None:
        """``BadInput`` or ``MachineryFault`` where it cannot be started here, with what to do."""
        ...


@runtime_checkable
class Reached(Protocol):
    """An agent that is reached from outside: it may want the gateway at a port of its choice."""

    def port_of(self, configuration: Configuration) -> int:
        """The port; 0 for any that is free."""
        ...


PROGRAMS = {
    "codex": "c4s.agents.clients.codex:Codex",
    "claude_code": "c4s.agents.clients.claude_code:ClaudeCode",
    "gemini": "c4s.agents.clients.gemini:GeminiCLI",
    "opencode": "c4s.agents.clients.opencode:OpenCode",
    "hermes": "c4s.agents.clients.hermes:Hermes",
    "antigravity": "c4s.agents.clients.antigravity:Antigravity",
}
"""The clients that are programs of their own and must be installed, each an ``ExternalClient``."""
MODEL_CLIENTS = {
    "api": "c4s.agents.api.agent:ApiAgent",
    **PROGRAMS,
    "command": "c4s.agents.clients.command:CommandClient",
}
"""The clients that use a model, each a ``ModelClient``."""
CLIENTS = {
    "noop": "c4s.agents.baselines.noop:NoOp",
    "random": "c4s.agents.baselines.random:RandomAgent",
    "vandal": "c4s.agents.baselines.vandal:Vandal",
    "blind": "c4s.agents.baselines.blind.agent:Blind",
    "oracle": "c4s.agents.baselines.oracle:Oracle",
    "planner": "c4s.agents.baselines.planner:Planner",
    "replay": "c4s.agents.replay:Replay",
    "outside": "c4s.agents.outside:Outside",
    **dict.fromkeys(CHEATS, "c4s.agents.cheats.agent:Cheat"),
    **MODEL_CLIENTS,
}
"""c4s's own clients: name to ``module:class``; the class is made without arguments. Others join (``joining``)."""


def agent_of(configuration: Configuration) -> Agent:
    """The agent of a configuration. ``BadInput`` for an unknown client, and for one of another distribution that cannot
    be used."""
    if configuration.client in CLIENTS:
        module, _, name = CLIENTS[configuration.client].partition(":")
        made: Agent = getattr(importlib.import_module(module), name)()
        return made
    others = joined(CLIENTS)
    if configuration.client not in others:
        raise BadInput(
            f"unknown agent client {configuration.client!r}",
            where=configuration.name,
            todo=f"the clients are {', '.join([*CLIENTS, *others])}",
        )
    of_others: Agent = others[configuration.client].make()
    return of_others
