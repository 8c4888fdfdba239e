"""Chance: random assets in text-to-scene, random edits in image-to-scene. Seeded by the case id and the attempt.

Options: ``count``, how many assets or edits (default 40 and 8).
"""

from __future__ import annotations

import random
from typing import Any

from c4s.agents.base import SUBMISSION_NAME, AgentContext, AgentReport
from c4s.errors import AgentFault
from c4s.protocol.settings import is_construction
from c4s.toolbox.client import CallRefused, GatewayClient

PLACED, EDITED = 40, 8
EDGE_SHARE = 0.45
STEP_CM = 150.0
RESERVED_CALLS = 3


class RandomAgent:
    """The agent ``random``."""

    def run(self, context: AgentContext) -> AgentReport:
        """Place or edit at random, then save."""
        chance = random.Random(f"{context.case.alias}/{context.attempt}")
        refused: list[str] = []
        with context.connect() as tools:
            if is_construction(context.case.setting):
                self._place(context, tools, chance, refused)
            else:
                self._edit(context, tools, chance, refused)
            tools.call("save_scene_as", name=SUBMISSION_NAME)
        return AgentReport(client_version="random 1", message="; ".join(refused))

    def _place(self, context: AgentContext, tools: GatewayClient, chance: random.Random, refused: list[str]) -> None:
        """Catalog assets at random places of the plate, standing on the ground plane."""
        reach = (context.case.plate_m or 100.0) * 100 * EDGE_SHARE
        paths = chance.sample(sorted(context.case.catalog), min(len(context.case.catalog), 20))
        if not paths:
            raise AgentFault("the case has an empty catalog", where=context.case.alias)
        assets: list[dict[str, Any]] = tools.call("get_asset_metadata", ids=paths).data["assets"]
        count = min(int(context.options.get("count", PLACED)), _calls_for_edits(context))
        for number in range(count):
            asset = chance.choice(assets)
            location = [chance.uniform(-reach, reach), chance.uniform(-reach, reach), -asset["bounds_min_cm"][2]]
            rotation = [0.0, chance.uniform(-180, 180), 0.0]
            label, path = f"Random_{number:03d}", asset["spawn_path"]
            if asset["spawn_with"] == "spawn_actor":
                _try(tools, refused, "spawn_actor", name=label, static_mesh=path, location=location, rotation=rotation)
            else:
                _try(
                    tools,
                    refused,
                    "spawn_blueprint_actor",
                    actor_name=label,
                    blueprint_id=path,
                    location=location,
                    rotation=rotation,
                )

    def _edit(self, context: AgentContext, tools: GatewayClient, chance: random.Random, refused: list[str]) -> None:
        """Move, turn, scale or delete random actors that have a mesh."""
        actors = sorted(
            (actor for actor in tools.actors() if actor["static_meshes"]), key=lambda actor: str(actor["name"])
        )
        count = min(int(context.options.get("count", EDITED)), _calls_for_edits(context), len(actors))
        for actor in chance.sample(actors, count):
            name, kind = actor["name"], chance.choice(("move", "turn", "scale", "delete"))
            if kind == "move":
                moved = [value + chance.uniform(-STEP_CM, STEP_CM) for value in actor["location"][:2]]
                _try(tools, refused, "set_actor_transform", name=name, location=[*moved, actor["location"][2]])
            elif kind == "turn":
                pitch, _, roll = actor["rotation"]
                _try(
                    tools, refused, "set_actor_transform", name=name, rotation=[pitch, chance.uniform(-180, 180), roll]
                )
            elif kind == "scale":
                factor = chance.uniform(0.5, 1.5)
                _try(
                    tools, refused, "set_actor_transform", name=name, scale=[value * factor for value in actor["scale"]]
                )
            else:
                _try(tools, refused, "delete_actor", name=name)


def _calls_for_edits(context: AgentContext) -> int:
    return max(0, context.case.budget.tool_calls - RESERVED_CALLS)


def _try(tools: GatewayClient, refused: list[str], tool: str, /, **arguments: Any) -> None:
    """A call that may be refused (an ambiguous name, say): noted, and the agent goes on."""
    try:
        tools.call(tool, **arguments)
    except CallRefused as refusal:
        refused.append(refusal.line())
