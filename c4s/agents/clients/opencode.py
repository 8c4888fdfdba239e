"""opencode: one provider (the meter, chat completions), one MCP server, every other tool off, no sharing or updates."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from c4s.agents.briefing import SERVER
from c4s.agents.clients.client import ANSWER_BYTES, TOOL_TIMEOUT_S, ExternalClient, Setup
from c4s.agents.clients.confined import Command
from c4s.agents.clients.programs import Install

CONTEXT_TOKENS, OUTPUT_TOKENS = 200_000, 32_000


class OpenCode(ExternalClient):
    """The agent ``opencode``. Options: ``variant`` (reasoning effort), ``context_tokens``, ``output_tokens``,
    ``model_options`` (of the provider's model)."""

    name = "opencode"
    install = Install("npm", "opencode-ai", "opencode")
    wire = "openai-chat"
    endpoint = "openrouter"

    def command(self, setup: Setup) -> Command:
        """See ``ExternalClient``. The small model, for titles, is the configuration's model too."""
        options = setup.options
        model = {
            "name": setup.model,
            "attachment": True,
            "tool_call": True,
            "modalities": {"input": ["text", "image"], "output": ["text"]},
            "limit": {
                "context": int(options.get("context_tokens", CONTEXT_TOKENS)),
                "output": int(options.get("output_tokens", OUTPUT_TOKENS)),
            },
            "options": options.get("model_options", {}),
        }
        setup.write_json(
            ".config/opencode/opencode.json",
            {
                "$schema": "https://opencode.ai/config.json",
                "autoupdate": False,
                "share": "disabled",
                "snapshot": False,
                "model": f"{SERVER}/{setup.model}",
                "small_model": f"{SERVER}/{setup.model}",
                "enabled_providers": [SERVER],
                "tool_output": {"max_bytes": ANSWER_BYTES, "max_lines": ANSWER_BYTES},
                "tools": {"*": False, f"{SERVER}*": True},
                "permission": {"*": "deny", f"{SERVER}*": "allow"},
                "provider": {
                    SERVER: {
                        "npm": "@ai-sdk/openai-compatible",
                        "name": SERVER,
                        "models": {setup.model: model},
                        "options": {
                            "baseURL": f"{setup.model_url}/v1",
                            "apiKey": setup.model_token,
                            "includeUsage": True,
                        },
                    }
                },
                "mcp": {
                    SERVER: {
                        "type": "remote",
                        "url": setup.tools_url,
                        "enabled": True,
                        "oauth": False,
                        "timeout": TOOL_TIMEOUT_S * 1000,
                        "headers": {"Authorization": f"Bearer {setup.tools_token}"},
                    }
                },
            },
        )
        arguments = [str(setup.program.path), "run", "--pure", "--format", "json", "--model", f"{SERVER}/{setup.model}"]
        if "variant" in options:
            arguments += ["--variant", str(options["variant"])]
        for picture in setup.pictures:
            arguments += ["--file", picture]
        return Command(
            arguments,
            {
                "OPENCODE_DISABLE_AUTOUPDATE": "1",
                "OPENCODE_DISABLE_MODELS_FETCH": "1",
                "OPENCODE_DISABLE_SHARE": "1",
                "OPENCODE_DISABLE_LSP_DOWNLOAD": "1",
                "OPENCODE_DISABLE_DEFAULT_PLUGINS": "1",
            },
            setup.program.read_only,
            setup.prompt.encode(),
        )

    def closing(self, lines: Iterator[Mapping[str, Any]]) -> str:
        """The last text, or the error."""
        said = ""
        for line in lines:
            if line.get("type") == "error":
                return str(line.get("error"))
            part = line.get("part")
            if line.get("type") == "text" and isinstance(part, dict):
                said = str(part.get("text", ""))
        return said
