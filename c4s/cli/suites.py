"""The built suites, by name."""

from __future__ import annotations

import os
from pathlib import Path

from c4s.errors import BadInput, unknown
from c4s.home import suites_root
from c4s.names import place_in
from c4s.records.suite import IMPORTED_SCENE, SuiteFolder
from c4s.run.store import STORE, share_suite


def built_suite(name: str) -> Path:
    """Folder of a built suite, fetched where machines share a store; ``BadInput`` with what is built for any other."""
    if os.environ.get(STORE):
        share_suite(name)
    built = [path.name for path in suites_root().glob("*") if SuiteFolder(path).record.is_file()]
    if name not in built:
        if name in (path.parent.name for path in suites_root().glob(f"*/{IMPORTED_SCENE}")):
            raise BadInput(
                f"{name!r} is an imported scene and no suite",
                where=str(suites_root() / name),
                todo=f"make cases of it with `c4s suite make-cases {name}`",
            )
        todo = "build one with `c4s suite build starter`"
        raise unknown("suite", name, built, where=str(suites_root()), todo="" if built else todo)
    folder = place_in(suites_root(), name, "suite")
    if (known := SuiteFolder(folder).suite().suite_id) != name:
        raise BadInput(f"this suite calls itself {known!r}", where=str(folder), todo="a folder has the id of its suite")
    return folder
