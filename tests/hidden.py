"""Processes in which packages are not there, as if they had never been installed."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import Final

_HIDING: Final = """
import sys
class Hidden:
    names = frozenset({names})
    @classmethod
    def find_spec(cls, name, path=None, target=None):
        if name in cls.names or name.partition(".")[0] in cls.names:
            raise ModuleNotFoundError(f"No module named {{name!r}}", name=name)
sys.meta_path.insert(0, Hidden)
"""


def hiding(folder: Path, names: Iterable[str]) -> dict[str, str]:
    """The environment of a Python that has none of the named modules, nor have the processes that it starts.

    ``folder`` gets the file that hides them.
    """
    (folder / "sitecustomize.py").write_text(_HIDING.format(names=sorted(names)))
    return {**os.environ, "PYTHONPATH": str(folder)}
