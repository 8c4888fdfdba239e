"""Baseline ``blind``: it reads the level with a script, guesses what was changed, and never looks at a picture."""

from __future__ import annotations

import base64
import json
import zlib
from dataclasses import asdict
from typing import Any

from c4s.agents.base import SUBMISSION_NAME, AgentContext, AgentReport
from c4s.agents.baselines.blind.guess import chosen
from c4s.agents.baselines.blind.scene import SeenActor, SeenLevel
from c4s.agents.baselines.blind.scripts import READ, REPAIR, SHOW
from c4s.agents.baselines.blind.tricks import guesses
from c4s.agents.baselines.scripting import run_script
from c4s.protocol.settings import is_construction
from c4s.toolbox.client import GatewayClient

PART = 12_000
"""Characters that one call prints."""


class Blind:
    """The agent ``blind``. It validates a suite: what it reaches is what can be had without sight."""

    def run(self, context: AgentContext) -> AgentReport:
        """Guess repairs, make them and save; an empty scene where there is nothing to repair."""
        message = ""
        with context.connect() as tools:
            if not is_construction(context.case.setting):
                made = chosen([guess for of in guesses(_read(tools)).values() for guess in of])
                run_script(tools, f"GUESSES = {json.dumps([asdict(guess) for guess in made])!r}\n{REPAIR}")
                message = "; ".join(f"{guess.actor}: {guess.edit}, {guess.trick}" for guess in made)
            tools.call("save_scene_as", name=SUBMISSION_NAME)
        return AgentReport(client_version="blind 1", message=message)


def _read(tools: GatewayClient) -> SeenLevel:
    """The level as a script tells it, part by part."""
    size = int(run_script(tools, READ))
    text = "".join(run_script(tools, SHOW.format(start=at, end=at + PART)) for at in range(0, size, PART))
    told: dict[str, Any] = json.loads(zlib.decompress(base64.b64decode(text)))
    return SeenLevel(told["package"], tuple(_thing(row, order) for order, row in enumerate(told["actors"])))


def _thing(row: dict[str, Any], order: int) -> SeenActor:
    lists = {name: tuple(row[name]) for name in ("component", "location", "rotation", "scale", "low", "high")}
    lists["materials"] = tuple((slot, path) for slot, path in row["materials"])
    return SeenActor(**row | lists | {"tags": frozenset(row["tags"]), "order": order})
