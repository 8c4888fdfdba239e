"""How a client that is started by hand is told of a gateway: a command line, or a text for a file of its own."""

from __future__ import annotations

import json
import shlex
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from c4s.agents.briefing import SERVER

TOKEN_VARIABLE = "C4S_TOKEN"


@dataclass(frozen=True)
class Way:
    """One client: a command to run once (with variables that the client needs later too), or what stands in a file."""

    client: str
    command: Sequence[str] = ()
    environment: Mapping[str, str] = field(default_factory=dict)
    file: str = ""
    text: str = ""

    def lines(self) -> list[str]:
        """It, for people: lines for a shell, or the file and what stands in it."""
        if self.command:
            exports = [f"export {name}={shlex.quote(value)}" for name, value in self.environment.items()]
            return [*exports, shlex.join(self.command)]
        return [f"in {self.file}:", *self.text.splitlines()]

    def plain(self) -> dict[str, Any]:
        """It, as JSON data."""
        given = {"command": list(self.command), "environment": dict(self.environment)} if self.command else {}
        return given or {"file": self.file, "text": self.text}


def ways(url: str, token: str) -> list[Way]:
    """How each known client is told of the tool server at an address."""
    header = f"Authorization: Bearer {token}"
    headers = {"Authorization": f"Bearer {token}"}
    return [
        Way("Claude Code", ["claude", "mcp", "add", "--transport", "http", SERVER, url, "--header", header]),
        Way(
            "Codex",
            ["codex", "mcp", "add", SERVER, "--url", url, "--bearer-token-env-var", TOKEN_VARIABLE],
            {TOKEN_VARIABLE: token},
        ),
        Way("Gemini CLI", ["gemini", "mcp", "add", "--transport", "http", "--header", header, SERVER, url]),
        Way(
            "opencode",
            file="opencode.json",
            text=_text({"mcp": {SERVER: {"type": "remote", "url": url, "oauth": False, "headers": headers}}}),
        ),
        Way(
            "Hermes",
            file="~/.hermes/config.yaml",
            text=f"mcp_servers:\n  {SERVER}:\n    url: {url}\n    headers:\n      Authorization: Bearer {token}\n",
        ),
        Way(
            "any other",
            file="its file of MCP servers, as most clients have it",
            text=_text({"mcpServers": {SERVER: {"type": "http", "url": url, "headers": headers}}}),
        ),
        Way(
            "any that sends no headers",
            file="its file of MCP servers",
            text=_text({"mcpServers": {SERVER: {"type": "http", "url": f"{url}/{token}"}}}),
        ),
    ]


def _text(value: Any) -> str:
    return json.dumps(value, indent=2)
