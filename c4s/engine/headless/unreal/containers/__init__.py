"""Name, Text and the containers: Unreal's own types, which are not Python's ``str``, ``list``, ``dict`` and ``set``."""

from __future__ import annotations

from c4s.engine.headless.unreal.containers.arrays import Array, FixedArray
from c4s.engine.headless.unreal.containers.maps import Map
from c4s.engine.headless.unreal.containers.sets import Set
from c4s.engine.headless.unreal.containers.words import Name, Text

__all__ = ["Array", "FixedArray", "Map", "Name", "Set", "Text"]
