"""Public and private cases are two panels, and what is not complete on one stands apart from its ranks."""

from __future__ import annotations

from pathlib import Path

import pyarrow.parquet as pq
import pytest

from bench.made_warehouse import PUBLIC_SET, MadeWarehouse
from c4s.errors import BadInput
from warehouse.analyses import StudyOptions, WantedScope, answer, study_named
from warehouse.database import rebuild, rows

ABILITIES = (0.7, 0.5, 0.3)
PRIVATE = frozenset(
    f"{setting.rpartition('/')[2]}-{place:02d}"
    for setting, count, _ in PUBLIC_SET
    for place in range(count - 7, count + 1)
)


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> MadeWarehouse:
    """Three configurations; the best one has a pending private case."""
    warehouse = MadeWarehouse(
        tmp_path_factory.mktemp("warehouse"), ABILITIES, private=PRIVATE, pending=frozenset({("agent-01", "indoor-25")})
    )
    warehouse.write()
    return warehouse


def test_each_panel_has_means_and_ranks_of_its_own(made: MadeWarehouse) -> None:
    board = {(row["visibility"], row["configuration"]): row for row in rows(made.root, "SELECT * FROM leaderboard")}
    assert len(board) == 2 * len(ABILITIES)
    assert [board["public", name]["rank"] for name in made.names()] == [1, 2, 3]
    assert [board["private", name]["rank"] for name in made.names()] == [None, 1, 2]
    means = rows(
        made.root,
        "SELECT visibility, avg(score) AS mean FROM case_scores JOIN settings USING (setting) "
        "WHERE construction AND configuration = 'agent-02' GROUP BY ALL",
    )
    for row in means:
        assert board[row["visibility"], "agent-02"]["text_to_scene"] == pytest.approx(row["mean"], abs=1e-12)


def test_what_is_pending_stands_apart_with_its_coverage(made: MadeWarehouse) -> None:
    (row,) = rows(made.root, "SELECT * FROM leaderboard WHERE visibility = 'private' AND configuration = 'agent-01'")
    assert (row["model_score"], row["rank"], row["resolved"], row["planned"]) == (None, None, 23, 24)


def test_fewer_cases_than_others_are_no_better_score(tmp_path: Path) -> None:
    """A configuration that was planned on a part of the cases is apart too, though each of its own has an outcome."""
    made = MadeWarehouse(tmp_path, ABILITIES)
    made.write()
    schedule = tmp_path / "schedule" / "suite=made" / "configuration=agent-03" / "made-judge.parquet"
    kept = pq.ParquetFile(schedule).read()
    pq.write_table(kept.slice(1), schedule, compression="zstd")
    rebuild(tmp_path)
    board = {row["configuration"]: row for row in rows(tmp_path, "SELECT * FROM leaderboard")}
    assert [board[name]["rank"] for name in made.names()] == [1, 2, None]
    assert (board["agent-03"]["cases"], board["agent-03"]["of_cases"]) == (94, 95)


def test_a_study_says_which_panel_it_wants_to_know(made: MadeWarehouse, tmp_path: Path) -> None:
    main, options = study_named("main-results"), StudyOptions(draws=100)
    with pytest.raises(BadInput, match="2 panels: private, public"):
        answer(made.root, main, WantedScope(), options, tmp_path)
    found = answer(made.root, main, WantedScope(visibility="private"), options, tmp_path)
    assert found.scope["visibility"] == "private"
    assert [row["configuration"] for row in found.findings.tables[1].rows] == ["agent-01"]
    both = answer(made.root, study_named("selective-repair"), WantedScope(), StudyOptions(), tmp_path)
    assert "visibility" not in both.scope
