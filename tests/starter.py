"""The starter suite as it ships, built once a checkout."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pytest

from c4s.packs.suite_check import suite_changes
from c4s.records.pack import Pack
from c4s.records.suite import PackRef, SuiteFolder
from cases.definition import definition_digest
from cases.stamp import STAMP
from cases.starter.suite import SUITE_ID, build_starter, definition
from catalog.starter import STARTER
from tests.built import DEMO, built_once, take_kept

PLACE: Final = "home"
"""The file that tells which home it is."""


def starter_home(factory: pytest.TempPathFactory) -> Path:
    """The home that ``make demo`` filled, where its suite is the one that the sources say and no file was changed; else
    one that is built now, once for all processes of the test run. It is for reading."""
    found = built_once(factory, "starter", _find_or_build)
    return Path((found / PLACE).read_text())


def _find_or_build(root: Path) -> None:
    root.mkdir()
    chosen = DEMO if _is_current(DEMO) else root
    if chosen == root:
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("C4S_HOME", str(root))
            take_kept(root)
            build_starter(root / "suites" / SUITE_ID, root / "packs")
    (root / PLACE).write_text(str(chosen))


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
