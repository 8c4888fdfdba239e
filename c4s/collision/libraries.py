"""The two libraries of collision, each loaded when something of it is first named.

Most engines ask nothing of them, and loading them takes as long as loading NumPy.
"""

from __future__ import annotations

import importlib
from typing import Any


class _Later:
    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, attribute: str) -> Any:
        found = getattr(importlib.import_module(self._name), attribute)
        setattr(self, attribute, found)
        return found


coal: Any = _Later("coal")
fcl: Any = _Later("fcl")
