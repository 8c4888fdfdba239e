"""The database is what its parts say, however it came to be, and whoever works on it at the same time."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import duckdb
import pytest

from c4s.errors import BadInput
from tests.house.tree import ROOT
from tests.warehouse.made_rows import store_outcome, store_picture, store_schedule
from warehouse.database import ask, catch_up, is_current, rebuild, rows

FILE = "c4s.duckdb"


def scores(root: Path) -> dict[str, float]:
    return {row["trial_id"]: row["score"] for row in rows(root, "SELECT trial_id, score FROM outcomes")}


def contents(root: Path) -> dict[str, list[str]]:
    """All rows of every table and question."""
    names = [name for (name,) in ask(root, "SELECT view_name FROM duckdb_views() WHERE NOT internal")[1]]
    return {name: sorted(map(str, rows(root, f"SELECT * FROM {name}"))) for name in names}


def made_anew(root: Path, scratch: Path) -> dict[str, list[str]]:
    """What a database says that is made of the same parts from nothing."""
    copy = Path(shutil.copytree(root, scratch))
    (copy / FILE).unlink()
    rebuild(copy)
    return contents(copy)


def test_new_changed_and_gone_parts_give_what_a_new_database_gives(tmp_path: Path) -> None:
    root = tmp_path / "warehouse"
    store_schedule(root, range(8))
    parts = [store_outcome(root, number, 0.5) for number in range(6)]
    rebuild(root)
    assert scores(root) == {f"alpha-{number}": 0.5 for number in range(6)}
    store_outcome(root, 6, 0.25)
    store_outcome(root, 0, 1.0)
    parts[1].unlink()
    shutil.rmtree(store_outcome(root, 0, 0.1, "beta").parent)
    store_picture(root, 6, b"jpeg")
    rebuild(root)
    wanted = {f"alpha-{number}": 0.5 for number in range(2, 6)} | {"alpha-0": 1.0, "alpha-6": 0.25}
    assert scores(root) == wanted
    assert rows(root, "SELECT jpeg FROM pictures") == [{"jpeg": b"jpeg"}]
    assert contents(root) == made_anew(root, tmp_path / "copy")


def test_a_part_of_the_same_size_and_time_is_another_part(tmp_path: Path) -> None:
    part = store_outcome(tmp_path, 0, 0.25)
    rebuild(tmp_path)
    before = part.stat()
    store_outcome(tmp_path, 0, 0.75)
    os.utime(part, ns=(before.st_atime_ns, before.st_mtime_ns))
    assert part.stat().st_size == before.st_size
    rebuild(tmp_path)
    assert scores(tmp_path) == {"alpha-0": 0.75}


def test_a_database_that_is_up_to_date_is_not_written(tmp_path: Path) -> None:
    os.utime(store_outcome(tmp_path, 0, 0.25).parent, (1e9, 1e9))
    rebuild(tmp_path)
    before = (tmp_path / FILE).stat()
    rebuild(tmp_path)
    catch_up(tmp_path)
    assert (tmp_path / FILE).stat().st_ino == before.st_ino and is_current(tmp_path)
    store_outcome(tmp_path, 1, 0.5)
    assert not is_current(tmp_path)


def test_a_question_touches_nothing_where_nothing_came(tmp_path: Path) -> None:
    store_outcome(tmp_path, 0, 0.25)
    rebuild(tmp_path)
    before = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")}
    catch_up(tmp_path)
    assert {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")} == before


def test_a_reader_takes_in_what_came_since(tmp_path: Path) -> None:
    catch_up(tmp_path)
    assert not (tmp_path / FILE).exists()
    rebuild(tmp_path)
    store_schedule(tmp_path, range(3))
    for number in range(3):
        store_outcome(tmp_path, number, 0.5)
        catch_up(tmp_path)
        assert len(scores(tmp_path)) == number + 1


def test_an_old_folder_is_listed_again_only_when_it_changed(tmp_path: Path) -> None:
    """A part that is damaged where it lies misleads nobody: its rows are held. A report looks at every part."""
    part = store_outcome(tmp_path, 0, 0.5)
    os.utime(part.parent, (1e9, 1e9))
    rebuild(tmp_path)
    part.write_bytes(b"PAR1")
    catch_up(tmp_path)
    assert scores(tmp_path) == {"alpha-0": 0.5} and not is_current(tmp_path)
    with pytest.raises(BadInput, match=part.name):
        rebuild(tmp_path)
    assert scores(tmp_path) == {"alpha-0": 0.5}


def test_a_trial_that_two_runs_planned_counts_once_and_stands_where_it_was_planned_first(tmp_path: Path) -> None:
    store_schedule(tmp_path, range(4), run="late", planned_at="2026-02-01")
    store_schedule(tmp_path, range(3), run="early", planned_at="2026-01-01")
    rebuild(tmp_path)
    found = rows(tmp_path, "SELECT trial_id, run_id FROM schedule ORDER BY trial_id")
    assert [row["run_id"] for row in found] == ["early", "early", "early", "late"]
    assert sum(row["planned"] for row in rows(tmp_path, "SELECT * FROM leaderboard")) == 4


@pytest.mark.parametrize("content", [b"", b"no database", bytes(40_000)], ids=["empty", "text", "zeros"])
def test_a_file_that_is_no_database_is_made_anew(tmp_path: Path, content: bytes) -> None:
    store_outcome(tmp_path, 0, 0.5)
    rebuild(tmp_path)
    (tmp_path / FILE).write_bytes(content)
    assert not is_current(tmp_path)
    rebuild(tmp_path)
    assert scores(tmp_path) == {"alpha-0": 0.5}


@pytest.mark.parametrize("share", [0.3, 0.6])
def test_a_database_that_was_cut_off_is_told_and_made_anew(tmp_path: Path, share: float) -> None:
    for number in range(5):
        store_outcome(tmp_path, number, 0.5)
    file = rebuild(tmp_path)
    store_outcome(tmp_path, 5, 0.5)
    file.write_bytes(file.read_bytes()[: int(file.stat().st_size * share)])
    catch_up(tmp_path)
    with pytest.raises(BadInput, match=r"damaged.*c4s report"):
        ask(tmp_path, "SELECT * FROM outcomes")
    rebuild(tmp_path)
    assert len(scores(tmp_path)) == 6


def test_a_database_whose_tables_another_version_made_is_told_and_made_anew(tmp_path: Path) -> None:
    store_outcome(tmp_path, 0, 0.5)
    with duckdb.connect(str(tmp_path / FILE)) as old:
        old.execute("CREATE VIEW outcomes AS SELECT 1 AS score")
    with pytest.raises(BadInput, match=r"another version.*c4s report"):
        ask(tmp_path, "SELECT * FROM outcomes")
    rebuild(tmp_path)
    assert scores(tmp_path) == {"alpha-0": 0.5}


def test_the_file_does_not_grow_with_the_number_of_refreshes(tmp_path: Path) -> None:
    for number in range(20):
        store_outcome(tmp_path, number, 0.5)
    size = rebuild(tmp_path).stat().st_size
    for number in range(30):
        store_outcome(tmp_path, number % 20, number / 30)
        rebuild(tmp_path)
    assert rebuild(tmp_path).stat().st_size < 3 * size and len(scores(tmp_path)) == 20


def process(root: Path, *program: str) -> subprocess.Popen[str]:
    """A process that can import the tests; its program has ``root`` as a path."""
    lines = ["import sys", "from pathlib import Path", "root = Path(sys.argv[1])", *program]
    return subprocess.Popen(
        [sys.executable, "-c", "\n".join(lines), str(root)],
        cwd=ROOT,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )


WRITER = """
from tests.warehouse.made_rows import store_outcome
from warehouse.database import rebuild
for number in range(12):
    store_outcome(root, number, 0.5, NAME)
    rebuild(root)
