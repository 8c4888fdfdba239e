"""The benchmark's own agent loop for OpenAI-compatible endpoints: what it is told before it plays."""

from __future__ import annotations

from c4s.agents.api.options import ApiOptions
from c4s.agents.base import AgentContext, AgentReport
from c4s.chat.replicas import WIRE
from c4s.records.plan import Configuration


class ApiAgent:
    """The agent ``api``. Options: see ``ApiOptions``."""

    endpoint = "openrouter"

    def wire_of(self, configuration: Configuration) -> str:
        """Chat completions."""
        return WIRE

    def ready(self, configuration: Configuration) -> None:
        """``BadInput`` for options that cannot be used."""
        ApiOptions.of(configuration)

    def run(self, context: AgentContext) -> AgentReport:
        """Play one case."""
        from c4s.agents.api.playing import play

        return play(context)
