"""A small real suite: the flat of the starter suite with one text and two repair cases, in a home of its own."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from c4s.records.folder import RunFolder, TrialFolder
from c4s.records.suite import SuiteFolder
from cases.model import SuiteDefinition
from cases.starter import indoor_cases
from cases.suite import build_suite
from tests.built import built_once, take_kept, take_pack
from tests.cli.warm import warm_process

KEPT = ("text-flat-family",)
Command = Callable[..., subprocess.CompletedProcess[str]]


@pytest.fixture(scope="session")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A ``C4S_HOME`` with the suite ``small``: a text case and two repairs of the flat. Suite and packs are built once
    a test run."""
    return apart(tmp_path_factory.mktemp("homes") / "home", built_once(tmp_path_factory, "small-home", build_small))


def build_small(root: Path) -> None:
    """The suite ``small`` and its pack, below a home that keeps what it renders."""
    scene = indoor_cases.scenes()[1]
    texts = [case for case in indoor_cases.INDOOR_TEXT_CASES if case.case_id in KEPT]
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("C4S_HOME", str(root))
        take_kept(root)
        take_pack("c4s-home", root / "packs")
        build_suite(
            SuiteDefinition(
                "small", "Small", "The flat", ("c4s-home",), (scene,), (*texts, *indoor_cases.flat_cases(scene)[:2])
            ),
            root / "suites" / "small",
            root / "packs",
            lambda line: None,
        )


def environment(home: Path) -> dict[str, str]:
    """The environment of a command in this home."""
    return {**os.environ, "C4S_HOME": str(home), "COLUMNS": "140"}


def apart(root: Path, home: Path) -> Path:
    """Another home with the same packs, suites and compiled code, where nothing has run."""
    root.mkdir(parents=True)
    (home / "cache").mkdir(exist_ok=True)
    for name in ("packs", "suites", "cache"):
        (root / name).symlink_to(home / name)
    return root


def command_in(home: Path) -> Command:
    """Runs the command line in a home, as a process of its own; none has to import what the one before it did."""

    def run(*arguments: str, timeout: int = 280, home: Path = home) -> subprocess.CompletedProcess[str]:
        done = warm_process().call(arguments, cwd=Path.cwd(), environment=environment(home), limit_s=timeout)
        return subprocess.CompletedProcess(arguments, done.code, done.out, done.err)

    return run


@pytest.fixture
def c4s(home: Path) -> Command:
    """Run the command line in the home."""
    return command_in(home)


def trial_in(home: Path, run: str, configuration: str, case_id: str) -> TrialFolder:
    """The folder of the first repeat of a trial on the suite ``small``."""
    alias = SuiteFolder(home / "suites/small").case(case_id).alias
    return RunFolder(home / "runs" / run).trial(configuration, alias, 1)
