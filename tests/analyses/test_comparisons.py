"""Paired differences, power and stability over warehouses of known truth."""

from __future__ import annotations

from pathlib import Path

import pyarrow.parquet as pq
import pytest

from bench.made_warehouse import PUBLIC_SET, SUITE, MadeWarehouse
from c4s.errors import BadInput
from c4s.protocol.settings import SETTING_TITLES, SETTINGS
from tests.analyses.made import ask
from warehouse.analyses import STUDIES, replay
from warehouse.database import rebuild

FEW = [(setting, 8, 4) for setting in SETTINGS]


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> MadeWarehouse:
    warehouse = MadeWarehouse(
        tmp_path_factory.mktemp("warehouse"),
        (0.7, 0.55, 0.5, 0.3),
        repeats=2,
        pending=frozenset({("agent-04", "indoor-03")}),
    )
    warehouse.write()
    return warehouse


@pytest.fixture(scope="module")
def few(tmp_path_factory: pytest.TempPathFactory) -> MadeWarehouse:
    warehouse = MadeWarehouse(tmp_path_factory.mktemp("few"), (0.7, 0.4), shape=FEW)
    warehouse.write()
    return warehouse


def test_a_difference_is_the_mean_over_the_same_cases(made: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(made.root, "paired", tmp_path, agents=["agent-01", "agent-02"], draws=1000).findings
    rows = {row["cases_of"]: row for row in findings.tables[0].rows}
    assert [*rows] == [*(SETTING_TITLES[setting] for setting in SETTINGS), "Image to scene", "Model score"]
    scores = {
        name: pq.read_table(made.root / f"outcomes/suite={SUITE}/configuration={name}").to_pandas()
        for name in ("agent-01", "agent-02")
    }
    means = {name: table.groupby("setting")["score"].mean() for name, table in scores.items()}
    for setting, cases, sources in PUBLIC_SET:
        row = rows[SETTING_TITLES[setting]]
        assert row["score"] == pytest.approx(100 * (means["agent-01"] - means["agent-02"])[setting])
        assert (row["cases"], row["sources"]) == (cases, sources)
        assert row["score_low"] < row["score"] < row["score_high"] and row["score_p"] < 0.02
        assert row["calls_low"] < row["calls"] < row["calls_high"]
    halves = (rows[SETTING_TITLES[SETTINGS[0]]]["score"] + rows["Image to scene"]["score"]) / 2
    assert rows["Model score"]["score"] == pytest.approx(halves)


def test_the_other_way_round_is_the_same_difference(made: MadeWarehouse, tmp_path: Path) -> None:
    one, other = (
        ask(made.root, "paired", tmp_path, agents=agents, draws=500).findings.tables[0].rows
        for agents in (["agent-01", "agent-02"], ["agent-02", "agent-01"])
    )
    for row, turned in zip(one, other, strict=True):
        assert turned["score"] == pytest.approx(-row["score"]) and turned["score_p"] == row["score_p"]
        assert turned["score_low"] == pytest.approx(-row["score_high"])


def test_holm_adjusts_all_tests_of_the_answer(made: MadeWarehouse, tmp_path: Path) -> None:
    agents = ["agent-02", "agent-03"]
    rows = ask(made.root, "paired", tmp_path, agents=agents, holm=True, draws=500).findings.tables[0].rows
    tests = [(row[f"{name}_p"], row[f"{name}_p_holm"]) for row in rows for name in ("score", "calls")]
    assert all(p <= adjusted <= 1 for p, adjusted in tests)
    assert min(adjusted for _, adjusted in tests) == pytest.approx(min(1, len(tests) * min(p for p, _ in tests)))


def test_four_sources_give_a_p_and_say_how_blunt_it_is(few: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(few.root, "paired", tmp_path, agents=["agent-01", "agent-02"]).findings
    assert not findings.intervals[0].honest and "score_low" not in findings.tables[0].rows[0]
    assert findings.tables[0].rows[0]["score_p"] == 0.125
    assert any(f"{SETTING_TITLES[SETTINGS[0]]} 0.125" in note for note in findings.notes)


def test_an_agent_less_itself_is_no_difference(tmp_path: Path) -> None:
    alike = MadeWarehouse(tmp_path / "alike", (0.5, 0.5), shape=[(setting, 9, 9) for setting in SETTINGS], seed=3)
    alike.write()
    for table in ("outcomes", "attempts"):
        folder = alike.root / table / f"suite={SUITE}"
        (path,) = (folder / "configuration=agent-01").glob("*.parquet")
        rows = pq.read_table(path, partitioning=None)
        (other,) = (folder / "configuration=agent-02").glob("*.parquet")
        ids = pq.read_table(other, partitioning=None)["trial_id"].to_pylist()
        rows = rows.set_column(rows.column_names.index("trial_id"), rows.schema.field("trial_id"), [ids])
        pq.write_table(rows, folder / "configuration=agent-02" / path.name)
    rebuild(alike.root)
    rows = ask(alike.root, "paired", tmp_path / "answers", agents=["agent-01", "agent-02"]).findings.tables[0].rows
    assert {(row["score"], row["score_p"], row["calls"], row["calls_p"]) for row in rows} == {(0.0, 1.0, 0.0, 1.0)}
    power = ask(alike.root, "power", tmp_path / "answers").findings.tables[0].rows
    assert {(row["error"], row["sources_needed"]) for row in power} == {(0.0, None)}


@pytest.mark.parametrize(
    ("study", "agents", "words"),
    [
        ("paired", [], "two configurations are compared"),
        ("paired", ["agent-01", "agent-01"], "named twice"),
        ("paired", ["agent-01", "agent-04"], "agent-04 has an outcome of 188 of 190 trials"),
        ("paired", ["agent-01", "agent-9"], "did you mean"),
        ("power", ["agent-01"], "two configurations are told apart"),
        ("stability", ["agent-01"], "no order"),
        ("case-difficulty", ["agent-01"], "tells no case"),
    ],
)
def test_what_cannot_be_compared_is_refused(made, tmp_path, study, agents, words) -> None:
    with pytest.raises(BadInput, match=words):
        ask(made.root, study, tmp_path, agents=agents)


def test_power_tells_what_the_suite_can_find(made: MadeWarehouse, tmp_path: Path) -> None:
    power, larger, apart = ask(made.root, "power", tmp_path).findings.tables
    assert [row["configuration"] for row in apart.rows] == ["agent-04"]
    wide, narrow = (
        next(row for row in power.rows if row["cases_of"] == "Model score" and row["pair"].startswith(name))
        for name in ("agent-01", "agent-02")
    )
    assert wide["difference"] > wide["detectable"] and wide["sources_needed"] < wide["sources"]
    assert narrow["detectable"] > 2.5 * narrow["error"] and narrow["difference"] < wide["difference"]
    for title in {row["cases_of"] for row in larger.rows}:
        found = [row["detectable"] for row in larger.rows if row["cases_of"] == title]
        assert found == sorted(found, reverse=True) and found[0] > 1.9 * found[2]


def test_power_is_not_told_from_few_sources(few: MadeWarehouse, tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="no setting has 9 source scenes in each domain"):
        ask(few.root, "power", tmp_path)
    some = MadeWarehouse(tmp_path / "some", (0.7, 0.4), shape=[(SETTINGS[0], 12, 12), *FEW[1:]])
    some.write()
    findings = ask(some.root, "power", tmp_path).findings
    assert {row["cases_of"] for row in findings.tables[0].rows} == {SETTING_TITLES[SETTINGS[0]]}
    assert any(SETTING_TITLES[SETTINGS[1]] in note and "fewer than 9" in note for note in findings.notes)


def test_power_without_repeats_says_nothing_of_repeats(tmp_path: Path) -> None:
    once = MadeWarehouse(tmp_path / "once", (0.7, 0.4), shape=[(setting, 12, 12) for setting in SETTINGS])
    once.write()
    findings = ask(once.root, "power", tmp_path).findings
    assert all(row["repeats_needed"] is None for row in findings.tables[0].rows)
    assert any("Without repeats" in note for note in findings.notes)


def test_a_leaderboard_of_far_abilities_stands_and_of_near_ones_does_not(made, tmp_path: Path) -> None:
    findings = ask(made.root, "stability", tmp_path, draws=2000).findings
    board, shares, without, _ = findings.tables
    assert board.column("configuration") == ["agent-01", "agent-02", "agent-03"]
    assert board.rows[0]["leads"] == 1.0 and 0.5 < board.rows[1]["above_next"] <= 1.0
    for row in shares.rows:
        assert sum(row[f"rank_{rank}"] for rank in (1, 2, 3)) == pytest.approx(1)
    assert all(-1 <= row["tau"] < 1 for row in without.rows) and findings.charts[0].table == "rank_shares"


def test_few_sources_are_left_out_one_by_one_instead(few: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(few.root, "stability", tmp_path).findings
    assert findings.charts == [] and "leads" not in findings.tables[0].rows[0]
    assert findings.tables[0].rows[0]["without_worst"] >= 1


def test_what_only_checks_the_evaluator_is_compared_where_little_else_is_there(tmp_path: Path) -> None:
    """One ranked configuration beside another: both are in the order."""
    mixed = MadeWarehouse(tmp_path / "mixed", (0.7, 0.4), shape=FEW)
    mixed.write()
    for table in ("schedule", "outcomes"):
        (path,) = (mixed.root / table / f"suite={SUITE}/configuration=agent-02").glob("*.parquet")
        rows = pq.read_table(path, partitioning=None)
        ranked = rows.column_names.index("ranked")
        pq.write_table(rows.set_column(ranked, rows.schema.field("ranked"), [[False] * len(rows)]), path)
    rebuild(mixed.root)
    board = ask(mixed.root, "stability", tmp_path / "answers").findings.tables[0]
    assert board.column("configuration") == ["agent-01", "agent-02"]


def test_difficulty_is_of_the_cases_as_planted(made: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(made.root, "case-difficulty", tmp_path).findings
    cases, tiers, _ = findings.tables
    hardness = cases.column("difficulty")
    assert hardness == sorted(hardness, reverse=True) and len(hardness) == 95
    planted = dict(zip((case["case_id"] for case in made.cases()), made.planted["agent-02"], strict=True))
    hard, easy = ([planted[row["case"]] for row in rows] for rows in (cases.rows[:20], cases.rows[-20:]))
    assert sum(hard) / 20 < sum(easy) / 20 - 0.2
    assert sum(row["cases"] for row in tiers.rows) == 95 and all(-1 <= row["case_rest"] <= 1 for row in cases.rows)


@pytest.mark.parametrize("study", ["power", "stability", "case-difficulty", "repeats", "reliability", "drift"])
def test_answers_are_given_again_to_the_last_digit(made: MadeWarehouse, tmp_path: Path, study: str) -> None:
    options = {"draws": 300} if "draws" in STUDIES[study].takes else {}
    result = ask(made.root, study, tmp_path, **options)
    kept, again = replay(tmp_path, result.identity(), STUDIES)
    assert kept == again
    for chart in result.findings.charts:
        (table,) = [one for one in result.findings.tables if one.name == chart.table]
        for name in (chart.x, chart.y, chart.low, chart.high, chart.group, *chart.series):
            assert not name or any(name in row for row in table.rows), (chart.name, name)
