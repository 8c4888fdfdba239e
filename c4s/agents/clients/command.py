"""Any other MCP client: its command line, files and environment come from the configuration.

Texts of ``command``, ``environment`` and ``files`` may hold ``{prompt}``, ``{model}``, ``{model_url}``,
``{model_token}``, ``{tools_url}``, ``{tools_token}`` and ``{mcp_file}`` (a JSON file with the tool server as most
clients read it). The prompt is also the client's standard input.
"""

from __future__ import annotations

import re
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any, ClassVar

from c4s.agents.briefing import SERVER
from c4s.agents.clients.client import ExternalClient, Setup
from c4s.agents.clients.confined import Command
from c4s.agents.clients.programs import Program
from c4s.errors import BadInput
from c4s.meter.wire import BY_NAME
from c4s.records.plan import Configuration

_PLACE = re.compile(r"\{(\w+)\}")


class CommandClient(ExternalClient):
    """The agent ``command``. Options: ``command`` (list), ``environment``, ``files`` (path under HOME to text),
    ``read_only`` (host paths it must read), ``wire``, ``version``."""

    name = "command"
    wire = "openai-chat"
    endpoint = "openrouter"
    defaults: ClassVar[Mapping[str, Any]] = {}

    def _options(self, options: Mapping[str, Any]) -> dict[str, Any]:
        return {**self.defaults, **options}

    def wire_of(self, configuration: Configuration) -> str:
        """The option ``wire``."""
        wire = str(self._options(configuration.options).get("wire", self.wire))
        if wire not in BY_NAME:
            raise BadInput(
                f"option wire is {wire!r}", where=configuration.name, todo=f"use one of {', '.join(BY_NAME)}"
            )
        return wire

    def program(self, options: Mapping[str, Any]) -> Program:
        """The first word of the command, as a path or on the search path."""
        given = self._options(options)
        command = given.get("command")
        if not isinstance(command, list) or not command or not all(isinstance(word, str) for word in command):
            raise BadInput(f"the agent {self.name!r} needs its command line", todo="add `options: {command: [...]}`")
        found = shutil.which(command[0])
        if found is None:
            raise BadInput(
                f"the client {command[0]!r} is not installed",
                todo=str(given.get("install", "install it, or give the full path of its program in `options.command`")),
            )
        path = Path(found).absolute()
        extra = tuple(Path(place).absolute() for place in given.get("read_only", ()))
        missing = next((place for place in extra if not place.exists()), None)
        if missing is not None:
            raise BadInput(f"option read_only names {missing}, which is not there")
        own = () if path.resolve().is_relative_to("/usr") else (path.resolve(), path)
        return Program(path, str(given.get("version", "")), tuple(dict.fromkeys((*own, *extra))))

    def command(self, setup: Setup) -> Command:
        """See ``ExternalClient``."""
        options = self._options(setup.options)
        values = {
            "prompt": setup.prompt,
            "model": setup.model,
            "model_url": setup.model_url,
            "model_token": setup.model_token,
            "tools_url": setup.tools_url,
            "tools_token": setup.tools_token,
        }
        values["mcp_file"] = setup.write_json(
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

        def filled(text: Any) -> str:
            return _PLACE.sub(lambda place: values.get(place[1], place[0]), str(text))

        for name, text in options.get("files", {}).items():
            if Path(name).is_absolute() or ".." in Path(name).parts:
                raise BadInput(f"option files names {name!r}, which is not under HOME")
            setup.write(name, filled(text))
        return Command(
            [str(setup.program.path), *map(filled, options["command"][1:])],
            {name: filled(value) for name, value in options.get("environment", {}).items()},
            setup.program.read_only,
            setup.prompt.encode(),
        )
