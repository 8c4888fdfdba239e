"""The leaderboard in SQL gives what the score package gives, and gates on coverage."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory

import pyarrow.parquet as pq
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.protocol.settings import SETTINGS
from c4s.score.aggregate import aggregate
from warehouse import refresh
from warehouse.analyses import StudyOptions, WantedScope, answer, study_named
from warehouse.database import ask, rebuild, rows
from warehouse.frames import export
from warehouse.parquet import write_part
from warehouse.records import OutcomeRow, ScheduleRow

CASES = {"text-to-scene": 3, "image-to-scene/indoor": 2, "image-to-scene/outdoor": 4}
AGENTS = ("alpha", "beta", "gamma")
SCORES = st.sampled_from([None, 0.0, 0.2, 0.25, 1.0, 0.123456])


def _store(
    root: Path,
    scores: dict[tuple[str, str, int], float | None],
    *,
    judge: str = "rule",
    judge_version: str = "v1",
    unranked: tuple[str, ...] = (),
    content: str = "",
    build: tuple[str, str] = ("d", "2026-01-01"),
    repeat: int = 1,
) -> None:
    for (agent, setting, number), score in scores.items():
        key = f"{agent}-{setting.replace('/', '-')}-{number}-{judge}-{judge_version}-{content}-{build[0]}-{repeat}"
        base = {
            "trial_id": key,
            "run_id": "run",
            "suite": "s",
            "suite_digest": build[0],
            "configuration": agent,
            "configuration_digest": content or agent,
            "repeat": repeat,
            "case_id": f"{setting}-{number}",
        }
        shared = {
            "setting": setting,
            "scene_id": "scene",
            "policy": "p",
            "judge": judge,
            "judge_version": judge_version,
            "engine": "headless",
            "ranked": agent not in unranked,
        }
        write_part(
            root,
            "schedule",
            [
                ScheduleRow(
                    **base,
                    **shared,
                    planned_at=build[1],
                    client=agent,
                    model=None,
                    title="",
                    prompt="",
                    operations="",
                    operation_group=None,
                    difficulty=None,
                    visibility="public",
                    proxy_assets=False,
                )
            ],
            suite="s",
            configuration=agent,
            key=key,
        )
        if score is None:
            continue
        write_part(
            root,
            "outcomes",
            [
                OutcomeRow(
                    **base,
                    **shared,
                    status="measured",
                    score=score,
                    reason="",
                    detailed=None,
                    known_coverage=None,
                    overview=None,
                    physics=0.5,
                    repair_precision=None,
                    repair_recall=None,
                    repair_f1=score,
                    attempts=1,
                    retained_attempt=1,
                    tool_calls=1,
                    attempt_wall_s=1.0,
                    evaluation_s=1.0,
                    orchestration_s=0.0,
                    input_tokens=None,
                    output_tokens=None,
                    cost_usd=None,
                    score_sha256="0",
                )
            ],
            suite="s",
            configuration=agent,
            key=key,
        )
    rebuild(root)


def test_rows_of_another_version_are_named_and_nothing_is_replaced(tmp_path: Path) -> None:
    _store(tmp_path, {("alpha", "text-to-scene", 0): 1.0})
    before = (tmp_path / "c4s.duckdb").read_bytes()
    (part,) = (tmp_path / "outcomes").rglob("*.parquet")
    pq.write_table(pq.read_table(part, partitioning=None).drop_columns(["physics"]), part)
    with pytest.raises(BadInput, match=r"'outcomes' have other columns.*--from-runs"):
        rebuild(tmp_path)
    assert (tmp_path / "c4s.duckdb").read_bytes() == before


def _grid() -> list[tuple[str, str, int]]:
    return [(agent, setting, number) for agent in AGENTS for setting in SETTINGS for number in range(CASES[setting])]


@settings(max_examples=12, deadline=None)
@given(st.lists(SCORES, min_size=len(_grid()), max_size=len(_grid())))
def test_the_sql_agrees_with_the_score_package(values: list[float | None]) -> None:
    scores = dict(zip(_grid(), values, strict=True))
    wanted = aggregate(
        [
            {
                "model": agent,
                "setting": setting,
                "case_id": f"{setting}-{number}",
                "score": score,
                "repair_f1": score,
                "physics": 0.5,
            }
            for (agent, setting, number), score in scores.items()
            if score is not None
        ]
        or [{"model": "alpha", "setting": "text-to-scene", "case_id": "text-to-scene-0", "score": 0.0}],
        schedule={setting: [f"{setting}-{n}" for n in range(CASES[setting])] for setting in SETTINGS},
        missing_as_zero=False,
    )
    with TemporaryDirectory() as folder:
        _store(Path(folder), scores)
        found = {row["configuration"]: row for row in rows(Path(folder), "SELECT * FROM leaderboard")}
    assert set(found) == set(AGENTS)
    for line in wanted:
        row = found[line["model"]]
        for ours, theirs in (
            ("model_score", "model_score"),
            ("text_to_scene", "t2s_score"),
            ("image_to_scene", "i2s_score"),
            ("indoor", "indoor_i2s_score"),
        ):
            if line[theirs] is None or all(score is None for key, score in scores.items() if key[0] == line["model"]):
                continue
            assert row[ours] == pytest.approx(line[theirs], abs=1e-12)
        if line["model_score"] is not None:
            assert row["rank"] == line["model_rank"]
    for agent, row in found.items():
        if any(score is None for key, score in scores.items() if key[0] == agent):
            assert row["model_score"] is None and row["rank"] is None


def test_other_judges_and_validating_agents_are_never_ranked_together(tmp_path: Path) -> None:
    high, low = dict.fromkeys(_grid(), 0.9), dict.fromkeys(_grid(), 0.1)
    _store(tmp_path, high, unranked=("gamma",))
    _store(tmp_path, low, judge="model")
    _store(tmp_path, low, judge="model", judge_version="v2")
    ranks: dict[tuple[str, str], set[int | None]] = {}
    for row in rows(tmp_path, "SELECT * FROM leaderboard"):
        ranks.setdefault((row["judge"], row["configuration"]), set()).add(row["rank"])
    assert {(row["judge"], row["judge_version"]) for row in rows(tmp_path, "SELECT * FROM sanity_ladder")} == {
        ("rule", "v1"),
        ("model", "v1"),
        ("model", "v2"),
    }
    found = {key: rank for key, (rank,) in ranks.items()}
    assert found == {
        ("rule", "alpha"): 1,
        ("rule", "beta"): 1,
        ("rule", "gamma"): None,
        ("model", "alpha"): 1,
        ("model", "beta"): 1,
        ("model", "gamma"): 1,
    }


def test_what_is_pending_is_no_zero_in_any_mean(tmp_path: Path) -> None:
    scores: dict[tuple[str, str, int], float | None] = {("alpha", "image-to-scene/indoor", n): 1.0 for n in range(2)}
    scores |= {("alpha", "image-to-scene/outdoor", n): None for n in range(2)}
    _store(tmp_path, scores)
    rebuild(tmp_path)
    (board,) = rows(tmp_path, "SELECT * FROM leaderboard")
    assert board["indoor"] is not None
    assert board["image_to_scene"] is board["repair_f1"] is board["image_physics"] is board["outdoor"] is None
    (ladder,) = rows(tmp_path, "SELECT * FROM sanity_ladder")
    assert ladder["lowest_f1"] == ladder["highest_f1"] == ladder["lowest_repair_score"] == 1.0


def test_a_case_that_was_repeated_more_often_weighs_no_more(tmp_path: Path) -> None:
    scores: dict[tuple[str, str, int], float | None] = {
        ("alpha", setting, number): float(number == 0) for setting in SETTINGS for number in range(CASES[setting])
    }
    _store(tmp_path, scores)
    for repeat in (2, 3):
        _store(tmp_path, {key: score for key, score in scores.items() if key[2] == 0}, repeat=repeat)
    (row,) = rows(tmp_path, "SELECT * FROM leaderboard")
    assert (row["text_to_scene"], row["indoor"], row["outdoor"]) == (1 / 3, 1 / 2, 1 / 4)
    assert row["image_to_scene"] == pytest.approx(2 / 6) == row["repair_f1"]
    assert (row["planned"], row["cases"], row["indoor_cases"]) == (15, 9, 2)


def test_the_same_scores_in_another_order_share_a_rank(tmp_path: Path) -> None:
    forth, back = (0.1, 0.2, 0.3), (0.3, 0.2, 0.1)
    assert sum(forth) != sum(back)
    scores = {
        (agent, setting, number): own[number % 3]
        for agent, own in (("alpha", forth), ("beta", back), ("gamma", forth))
        for setting in SETTINGS
        for number in range(3)
    }
    _store(tmp_path, scores)
    assert [row["rank"] for row in rows(tmp_path, "SELECT rank FROM leaderboard")] == [1, 1, 1]
    answered = answer(tmp_path, study_named("main-results"), WantedScope(), StudyOptions(), tmp_path / "answers")
    assert [row["rank"] for row in answered.findings.tables[0].rows] == [1, 1, 1]


def test_an_empty_warehouse_answers_and_a_wrong_query_is_one_line(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="no warehouse"):
        ask(tmp_path, "SELECT 1")
    rebuild(tmp_path)
    assert ask(tmp_path, "SELECT * FROM leaderboard")[1] == []
    with pytest.raises(BadInput) as caught:
        ask(tmp_path, "SELECT nosuch FROM outcomes")
    assert "\n" not in caught.value.line() and "nosuch" in caught.value.line()
    with pytest.raises(BadInput):
        ask(tmp_path, "DELETE FROM outcomes")


def test_rows_leave_as_a_file_for_pandas(tmp_path: Path) -> None:
    import pandas as pd

    _store(tmp_path, dict.fromkeys(_grid(), 0.25))
    for name, read in (("rows.csv", pd.read_csv), ("rows.parquet", pd.read_parquet)):
        assert export(tmp_path, "SELECT configuration, model_score FROM leaderboard", tmp_path / name) == 3
        found = read(tmp_path / name)
        assert list(found["configuration"]) == list(AGENTS) and set(found["model_score"]) == {0.25}
    with pytest.raises(BadInput, match="cannot write"):
        export(tmp_path, "SELECT 1", tmp_path / "rows.docx")


def test_two_contents_of_one_name_are_two_rows(tmp_path: Path) -> None:
    """A configuration that took the name of a good one has its own score."""
    good, bad = dict.fromkeys(_grid(), 0.9), dict.fromkeys([key for key in _grid() if key[0] == "alpha"], 0.1)
    _store(tmp_path, good, content="1" * 64)
    _store(tmp_path, bad, content="2" * 64)
    board = {row["configuration"]: row for row in rows(tmp_path, "SELECT * FROM leaderboard")}
    assert {name: row["model_score"] for name, row in board.items()} == pytest.approx(
        {"alpha @111111": 0.9, "alpha @222222": 0.1, "beta": 0.9, "gamma": 0.9}
    )
    assert board["alpha @222222"]["rank"] == 4 and board["alpha @222222"]["configuration_digest"] == "2" * 64
    for question in ("coverage", "sanity_ladder", "case_scores", "setting_means"):
        names = {row["configuration"] for row in rows(tmp_path, f"SELECT * FROM {question}")}
        assert names == set(board), question


def test_contents_whose_digests_begin_alike_are_not_one_row(tmp_path: Path) -> None:
    scores = [dict.fromkeys([key for key in _grid() if key[0] == "alpha"], value) for value in (0.25, 0.75)]
    for number, values in enumerate(scores):
        _store(tmp_path, values, content="111111" + str(number) * 58)
    found = rows(tmp_path, "SELECT * FROM leaderboard")
    assert sorted(row["model_score"] for row in found) == pytest.approx([0.25, 0.75])
    ladder = rows(tmp_path, "SELECT trials FROM sanity_ladder")
    assert [row["trials"] for row in ladder] == [9, 9]


def test_the_leaderboard_is_of_the_latest_build_and_no_two_builds_are_mixed(tmp_path: Path) -> None:
    _store(tmp_path, dict.fromkeys(_grid(), 1.0), build=("old", "2026-01-01T10:00:00.000+00:00"))
    _store(tmp_path, dict.fromkeys(_grid(), 0.5), build=("new", "2026-03-01T10:00:00.000+00:00"))
    latest = rows(tmp_path, "SELECT * FROM leaderboard")
    assert {row["suite_digest"] for row in latest} == {"new"}
    assert {row["model_score"] for row in latest} == {0.5} and {row["planned"] for row in latest} == {9}
    every = rows(tmp_path, "SELECT suite_digest, latest, configuration, model_score, rank FROM leaderboards")
    assert [(row["suite_digest"], row["latest"], row["model_score"], row["rank"]) for row in every] == (
        [("new", True, 0.5, 1)] * 3 + [("old", False, 1.0, 1)] * 3
    )
    assert {row["build"] for row in rows(tmp_path, "SELECT * FROM coverage")} == {"old", "new"}
    assert {row["highest_repair_score"] for row in rows(tmp_path, "SELECT * FROM sanity_ladder")} == {0.5}


@pytest.mark.parametrize(
    "query",
    [
        "SELECT * FROM read_csv('/etc/passwd')",
        "SELECT * FROM '/etc/passwd'",
        "SELECT content FROM read_text('/etc/passwd')",
        "SELECT content FROM read_text('{root}/../secret')",
        "SELECT * FROM glob('/etc/*')",
        "SELECT * FROM query('SELECT * FROM read_text(''/etc/passwd'')')",
        "COPY outcomes TO '{root}/outcomes/forged.parquet'",
        "COPY (SELECT 1) TO '/tmp/c4s-never.csv'",
        "EXPORT DATABASE '{root}/all'",
        "ATTACH '/tmp/c4s-never.db'",
        "INSTALL httpfs",
        "LOAD httpfs",
        "SET enable_external_access = true",
        "SELECT 1; SET lock_configuration = false",
        "SELECT 1; SELECT 2",
        "CREATE TEMP TABLE outcomes AS SELECT 1",
        "DROP VIEW leaderboard",
        "PRAGMA database_list",
        "CALL force_checkpoint()",
        "SELECT * FROM columns",
        "",
        "-- nothing",
        "SELECT count(*) FROM (SELECT DISTINCT a, hash(a) FROM range(1000000000) AS t(a))",
    ],
)
def test_a_question_reads_the_warehouse_and_nothing_else(
    tmp_path: Path, query: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = tmp_path / "warehouse"
    _store(root, {("alpha", "text-to-scene", 0): 0.5})
    (tmp_path / "secret").write_text("truth")
    before = sorted(root.rglob("*"))
    monkeypatch.setitem(refresh.LIMITS, "memory_limit", "100MB")
    with pytest.raises(BadInput) as caught:
        ask(root, query.format(root=root))
    assert "\n" not in caught.value.line()
    assert sorted(root.rglob("*")) == before
    assert len(ask(root, "EXPLAIN SELECT * FROM leaderboard")[1]) > 0
    assert ask(root, "SELECT count(*) FROM outcomes")[1] == [(1,)]