"""
READER = """
from warehouse.database import ask, catch_up
seen = 0
for _ in range(40):
    catch_up(root)
    for table, least in (("outcomes", seen), ("leaderboard", 0)):
        ((count,),) = ask(root, f"SELECT count(*) FROM {table}")[1]
        assert count >= least, (table, count, least)
        seen = count if table == "outcomes" else seen
"""


def test_writers_and_readers_at_once_lose_no_row_and_meet_no_lock(tmp_path: Path) -> None:
    rebuild(tmp_path)
    writers = [process(tmp_path, WRITER.replace("NAME", repr(name))) for name in ("alpha", "beta")]
    readers = [process(tmp_path, READER) for _ in range(2)]
    for one in (*writers, *readers):
        _, said = one.communicate(timeout=120)
        assert (one.returncode, said) == (0, "")
    assert len(scores(tmp_path)) == 24 and is_current(tmp_path)
    assert not list(tmp_path.glob(".c4s.duckdb*"))


def test_a_reader_that_stays_keeps_its_rows_and_holds_nobody_up(tmp_path: Path) -> None:
    store_outcome(tmp_path, 0, 0.5)
    rebuild(tmp_path)
    with duckdb.connect(str(tmp_path / FILE), read_only=True) as reader:
        store_outcome(tmp_path, 1, 0.5)
        writer = process(tmp_path, "from warehouse.database import rebuild", "rebuild(root)")
        assert writer.communicate(timeout=60)[1] == ""
        assert reader.execute("SELECT count(*) FROM outcomes").fetchall() == [(1,)]
    assert len(scores(tmp_path)) == 2


def test_a_killed_refresh_leaves_the_database_of_before_and_the_next_one_goes_on(tmp_path: Path) -> None:
    store_outcome(tmp_path, 0, 0.5)
    rebuild(tmp_path)
    for number in range(1, 40):
        store_outcome(tmp_path, number, 0.5)
    for statement in ("_take_in", "_keep_answer", "_note"):
        killed = process(
            tmp_path,
            "import os, signal",
            "from warehouse import refresh",
            f"inside = refresh.{statement}",
            "def killed(*arguments):",
            "    inside(*arguments)",
            "    os.kill(os.getpid(), signal.SIGKILL)",
            f"refresh.{statement} = killed",
            "refresh.rebuild(root)",
        )
        killed.communicate(timeout=60)
        assert killed.returncode == -signal.SIGKILL
        assert list(tmp_path.glob(".c4s.duckdb.*")) and scores(tmp_path) == {"alpha-0": 0.5}
    rebuild(tmp_path)
    assert len(scores(tmp_path)) == 40 and not list(tmp_path.glob(".c4s.duckdb.*"))
