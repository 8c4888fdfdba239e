"""Wheel and sdist: they hold all that the packages hold, are the same bytes each time, and work elsewhere."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

from bench.dist import build

ROOT = Path(__file__).parents[2]
AT_S = 1_700_000_000
PACKAGES = ("c4s", "cases", "catalog", "reports", "warehouse", "flows", "tasks")
WHEEL = (
    sys.executable,
    "-m",
    "pip",
    "wheel",
    "--quiet",
    "--disable-pip-version-check",
    "--no-deps",
    "--no-build-isolation",
)


def _tracked() -> list[str]:
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=False)
    if listed.returncode:
        pytest.skip("not a git checkout")
    return [name for name in listed.stdout.split("\0") if name]


def _built(tree: Path, out: Path) -> Path:
    """The wheel of a tree; its times are those of no clock."""
    environment = {**os.environ, "SOURCE_DATE_EPOCH": str(AT_S)}
    subprocess.run([*WHEEL, "--wheel-dir", str(out), str(tree)], env=environment, check=True, timeout=200)
    return next(out.glob("*.whl"))


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What a clone of the checkout holds, and nothing that a build or a run left in it."""
    root = tmp_path_factory.mktemp("wheel") / "tree with spaces é"
    for name in _tracked():
        if name.split("/")[0] in PACKAGES or "/" not in name:
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, root / name)
    return root


@pytest.fixture(scope="module")
def wheel(tree: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel."""
    return _built(tree, tmp_path_factory.mktemp("wheels"))


def test_it_holds_what_the_packages_hold_and_nothing_else(wheel: Path) -> None:
    held = {name for name in zipfile.ZipFile(wheel).namelist() if ".dist-info/" not in name}
    assert held == {name for name in _tracked() if name.split("/")[0] in PACKAGES}


def test_it_is_the_same_bytes_each_time(wheel: Path, tree: Path, tmp_path: Path) -> None:
    assert _built(tree, tmp_path).read_bytes() == wheel.read_bytes()


def test_the_sdist_is_the_same_bytes_each_time_and_makes_the_same_wheel(tree: Path, tmp_path: Path) -> None:
    wheel, source = build(tree, tmp_path / "first", AT_S)
    assert build(tree, tmp_path / "again", AT_S)[1].read_bytes() == source.read_bytes()
    with tarfile.open(source) as archive:
        archive.extractall(tmp_path / "unpacked", filter="data")
        held = {name.partition("/")[2] for name in archive.getnames()}
    assert {name for name in _tracked() if name.split("/")[0] in PACKAGES} <= held
    assert build(next((tmp_path / "unpacked").iterdir()), tmp_path / "anew", AT_S)[0].read_bytes() == wheel.read_bytes()


def test_what_it_installs_works_without_the_checkout(wheel: Path, tmp_path: Path) -> None:
    place = tmp_path / "installed é"
    zipfile.ZipFile(wheel).extractall(place)
    environment = {**os.environ, "C4S_HOME": str(tmp_path / "home"), "PYTHONPATH": str(place)}

    def python(*arguments: str) -> str:
        command = [sys.executable, "-P", *arguments]
        done = subprocess.run(
            command, env=environment, cwd=tmp_path, capture_output=True, text=True, timeout=250, check=False
        )
        assert done.returncode == 0, done.stderr
        return done.stdout

    assert Path(python("-c", "import c4s; print(c4s.__file__)").strip()).is_relative_to(place)
    assert python("-m", "c4s.cli", "--version").startswith("c4s ")
    assert "sanity_ladder" in python("-m", "c4s.cli", "sql")
