"""Claude Code: headless print mode, one MCP server, no built-in tool, no settings of the machine, no session kept."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from c4s.agents.briefing import SERVER
from c4s.agents.clients.client import ANSWER_BYTES, TOOL_TIMEOUT_S, ExternalClient, Setup
from c4s.agents.clients.confined import Command
from c4s.agents.clients.programs import Install


class ClaudeCode(ExternalClient):
    """The agent ``claude_code``. Options: ``effort`` (low to max), ``thinking_tokens``."""

    name = "claude_code"
    install = Install("npm", "@anthropic-ai/claude-code", "claude")
    wire = "anthropic"
    endpoint = "anthropic"

    def command(self, setup: Setup) -> Command:
        """See ``ExternalClient``. All model roles of the client are the configuration's model."""
        servers = setup.write_json(
            "mcp.json",
            {
                "mcpServers": {
                    SERVER: {
                        "type": "http",
                        "url": setup.tools_url,
                        "headers": {"Authorization": f"Bearer {setup.tools_token}"},
                    }
                }
            },
        )
        arguments = [
            str(setup.program.path),
            "-p",
            "--input-format",
            "stream-json",
            "--output-format",
            "stream-json",
            "--verbose",
            "--model",
            setup.model,
            "--mcp-config",
            servers,
            "--strict-mcp-config",
            "--tools",
            "",
            "--allowedTools",
            f"mcp__{SERVER}",
            "--permission-mode",
            "dontAsk",
            "--setting-sources",
            "",
            "--no-session-persistence",
        ]
        if "effort" in setup.options:
            arguments += ["--effort", str(setup.options["effort"])]
        roles = {
            f"ANTHROPIC_{role}": setup.model
            for role in (
                "MODEL",
                "SMALL_FAST_MODEL",
                "DEFAULT_HAIKU_MODEL",
                "DEFAULT_SONNET_MODEL",
                "DEFAULT_OPUS_MODEL",
            )
        }
        thinking = (
            {"MAX_THINKING_TOKENS": str(setup.options["thinking_tokens"])} if "thinking_tokens" in setup.options else {}
        )
        return Command(
            arguments,
            {
                **roles,
                **thinking,
                "ANTHROPIC_BASE_URL": setup.model_url,
                "ANTHROPIC_API_KEY": setup.model_token,
                "CLAUDE_CONFIG_DIR": str(setup.options.get("config_dir", "/home/agent/.claude")),
                "ENABLE_TOOL_SEARCH": "false",
                "CLAUDE_CODE_DISABLE_NONESSENTIAL_TRAFFIC": "1",
                "DISABLE_AUTOUPDATER": "1",
                "DISABLE_TELEMETRY": "1",
                "DISABLE_ERROR_REPORTING": "1",
                "MAX_MCP_OUTPUT_TOKENS": str(ANSWER_BYTES),
                "MCP_TIMEOUT": "60000",
                "MCP_TOOL_TIMEOUT": str(TOOL_TIMEOUT_S * 1000),
                "CLAUDE_CODE_SUBAGENT_MODEL": setup.model,
            },
            setup.program.read_only,
            _message(setup).encode(),
        )

    def closing(self, lines: Iterator[Mapping[str, Any]]) -> str:
        """The text of the ``result`` event."""
        return next(
            (str(line.get("result") or line.get("subtype")) for line in lines if line.get("type") == "result"), ""
        )


def _message(setup: Setup) -> str:
    """The prompt and the pictures as one user message on standard input."""
    blocks: list[dict[str, Any]] = [{"type": "text", "text": setup.prompt}]
    for picture in setup.pictures:
        data = base64.b64encode((setup.home / Path(picture).name).read_bytes()).decode()
        blocks.append({"type": "image", "source": {"type": "base64", "media_type": "image/png", "data": data}})
    return json.dumps({"type": "user", "message": {"role": "user", "content": blocks}}) + "\n"
