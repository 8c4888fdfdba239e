"""Backups that are cut off, brought up to date or damaged: what they had comes back."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from c4s.errors import BadInput
from c4s.files import digest_bytes
from c4s.records.backup import Backup, KeptFile
from c4s.run.backup import PARTS, back_up, restore
from c4s.run.lease import holding
from tests.run.conftest import environment

Contents = dict[str, bytes]


@pytest.fixture
def at(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[str], Path]:
    """Makes a home of this name the one that is backed up, or restored to."""

    def go(name: str) -> Path:
        monkeypatch.setenv("C4S_HOME", str(tmp_path / name))
        return tmp_path / name

    return go


def write(home: Path, contents: Contents) -> None:
    for name, data in contents.items():
        (home / name).parent.mkdir(parents=True, exist_ok=True)
        (home / name).write_bytes(data)


def contents(home: Path) -> Contents:
    return {
        path.relative_to(home).as_posix(): path.read_bytes()
        for path in home.rglob("*")
        if path.is_file() and "lease" not in path.parts
    }


def test_a_backup_that_is_cut_off_leaves_the_one_before(at: Callable[[str], Path], tmp_path: Path) -> None:
    home, copy = at("home"), tmp_path / "copy"
    first = {"runs/x/a": b"first", "runs/x/same": b"same", "human/s/study.json": b"{}"}
    second = {"runs/x/a": b"second", "runs/x/large": bytes(3 << 20), "human/s/study.json": b"{}"}
    write(home, first)
    back_up(copy, PARTS)
    write(home, second)
    limited = f"ulimit -f 2048; exec {sys.executable} -m c4s.cli backup {copy}"
    cut = subprocess.run(
        ["bash", "-c", limited], env=environment(home), capture_output=True, text=True, timeout=100, check=False
    )
    assert cut.returncode == 3 and "cannot copy" in cut.stderr, cut.stderr
    restore_to = at("of-the-first")
    restore(copy)
    assert contents(restore_to) == first
    at("home")
    (home / "runs/x/same").unlink()
    assert back_up(copy, PARTS).files == 3
    restore_to = at("of-the-second")
    restore(copy)
    assert contents(restore_to) == second
    kept = {path.name for path in (copy / "files").glob("*/*")}
    assert kept == {digest_bytes(data) for data in second.values()}, "nothing stays that no file has"


def test_what_is_not_copied_now_stays_as_the_backup_had_it(at: Callable[[str], Path], tmp_path: Path) -> None:
    home, copy = at("home"), tmp_path / "copy"
    before = {"runs/x/plan.json": b"{}", "runs/x/a": b"before", "runs/y/a": b"y", "suites/s/suite.json": b"{}"}
    write(home, before)
    back_up(copy, PARTS)
    write(home, {"runs/x/a": b"in work", "runs/y/a": b"anew", "suites/s/suite.json": b"changed"})
    with holding(home / "runs/x"):
        done = back_up(copy, ["runs"])
    assert done.left_out == ["x"] and done.copied == 1
    restored = at("restored")
    restore(copy)
    assert contents(restored) == before | {"runs/y/a": b"anew"}


@pytest.mark.parametrize(
    "names", [["runs"], ["runs/."], ["."], ["site/x"], ["runs/a", "runs/a/b"], ["runs/a", "runs/a"]]
)
def test_a_name_that_no_backup_of_a_home_has_is_refused_before_anything_is_written(
    at: Callable[[str], Path], tmp_path: Path, names: list[str]
) -> None:
    copy, data = tmp_path / "copy", b"x"
    write(copy, {f"files/{digest_bytes(data)[:2]}/{digest_bytes(data)}": data})
    files = [KeptFile(path=name, size=1, digest=digest_bytes(data)) for name in ("runs/whole", *names)]
    Backup(made="2026-11-23T07:30:00+00:00", parts=["runs"], left_out=[], files=files).write(copy / "backup.json")
    home = at("home")
    with pytest.raises(BadInput, match=r"in no part|one place"):
        restore(copy)
    assert not home.exists()
