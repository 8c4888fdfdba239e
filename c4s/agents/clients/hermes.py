"""Hermes agent: one-shot mode, the tool server as its only toolset, no rules, no memory, one provider (the meter).

It is a Python program with a virtual environment of its own. It hands pictures of tools to its model as paths only.
"""

from __future__ import annotations

from typing import Any

from c4s.agents.briefing import SERVER
from c4s.agents.clients.client import TOOL_TIMEOUT_S, ExternalClient, Setup
from c4s.agents.clients.confined import HOME, Command
from c4s.agents.clients.programs import Install

CONTEXT_TOKENS = 200_000


class Hermes(ExternalClient):
    """The agent ``hermes``. Options: ``context_tokens``, ``effort`` (reasoning effort), ``max_turns``."""

    name = "hermes"
    install = Install("pypi", "hermes-agent[mcp]", "hermes")
    wire = "openai-chat"
    endpoint = "openrouter"

    def command(self, setup: Setup) -> Command:
        """See ``ExternalClient``. The configuration is JSON, which is YAML."""
        options = setup.options
        agent: dict[str, Any] = {"max_turns": int(options.get("max_turns", 1000))}
        if "effort" in options:
            agent["reasoning_effort"] = str(options["effort"])
        setup.write_json(
            ".hermes/config.yaml",
            {
                "model": {
                    "default": setup.model,
                    "provider": "custom",
                    "base_url": f"{setup.model_url}/v1",
                    "api_key": setup.model_token,
                    "context_length": int(options.get("context_tokens", CONTEXT_TOKENS)),
                },
                "agent": agent,
                "memory": {"memory_enabled": False, "user_profile_enabled": False},
                "checkpoints": {"enabled": False},
                "updates": {"check": False},
                "mcp_servers": {
                    SERVER: {
                        "url": setup.tools_url,
                        "timeout": TOOL_TIMEOUT_S,
                        "connect_timeout": 60,
                        "headers": {"Authorization": f"Bearer {setup.tools_token}"},
                    }
                },
            },
        )
        prompt = setup.prompt + "".join(f"\nReference picture: {picture}" for picture in setup.pictures)
        return Command(
            [
                str(setup.program.path),
                "-t",
                SERVER,
                "--ignore-rules",
                "-m",
                setup.model,
                "--usage-file",
                str(HOME / "usage.json"),
                "-z",
                prompt,
            ],
            {
                "HERMES_HOME": str(HOME / ".hermes"),
                "OPENAI_API_KEY": setup.model_token,
                "OPENAI_BASE_URL": f"{setup.model_url}/v1",
                "NO_COLOR": "1",
            },
            setup.program.read_only,
        )
