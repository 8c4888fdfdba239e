"""Damage to the warehouse is named with the command that repairs it, and that command repairs it."""

from __future__ import annotations

import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import duckdb
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from tests.cli.contract import faults_of_line
from tests.cli.garbage import KINDS
from tests.cli.warm import Done, Warm
from warehouse.database import rebuild

OUTCOMES = "warehouse/outcomes/suite=yard/configuration=noop"
QUERY = ["sql", "SELECT count(*) AS trials FROM outcomes", "--json"]
WHOLE = '[{"trials": 1}]\n'
Change = Callable[[Path], None]


def _written(content: bytes) -> Change:
    return lambda path: path.write_bytes(content) and None


def _cut(path: Path) -> None:
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


def _bitten(path: Path) -> None:
    """The footer is whole, the rows are not."""
    data = bytearray(path.read_bytes())
    data[4:200] = bytes(196)
    path.write_bytes(data)


def _without_a_column(path: Path) -> None:
    table = pq.ParquetFile(path).read()
    pq.write_table(table.drop_columns(["status"]), path)


def _without_its_last_column(path: Path) -> None:
    table = pq.ParquetFile(path).read()
    pq.write_table(table.drop_columns(table.column_names[-1:]), path)


def _made_by_older_code(file: Path) -> None:
    """What a database says of itself after its tables were defined anew."""
    with duckdb.connect(str(file)) as connection:
        connection.execute("DROP TABLE IF EXISTS rows.made")


def _of_other_types(path: Path) -> None:
    table = pq.ParquetFile(path).read()
    index = table.schema.get_field_index("repeat")
    pq.write_table(table.set_column(index, "repeat", pa.array(["x"] * len(table))), path)


def _folder(path: Path) -> None:
    path.unlink()
    path.mkdir()


def _of_another_version(path: Path) -> None:
    data = bytearray(path.read_bytes())
    data[12] = 250
    path.write_bytes(data)


PARTS: dict[str, Change] = {
    "cut": _cut,
    "bitten": _bitten,
    "empty": _written(b""),
    "binary": _written(KINDS["binary"]),
    "zeros": _written(KINDS["zeros"]),
    "a column less": _without_a_column,
    "other types": _of_other_types,
    "a folder": _folder,
    "gone": Path.unlink,
}
FILES: dict[str, Change] = {
    "cut": lambda path: path.write_bytes(path.read_bytes()[:16_384]) and None,
    "empty": _written(b""),
    "binary": _written(KINDS["binary"]),
    "zeros": _written(KINDS["zeros"]),
    "a folder": _folder,
    "of another version": _of_another_version,
    "gone": Path.unlink,
}


@pytest.fixture
def home(world: Path, tmp_path: Path) -> Path:
    copy = Path(shutil.copytree(world / "home", tmp_path / "home", symlinks=True))
    rebuild(copy / "warehouse")
    return copy


def _call(warm: Warm, home: Path, *arguments: str) -> Done:
    return warm.call(arguments, cwd=home, environment={"C4S_HOME": str(home)})


def _refused(done: Done, *told: str) -> None:
    assert done.code == 2 and not faults_of_line(done), done
    assert all(text in done.err for text in told), done.err


def _remove(path: Path) -> None:
    shutil.rmtree(path) if path.is_dir() else path.unlink(missing_ok=True)


def _replaced(part: Path, change: Change) -> None:
    """Put a damaged part in the place of a sound one, as every writer puts a file."""
    damaged = part.with_name("damaged")
    shutil.copy(part, damaged)
    change(damaged)
    part.unlink()
    if damaged.exists():
        damaged.rename(part)


@pytest.mark.parametrize("damage", PARTS)
def test_rows_that_cannot_be_read(damage: str, warm: Warm, home: Path) -> None:
    part = next((home / OUTCOMES).glob("*.parquet"))
    _replaced(part, PARTS[damage])
    done = _call(warm, home, "sql", "SELECT * FROM outcomes")
    _refused(done, "c4s report --from-runs", *([] if damage == "gone" else [part.name]))
    if "delete the warehouse" in done.err:
        shutil.rmtree(home / "warehouse")
    elif "delete it" in done.err:
        _remove(part)
    assert _call(warm, home, "report", "--from-runs").code == 0
    assert _call(warm, home, *QUERY).out == WHOLE


