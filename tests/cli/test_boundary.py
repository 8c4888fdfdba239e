"""How the command ends: codes, one line, help, a reader that goes away, and faults of c4s itself."""

from __future__ import annotations

import errno
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
import typer

from c4s.cli import boundary
from c4s.errors import AgentFault, BadInput, MachineryFault
from tests.cli.warm import Warm


def _raising(error: BaseException) -> Callable[[], object]:
    def command() -> object:
        raise error

    return command


@pytest.mark.parametrize(
    ("error", "code", "line"),
    [
        (BadInput("it is empty", where="a.json", todo="fill it"), 2, "a.json: it is empty (fill it)"),
        (MachineryFault("the engine died"), 3, "the engine died"),
        (AgentFault("it gave up"), 1, "it gave up"),
        (KeyboardInterrupt(), 130, "stopped; run the same command to go on"),
        (FileNotFoundError(errno.ENOENT, "No such file or directory", "a/b"), 2, "a/b: no such file or directory"),
        (PermissionError(errno.EACCES, "Permission denied", "a/b"), 2, "a/b: permission denied"),
        (OSError(errno.ENOSPC, "No space left on device", "a/b"), 3, "a/b: no space left on device"),
        (BadInput("a\x1b[31m\n\u2028b\udcff"), 2, "a\\x1b[31m b\\udcff"),
    ],
)
def test_an_error_is_a_line_and_a_code(
    error: BaseException, code: int, line: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as end:
        boundary.run(_raising(error))
    told = capsys.readouterr()
    assert (end.value.code, told.out, told.err) == (code, "", f"c4s: {line}\n")


def test_an_answer_that_is_no_says_nothing_more(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        boundary.run(_raising(typer.Exit(1)))
    assert end.value.code == 1 and capsys.readouterr() == ("", "")


def test_what_no_policy_names_is_a_fault_of_c4s(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        boundary.run(_raising(KeyError("lost")))
    told = capsys.readouterr().err
    kept = re.search(r"in (/\S+\.txt)\)", told)
    assert end.value.code == 3 and told.startswith("c4s: this is a fault of c4s: ") and told.count("\n") == 1 and kept
    assert "Traceback" in Path(kept[1]).read_text() and "KeyError: 'lost'" in Path(kept[1]).read_text()
    Path(kept[1]).unlink()


def test_a_long_line_is_cut_in_its_middle(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        boundary.run(_raising(BadInput("a" * 100_000 + "z", where="begin")))
    told = capsys.readouterr().err
    assert told.startswith("c4s: begin: aaa") and told.endswith("az\n") and len(told) < 2_000


@pytest.mark.parametrize("group", [[], ["suite"], ["suite", "import"], ["engine"]])
def test_a_group_without_a_command_shows_its_help(group: list[str], warm: Warm, tmp_path: Path) -> None:
    done = warm.call(group, cwd=tmp_path, environment={"C4S_HOME": str(tmp_path)})
    assert done.code == 0 and not done.err and f"Usage: {' '.join(['c4s', *group])} " in done.out


def test_a_reader_that_goes_away_is_no_error(world: Path) -> None:
    with subprocess.Popen(
        [sys.executable, "-m", "c4s.cli", "sql", "SELECT repeat('x', 1000) FROM range(2000)", "--json"],
        env={"PATH": "", "C4S_HOME": str(world / "home")},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        cwd=Path(__file__).parents[2],
    ) as process:
        assert process.stdout is not None and process.stderr is not None
        process.stdout.read(1)
        process.stdout.close()
        assert process.stderr.read() == b"" and process.wait() == 0


def test_standard_output_that_takes_nothing_is_a_fault_of_the_machinery(world: Path) -> None:
    with Path("/dev/full").open("wb") as full:
        done = subprocess.run(
            [sys.executable, "-m", "c4s.cli", "sql"],
            env={"PATH": "", "C4S_HOME": str(world / "home")},
            stdout=full,
            stderr=subprocess.PIPE,
            cwd=Path(__file__).parents[2],
            check=False,
        )
    assert done.returncode == 3 and done.stderr == b"c4s: standard output: no space left on device\n"
