"""Codex CLI: ``codex exec``, one model provider (the meter, responses), one MCP server, own shell and file tools off.

The client's bundled description of a model can replace its tools by a script runner or a tool search. The adapter hands
it a catalog with the one model, whose tools are plain.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

from c4s.agents.briefing import SERVER
from c4s.agents.clients import confined
from c4s.agents.clients.client import ANSWER_BYTES, TOOL_TIMEOUT_S, ExternalClient, Setup
from c4s.agents.clients.confined import Command
from c4s.agents.clients.programs import Install
from c4s.errors import MachineryFault

OFF = (
    "shell_tool",
    "unified_exec",
    "view_image",
    "apps",
    "plugins",
    "multi_agent",
    "hooks",
    "image_generation",
    "browser_use",
    "browser_use_external",
    "computer_use",
    "in_app_browser",
    "code_mode_host",
    "goals",
    "sleep_tool",
    "skill_search",
    "tool_suggest",
    "request_permissions_tool",
    "shell_snapshot",
    "remote_plugin",
    "skill_mcp_dependency_install",
    "enable_request_compression",
)
"""Features that give the model tools of its own, and request compression, which would hide requests from the meter."""
PLAIN_TOOLS: dict[str, Any] = {
    "shell_type": "disabled",
    "apply_patch_tool_type": None,
    "tool_mode": None,
    "supports_search_tool": False,
    "experimental_supported_tools": [],
    "use_responses_lite": False,
    "multi_agent_version": None,
    "node_repl_disabled": True,
    "upgrade": None,
    "availability_nux": None,
    "visibility": "list",
}
OWN_INSTRUCTIONS = "You are a coding agent. Work on the user's task with the tools that you are given until it is done."
CONTEXT_TOKENS = 200_000
BYTES_A_TOKEN = 4
"""As the client counts them."""


class Codex(ExternalClient):
    """The agent ``codex``. Options: ``effort`` (reasoning effort), ``context_tokens`` for a model it does not know."""

    name = "codex"
    install = Install("npm", "@openai/codex", "codex")
    wire = "openai-responses"
    endpoint = "openai"

    def command(self, setup: Setup) -> Command:
        """See ``ExternalClient``."""
        catalog = setup.write_json(".codex/models.json", {"models": [_entry(setup)]})
        values: dict[str, Any] = {
            "model": setup.model,
            "model_provider": SERVER,
            "model_catalog_json": catalog,
            "approval_policy": "never",
            "sandbox_mode": "read-only",
            "web_search": "disabled",
            "tool_output_token_limit": ANSWER_BYTES // BYTES_A_TOKEN,
            "check_for_update_on_startup": False,
            "analytics.enabled": False,
            "history.persistence": "none",
            f"model_providers.{SERVER}.name": SERVER,
            f"model_providers.{SERVER}.base_url": f"{setup.model_url}/v1",
            f"model_providers.{SERVER}.env_key": "C4S_MODEL_TOKEN",
            f"model_providers.{SERVER}.wire_api": "responses",
            f"mcp_servers.{SERVER}.url": setup.tools_url,
            f"mcp_servers.{SERVER}.bearer_token_env_var": "C4S_TOOLS_TOKEN",
            f"mcp_servers.{SERVER}.required": True,
            f"mcp_servers.{SERVER}.default_tools_approval_mode": "approve",
            f"mcp_servers.{SERVER}.tool_timeout_sec": TOOL_TIMEOUT_S,
            **{f"features.{feature}": False for feature in OFF},
        }
        if "effort" in setup.options:
            values["model_reasoning_effort"] = str(setup.options["effort"])
        setup.write(".codex/config.toml", "".join(f"{key} = {json.dumps(value)}\n" for key, value in values.items()))
        arguments = [str(setup.program.path), "exec", "--json", "--skip-git-repo-check", "--ephemeral"]
        for picture in setup.pictures:
            arguments += ["--image", picture]
        return Command(
            [*arguments, "-"],
            {
                "CODEX_HOME": str(confined.HOME / ".codex"),
                "C4S_MODEL_TOKEN": setup.model_token,
                "C4S_TOOLS_TOKEN": setup.tools_token,
            },
            setup.program.read_only,
            setup.prompt.encode(),
        )

    def closing(self, lines: Iterator[Mapping[str, Any]]) -> str:
        """The last message, or the error."""
        said = ""
        for line in lines:
            item = line.get("item")
            if isinstance(item, dict) and item.get("type") == "agent_message":
                said = str(item.get("text", ""))
            elif line.get("type") in ("error", "turn.failed"):
                said = str(line.get("message") or line.get("error"))
        return said


def _entry(setup: Setup) -> dict[str, Any]:
    """The client's own description of the model with plain tools; for a model it does not know, one made from another.

    Raises ``MachineryFault`` when the client cannot print its catalog.
    """
    out = setup.home.parent / "codex-models"
    confined.run(
        Command([str(setup.program.path), "debug", "models"], {"CODEX_HOME": "/tmp"}, setup.program.read_only),
        setup.home,
        out,
    )
    try:
        models = json.loads(out.with_suffix(".stdout").read_text())["models"]
        known = {str(model["slug"]): model for model in models}
    except (ValueError, KeyError, TypeError) as error:
        raise MachineryFault(f"codex does not tell its models: {error!r}", where=str(out)) from None
    entry = known.get(setup.model)
    if entry is None:
        tokens = int(setup.options.get("context_tokens", CONTEXT_TOKENS))
        entry = {
            **models[0],
            "slug": setup.model,
            "display_name": setup.model,
            "description": "",
            "base_instructions": OWN_INSTRUCTIONS,
            "model_messages": None,
            "context_window": tokens,
            "max_context_window": tokens,
        }
    return {**entry, **PLAIN_TOOLS}