@pytest.mark.parametrize("damage", FILES)
def test_a_file_that_is_no_warehouse(damage: str, warm: Warm, home: Path) -> None:
    file = home / "warehouse/c4s.duckdb"
    FILES[damage](file)
    done = _call(warm, home, *QUERY)
    _refused(done, "c4s report", "warehouse" if damage == "gone" else "c4s.duckdb")
    if "delete it" in done.err:
        _remove(file)
    assert _call(warm, home, "report").code == 0
    assert _call(warm, home, *QUERY).out == WHOLE


RELEASE = ["release", "--out", "released", "--suite", "yard"]


@pytest.mark.parametrize("command", [QUERY, RELEASE], ids=["sql", "release"])
def test_a_warehouse_whose_rows_are_old_too(command: list[str], warm: Warm, home: Path) -> None:
    folder = home / "warehouse/outcomes/suite=yard/configuration=noop"
    _replaced(part := next(folder.glob("*.parquet")), _without_its_last_column)
    _made_by_older_code(home / "warehouse/c4s.duckdb")
    done = _call(warm, home, *command)
    _refused(done, "delete the warehouse, then run `c4s report --from-runs`", part.name)
    shutil.rmtree(home / "warehouse")
    assert _call(warm, home, "report", "--from-runs").code == 0
    assert _call(warm, home, *command).code == 0


def test_a_warehouse_that_another_process_has_open(warm: Warm, home: Path) -> None:
    file = home / "warehouse/c4s.duckdb"
    code = f"import duckdb; held = duckdb.connect({str(file)!r}); print('open', flush=True); input()"
    with subprocess.Popen([sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as holder:
        assert holder.stdout is not None and holder.stdout.readline() == b"open\n"
        _refused(_call(warm, home, *QUERY), "c4s.duckdb", str(holder.pid), "close it")
        holder.communicate(b"\n")
    assert _call(warm, home, *QUERY).out == WHOLE


def test_a_warehouse_that_was_moved_does_not_show_the_rows_of_its_old_place(warm: Warm, home: Path) -> None:
    moved = Path(shutil.copytree(home, home.with_name("moved"), symlinks=True))
    _refused(_call(warm, moved, *QUERY), "moved", "c4s report")
    assert _call(warm, moved, "report").code == 0
    shutil.rmtree(home)
    assert _call(warm, moved, *QUERY).out == WHOLE


def test_a_run_that_is_done_makes_the_views_of_a_moved_home_again(warm: Warm, home: Path) -> None:
    moved = Path(shutil.copytree(home, home.with_name("moved"), symlinks=True))
    assert _call(warm, moved, "run", "yard", "-a", "noop").code == 0
    assert _call(warm, moved, *QUERY).out == WHOLE


def test_readers_do_not_stand_in_the_way_of_a_report(warm: Warm, home: Path) -> None:
    with duckdb.connect(str(home / "warehouse/c4s.duckdb"), read_only=True):
        assert _call(warm, home, "report").code == 0


def test_a_report_that_fails_leaves_the_pages_and_the_views_of_before(warm: Warm, home: Path) -> None:
    views, page = home / "warehouse/c4s.duckdb", home / "site/index.html"
    before = views.read_bytes(), page.read_bytes()
    shutil.rmtree(home / "runs")
    _cut(next((home / OUTCOMES).glob("*.parquet")))
    _refused(_call(warm, home, "report"), "c4s report --from-runs")
    assert (views.read_bytes(), page.read_bytes()) == before
    assert not list(home.glob(".site*")) and not list((home / "warehouse").glob(".c4s.duckdb*"))


def test_pages_that_cannot_be_put_in_their_place(warm: Warm, home: Path) -> None:
    shutil.rmtree(home / "site")
    (home / "site").write_text("mine")
    _refused(_call(warm, home, "report"), "site", "move it away")
    assert (home / "site").read_text() == "mine"
    (home / "site").unlink()
    assert _call(warm, home, "report").code == 0
