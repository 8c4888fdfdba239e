"""Saves the start scene as it is: the floor of image-to-scene, and an empty level in text-to-scene."""

from __future__ import annotations

from c4s.agents.base import SUBMISSION_NAME, AgentContext, AgentReport


class NoOp:
    """The agent ``noop``."""

    def run(self, context: AgentContext) -> AgentReport:
        """Save and stop."""
        with context.connect() as tools:
            tools.call("save_scene_as", name=SUBMISSION_NAME)
        return AgentReport(client_version="noop 1")
