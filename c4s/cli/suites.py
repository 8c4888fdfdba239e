"""The built suites, by name."""

from __future__ import annotations

from pathlib import Path

from c4s.errors import BadInput
from c4s.home import suites_root
from c4s.records.suite import SuiteFolder


def built_suite(name: str) -> Path:
    """Folder of a built suite; ``BadInput`` with those that are built for any other name."""
    folder = suites_root() / name
    if not SuiteFolder(folder).record.is_file():
        built = sorted(path.name for path in suites_root().glob("*") if SuiteFolder(path).record.is_file())
        raise BadInput(
            f"unknown suite {name!r}",
            where=str(suites_root()),
            todo=f"built here: {', '.join(built)}" if built else "build one with `c4s suite build starter`",
        )
    return folder
