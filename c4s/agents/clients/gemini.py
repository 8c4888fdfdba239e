"""Gemini CLI: headless, one MCP server; a policy that denies every tool and allows the server's."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from c4s.agents.briefing import SERVER
from c4s.agents.clients.client import ANSWER_BYTES, TOOL_TIMEOUT_S, ExternalClient, Setup
from c4s.agents.clients.confined import Command
from c4s.agents.clients.programs import Install

POLICY = f"""\
[[rule]]
toolName = "*"
decision = "deny"
priority = 900

[[rule]]
mcpName = "{SERVER}"
toolName = "*"
decision = "allow"
priority = 950
"""


class GeminiCLI(ExternalClient):
    """The agent ``gemini``. Option: ``settings``, further settings of the client."""

    name = "gemini"
    install = Install("npm", "@google/gemini-cli", "gemini")
    wire = "gemini"
    endpoint = "gemini"

    def command(self, setup: Setup) -> Command:
        """See ``ExternalClient``. Pictures go in by the client's own ``@file``."""
        settings: dict[str, Any] = {
            "security": {"auth": {"selectedType": "gemini-api-key"}, "folderTrust": {"enabled": False}},
            "general": {"disableAutoUpdate": True, "disableUpdateNag": True, "enableAutoUpdate": False},
            "privacy": {"usageStatisticsEnabled": False},
            "telemetry": {"enabled": False},
            "tools": {"truncateToolOutputThreshold": ANSWER_BYTES},
            "mcpServers": {
                SERVER: {
                    "httpUrl": setup.tools_url,
                    "timeout": TOOL_TIMEOUT_S * 1000,
                    "trust": True,
                    "headers": {"Authorization": f"Bearer {setup.tools_token}"},
                }
            },
            **setup.options.get("settings", {}),
        }
        setup.write_json(".gemini/settings.json", settings)
        policy = setup.write("policy.toml", POLICY)
        prompt = setup.prompt + "".join(f"\n@{picture}" for picture in setup.pictures)
        return Command(
            [
                str(setup.program.path),
                "-m",
                setup.model,
                "-p",
                prompt,
                "--output-format",
                "stream-json",
                "--policy",
                policy,
                "--allowed-mcp-server-names",
                SERVER,
                "--skip-trust",
            ],
            {
                "GOOGLE_GEMINI_BASE_URL": setup.model_url,
                "GEMINI_API_KEY": setup.model_token,
                "GEMINI_CLI_TRUST_WORKSPACE": "true",
                "NO_COLOR": "1",
                "GEMINI_TELEMETRY_ENABLED": "false",
            },
            setup.program.read_only,
        )

    def closing(self, lines: Iterator[Mapping[str, Any]]) -> str:
        """The assistant's last words, or the error."""
        said, failed = "", ""
        for line in lines:
            if line.get("type") == "message" and line.get("role") == "assistant":
                said = said + str(line.get("content", "")) if line.get("delta") else str(line.get("content", ""))
            elif line.get("type") == "tool_use":
                said = ""
            elif line.get("type") == "error" or line.get("error"):
                failed = str(line.get("error") or line.get("message"))
        return failed or said
