"""``c4s sql --shell``, as a script and at a terminal, and workbooks."""

from __future__ import annotations

import os
import pty
import select
import subprocess
import sys
from pathlib import Path

import openpyxl
import pytest

from bench.made_warehouse import MadeWarehouse
from c4s.cli.shell import completions
from c4s.errors import BadInput
from warehouse import workbook as sheets
from warehouse.database import columns_of
from warehouse.frames import export


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("home")
    MadeWarehouse(found / "warehouse", (0.7, 0.5)).write()
    return found


COMMAND = [sys.executable, "-m", "c4s.cli", "sql", "--shell"]


def script(home: Path, text: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        COMMAND, input=text, text=True, capture_output=True, timeout=60, env={**os.environ, "C4S_HOME": str(home)}
    )


def test_a_script_is_answered_line_by_line(home: Path, tmp_path: Path) -> None:
    file = tmp_path / "rows.csv"
    done = script(
        home, f"SELECT count(*)\n  AS trials\nFROM outcomes;\n.schema settings\n.export {file}\nleaderboard\n"
    )
    assert done.returncode == 0, done.stderr
    assert "190" in done.stdout and "outdoor_repair" in done.stdout and "agent-02" in done.stdout
    assert file.read_text() == "trials\n190\n"


def test_a_script_ends_with_its_first_error_in_one_line(home: Path) -> None:
    done = script(home, "SELECT * FROM leaderbord;\nSELECT 4711;\n")
    assert done.returncode == 2 and "4711" not in done.stdout
    (line,) = done.stderr.splitlines()
    assert "did you mean 'leaderboard'" in line


def test_a_column_that_is_not_there_is_told_with_the_nearest(home: Path) -> None:
    done = script(home, "SELECT configuratoin FROM outcomes;\n")
    assert done.returncode == 2 and "configuration" in done.stderr


def test_a_terminal_goes_on_after_errors_and_ctrl_c(home: Path) -> None:
    ours, theirs = pty.openpty()
    shell = subprocess.Popen(
        COMMAND,
        stdin=theirs,
        stdout=theirs,
        stderr=theirs,
        env={**os.environ, "C4S_HOME": str(home), "TERM": "dumb"},
        start_new_session=True,
        preexec_fn=lambda: __import__("fcntl").ioctl(0, __import__("termios").TIOCSCTTY, 0),
    )
    os.close(theirs)
    told = b""

    def until(text: bytes, pressing: bytes = b"") -> bytes:
        """What comes before a text; keys are pressed again where nothing comes, as between a prompt and its wait."""
        nonlocal told
        waits = 20
        os.write(ours, pressing)
        while text not in told:
            if select.select([ours], [], [], 3.0)[0]:
                told += os.read(ours, 65536)
            else:
                waits -= 1
                assert waits, told
                os.write(ours, pressing)
        before, _, told = told.partition(text)
        return before

    until(b"c4s> ")
    os.write(ours, b"SELECT nosuch FROM outcomes;\n")
    assert b"nosuch" in until(b"c4s> ")
    os.write(ours, b"SELECT 1,\n")
    until(b"...> ")
    until(b"c4s> ", pressing=b"\x03")
    os.write(ours, b"leaderb\t;\n")
    until(b"agent-02")
    until(b"c4s> ")
    os.write(ours, b"\x04")
    assert shell.wait(30) == 0
    os.close(ours)
    assert "SELECT nosuch" in (home / "cache" / "sql-history").read_text()


def test_names_are_completed(home: Path) -> None:
    names = [*columns_of(home / "warehouse"), ".tables"]
    assert completions(names, "SELECT * FROM leaderboar") == ["leaderboard", "leaderboards"]
    assert completions(names, ".ta") == [".tables"]


def test_a_workbook_has_numbers_and_no_formulas(home: Path, tmp_path: Path) -> None:
    query = """SELECT * FROM (VALUES
                   ('=1+1', 0.1::DOUBLE + 0.2::DOUBLE, 3, true, DATE '2026-01-02', NULL, 9007199254740993, [1, 2]),
                                   ('@x' || chr(7), 'nan'::DOUBLE, -4, false, NULL, 'a', 1, []))
               AS t(text, share, count, flag, day, nothing, big, list)"""
    assert export(home / "warehouse", query, tmp_path / "rows.xlsx") == 2
    sheet = openpyxl.load_workbook(tmp_path / "rows.xlsx").active
    header, one, two = sheet.iter_rows()
    assert sheet.freeze_panes == "A2" and [cell.value for cell in header][:3] == ["text", "share", "count"]
    assert (one[0].value, one[0].data_type) == ("=1+1", "s")
    assert (
        one[1].value == pytest.approx(0.3, rel=1e-15)
        and one[2].value == 3
        and one[3].value is True
        and one[5].value is None
    )
    assert one[6].value == "9007199254740993" and one[7].value == "[1, 2]"
    assert two[1].value == "nan" and two[0].value == "@x\\x07"


def test_what_no_sheet_holds_is_told(home: Path, tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="1,048,575 rows"):
        export(home / "warehouse", "SELECT 1 FROM range(1048576)", tmp_path / "rows.xlsx")
    with pytest.raises(BadInput, match="32,767 letters"):
        export(home / "warehouse", "SELECT repeat('x', 40000) AS long", tmp_path / "rows.xlsx")
    assert sheets.MOST_ROWS == 2**20 - 1 and not list(tmp_path.iterdir())
