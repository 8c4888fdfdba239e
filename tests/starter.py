"""The starter suite as it ships, built once a checkout."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from c4s.packs.suite_check import suite_changes
from c4s.records.pack import Pack
from c4s.records.suite import PackRef, SuiteFolder
from cases.definition import definition_digest
from cases.stamp import STAMP
from cases.starter.suite import SUITE_ID, build_starter, definition
from catalog.starter import STARTER
from tests.house.tree import ROOT


def starter_home(scratch: Path) -> Path:
    """The home that ``make demo`` filled, where its suite is the one that the sources say and no file was changed; else
    one that is built now, below ``scratch``. It is for reading."""
    home = Path(os.environ.get("C4S_HOME") or ROOT / ".c4s")
    if _is_current(home):
        return home
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("C4S_HOME", str(scratch))
        build_starter(scratch / "suites" / SUITE_ID, scratch / "packs")
    return scratch


def _is_current(home: Path) -> bool:
    suite = SuiteFolder(home / "suites" / SUITE_ID)
    if not (suite.root / STAMP).is_file():
        return False
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("C4S_HOME", str(home))
        packs = [
            PackRef(pack_id=name, digest=Pack.read(home / "packs" / name / "pack.json").sha256()) for name in STARTER
        ]
        told = (suite.root / STAMP).read_text()
        return definition_digest(definition(), packs) in told and suite_changes(suite) == []
