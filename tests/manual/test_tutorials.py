"""The tutorials' commands are run as they stand, in their order, on three cases of the starter suite."""

from __future__ import annotations

import re
import shlex
import shutil
from dataclasses import dataclass
from pathlib import Path

import pytest

from manual.contents import ROOT
from tests.built import built_once
from tests.cli.warm import warm_process
from tests.run.conftest import build_small, environment

TUTORIALS = sorted((ROOT / "docs" / "tutorials").glob("*.md"))
FENCE = re.compile(r"^```(\w+)(?: exit=(\d))?\n(.*?)^```$", re.MULTILINE | re.DOTALL)
BUILD = "c4s suite build starter"
"""The one command that is left out: the suite is there."""


@dataclass(frozen=True)
class _Step:
    command: str
    code: int


def _steps(text: str, folder: Path) -> list[_Step]:
    """The commands of a tutorial; scripts that it shows under a name are written first."""
    steps = []
    for language, code, body in FENCE.findall(text):
        if named := re.match(r"# (\w+\.py)\n", body):
            (folder / named[1]).write_text(body, encoding="utf-8")
        if language == "sh":
            steps += [_Step(line, int(code or 0)) for line in body.splitlines() if line.strip()]
    return steps


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One home for all, so that a trial which two of them ask for is run once."""
    root, built = tmp_path_factory.mktemp("tutorials") / "home", built_once(tmp_path_factory, "small-home", build_small)
    for name in ("packs", "suites"):
        shutil.copytree(built / name, root / name)
    (built / "cache").mkdir(exist_ok=True)
    (root / "cache").symlink_to(built / "cache")
    return root


@pytest.mark.timeout(900)
@pytest.mark.parametrize("path", TUTORIALS, ids=lambda path: path.stem)
def test_its_commands_do_what_it_says(home: Path, path: Path, tmp_path: Path) -> None:
    steps = _steps(path.read_text(encoding="utf-8"), tmp_path)
    assert len(steps) >= 7 and steps[0].command in (BUILD, "c4s doctor")
    warm = warm_process()
    for step in steps:
        if step.command == BUILD:
            continue
        name, *arguments = shlex.split(step.command)
        assert name == "c4s"
        given = ["small" if argument == "starter" else argument for argument in arguments]
        given += ["--suite", "small"] if "--case" in given and "--suite" not in given else []
        done = warm.call(given, cwd=tmp_path, environment=environment(home), limit_s=600)
        expected = {0, 1} if given == ["doctor"] else {step.code}
        assert done.code in expected, f"{step.command}\n{done.err[-1500:]}"


def test_there_is_one_for_each_kind_of_user() -> None:
    assert [path.stem for path in TUTORIALS] == ["agent-builder", "analyst", "case-author", "operator"]
