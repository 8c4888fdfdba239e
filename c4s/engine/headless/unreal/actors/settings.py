"""The settings of a level."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from c4s.engine.headless.unreal.actors.base import Info
from c4s.engine.headless.unreal.core import Prop, public

NOTHING_BELOW_CM = -1048575.0
"""Unreal's default height below which actors are taken away in play."""


@public
class WorldSettings(Info):
    """How a level plays. The values hold while the level is open; nothing is played here, and they are not saved."""

    _declares = {
        "kill_z": Prop("float", NOTHING_BELOW_CM),
        "global_gravity_set": Prop("bool", False),
        "global_gravity_z": Prop("float", 0.0),
        "world_to_meters": Prop("float", 100.0),
    }

    @classmethod
    def _abstract(cls) -> bool:
        return True
