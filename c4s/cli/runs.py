"""The runs, by id or folder."""

from __future__ import annotations

import os
from pathlib import Path

from c4s.errors import unknown
from c4s.home import runs_root
from c4s.names import name_fault
from c4s.records.folder import RunFolder
from c4s.run.store import STORE, open_store


def run_folder(name: str) -> Path:
    """Folder of a run that has a plan; ``BadInput`` with those that are there for any other name."""
    if name and os.environ.get(STORE) and name_fault(name) == "":
        open_store().pull_files(RunFolder(runs_root() / name).plan)
    there = [folder.root.name for folder in RunFolder.planned(runs_root())]
    if name in there:
        return runs_root() / name
    if name and RunFolder(Path(name)).plan.is_file():
        return Path(name)
    raise unknown("run", name, there, where=str(runs_root()), todo="or give the folder of a run")
