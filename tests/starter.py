"""The starter suite as it ships, built once a checkout."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import Final

import pytest

from c4s.packs.suite_check import suite_changes
from c4s.records.folder import RunFolder, TrialFolder
from c4s.records.pack import Pack
from c4s.records.suite import PackRef, SuiteFolder
from cases.definition import definition_digest
from cases.stamp import STAMP
from cases.starter.suite import SUITE_ID, build_starter, definition
from catalog.starter import STARTER
from tests.built import DEMO, built_once, take_kept
from tests.house.tree import ROOT

PLACE: Final = "home"
"""The file that tells which home it is."""
ROOMS: Final = ("c4s", "cases", "catalog", "reports", "warehouse")
SOURCES: Final = (".py", ".yaml", ".json", ".txt", ".md")


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


@functools.cache
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


def demo_trial(agent: str, case_id: str) -> TrialFolder | None:
    """The trial that ``make demo`` left of an agent, where its attempt is newer than every source; for reading."""
    suite = SuiteFolder(DEMO / "suites" / SUITE_ID)
    if not _is_current(DEMO):
        return None
    trial = RunFolder(DEMO / "runs" / SUITE_ID).trial(agent, suite.case(case_id).alias, 1)
    begun = trial.attempt(1).outcome
    there = trial.score.is_file() and begun.is_file() and begun.stat().st_mtime_ns > _changed_ns()
    return trial if there else None


@functools.cache
def _changed_ns() -> int:
    """When a source of the product was last written."""
    found = (path for room in ROOMS for path in (ROOT / room).rglob("*") if path.suffix in SOURCES)
    return max(path.stat().st_mtime_ns for path in (*found, ROOT / "requirements.lock"))
