"""Builds the layout of a cheat by one Unreal Python script, as any agent could."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from typing import Final

from c4s.agents.base import SUBMISSION_NAME, AgentContext, AgentReport
from c4s.agents.baselines.scripting import run_script
from c4s.agents.cheats.layouts import LAYOUTS, MOST, CatalogItem, Placing
from c4s.errors import AgentFault
from c4s.protocol.settings import is_construction
from c4s.toolbox.client import GatewayClient

PLATE_M: Final = 100.0
EDGE_SHARE: Final = 0.95
BATCH: Final = 40
SCRIPT: Final = """
import json, unreal
editor = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
for one in json.loads({placings!r}):
    at = unreal.Vector(*one["location"])
    path = one["item"]["path"]
    if one["item"]["blueprint"]:
        actor = editor.spawn_actor_from_class(unreal.EditorAssetLibrary.load_blueprint_class(path), at)
    else:
        actor = editor.spawn_actor_from_object(unreal.load_asset(path), at)
    actor.set_actor_scale3d(unreal.Vector(one["scale"], one["scale"], one["scale"]))
    if one["label"]:
        actor.set_actor_label(one["label"])
    if one["hidden"]:
        actor.set_actor_hidden_in_game(True)
        actor.set_is_temporarily_hidden_in_editor(True)
    if not one["collision"]:
        actor.set_actor_enable_collision(False)
"""


class Cheat:
    """An agent of ``c4s.agents.cheats.layouts``; its client's name says which."""

    def run(self, context: AgentContext) -> AgentReport:
        """Build the layout and save; a repair is saved as it is."""
        name = context.configuration.client
        with context.connect() as tools:
            count = 0
            if is_construction(context.case.setting):
                items = _catalog(tools, sorted(context.case.catalog))
                if not items:
                    raise AgentFault("the case has an empty catalog", where=context.case.alias)
                reach = (context.case.plate_m or PLATE_M) * 50 * EDGE_SHARE
                placings = LAYOUTS[name](items, context.case.prompt, reach)[:MOST]
                _build(tools, placings)
                count = len(placings)
            tools.call("save_scene_as", name=SUBMISSION_NAME)
        return AgentReport(client_version=f"{name} 1", message=f"{count} things")


def _catalog(tools: GatewayClient, paths: Sequence[str]) -> list[CatalogItem]:
    found = []
    for first in range(0, len(paths), BATCH):
        rows = tools.call("get_asset_metadata", ids=list(paths[first : first + BATCH])).data["assets"]
        found += [CatalogItem.of(row) for row in rows]
    return found


def _build(tools: GatewayClient, placings: Sequence[Placing]) -> None:
    run_script(tools, SCRIPT.format(placings=json.dumps([asdict(placing) for placing in placings])))
