"""Antigravity CLI (``agy``), as a command: it has no registry package, and is installed by its vendor's installer.

It takes its tool server from ``~/.gemini/config/mcp_config.json``. Signing in through a browser is impossible in the
sandbox: the model is reached with the meter's token in place of an API key.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

from c4s.agents.clients.command import CommandClient
from c4s.files import canonical_json


class Antigravity(CommandClient):
    """The agent ``antigravity``; every option of ``command`` overrides what stands here."""

    name = "antigravity"
    wire = "gemini"
    endpoint = "gemini"
    defaults: ClassVar[Mapping[str, Any]] = {
        "wire": "gemini",
        "command": ["agy", "-p", "{prompt}", "--model", "{model}", "--output-format", "stream-json"],
        "environment": {"GEMINI_API_KEY": "{model_token}", "GOOGLE_GEMINI_BASE_URL": "{model_url}"},
        "files": {
            ".gemini/config/mcp_config.json": canonical_json(
                {
                    "mcpServers": {
                        "c4s": {
                            "serverUrl": "{tools_url}",
                            "httpUrl": "{tools_url}",
                            "headers": {"Authorization": "Bearer {tools_token}"},
                        }
                    }
                }
            )
        },
        "install": "install Antigravity from its vendor, then give its program in `options.command`",
    }
