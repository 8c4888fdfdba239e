"""Repeats, reliability, drift and judges over warehouses of known truth."""

from __future__ import annotations

from pathlib import Path

import pytest

from bench.made_warehouse import SPREAD_TRIAL, MadeWarehouse
from c4s.errors import BadInput
from c4s.protocol.settings import SETTINGS
from tests.analyses.made import add_decisions, add_evidence, add_tools, ask

SHAPE = [(SETTINGS[0], 40, 20), (SETTINGS[1], 60, 12), (SETTINGS[2], 60, 12)]


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> MadeWarehouse:
    warehouse = MadeWarehouse(tmp_path_factory.mktemp("warehouse"), (0.85, 0.5), repeats=4, shape=SHAPE)
    warehouse.write()
    add_tools(warehouse, lambda key: {"alike": 2, "other": key.repeat if key.configuration == "agent-01" else 2})
    return warehouse


def test_the_planted_spread_of_runs_is_found(made: MadeWarehouse, tmp_path: Path) -> None:
    spreads, passes, clean, _ = ask(made.root, "repeats", tmp_path, draws=500).findings.tables
    (row,) = [row for row in spreads.rows if row["configuration"] == "agent-02" and row["cases"] == 40]
    assert row["runs"] == 160 and row["run_sd"] == pytest.approx(SPREAD_TRIAL, rel=0.15)
    assert 0.4 < row["intraclass"] < 0.9
    ours = [row for row in passes.rows if row["configuration"] == "agent-01"]
    assert all(one["all"] <= other["all"] for one, other in zip(clean.rows, passes.rows, strict=True))
    assert [row["k"] for row in ours] == [1, 2, 3, 4] and ours[0]["any"] == pytest.approx(ours[0]["all"])
    assert ours[0]["any"] < ours[3]["any"] and ours[0]["all"] > ours[3]["all"]
    assert all(row["all_low"] <= row["all"] <= row["all_high"] and row["cases"] == 120 for row in ours)


def test_repeats_of_texts_alone_have_no_recovery(tmp_path: Path) -> None:
    texts = MadeWarehouse(tmp_path / "texts", (0.5, 0.4), repeats=2, shape=[(SETTINGS[0], 8, 4)])
    texts.write()
    findings = ask(texts.root, "repeats", tmp_path / "answers").findings
    assert len(findings.tables) == 2 and findings.charts == [] and len(findings.tables[0].rows) == 2
    reliability = ask(texts.root, "reliability", tmp_path / "answers").findings.tables[0].rows[0]
    assert reliability["outcome"] is None and reliability["overall"] == pytest.approx(reliability["resource"])


def test_consistency_is_of_recovery_tools_and_resources(made: MadeWarehouse, tmp_path: Path) -> None:
    first, second = ask(made.root, "reliability", tmp_path, draws=500).findings.tables[0].rows
    assert first["recovered"] > second["recovered"] and first["outcome"] < second["outcome"]
    assert first["outcome_unbiased"] < first["outcome"] and first["outcome_low"] < first["outcome"]
    assert 0.8 < first["trajectory"] < 1.0
    assert first["overall"] == pytest.approx((first["outcome"] + first["trajectory"] + first["resource"]) / 3)


@pytest.mark.parametrize("study", ["repeats", "reliability", "drift"])
def test_one_run_a_case_is_no_repeat(tmp_path: Path, study: str) -> None:
    once = MadeWarehouse(tmp_path / "once", (0.5,), shape=[(SETTINGS[0], 8, 4)])
    once.write()
    with pytest.raises(BadInput, match="run once"):
        ask(once.root, study, tmp_path / "answers")


def test_nights_without_drift_show_none(made: MadeWarehouse, tmp_path: Path) -> None:
    tests, nights, _ = ask(made.root, "drift", tmp_path, draws=500, holm=True).findings.tables
    for row in tests.rows:
        assert row["nights"] == 4 and row["cases"] == 160 and abs(row["slope"]) < 1.0
        assert row["slope_p"] <= row["slope_p_holm"] and row["slope_p"] > 0.01
    assert [row["change"] for row in nights.rows if row["night"] == 1] == [0.0, 0.0]
    assert all(row["change_low"] <= row["change"] <= row["change_high"] for row in nights.rows)


@pytest.fixture(scope="module")
def judged(tmp_path_factory: pytest.TempPathFactory) -> MadeWarehouse:
    """Two judges: the same evidence but of one configuration's first case, decisions turned on another."""
    warehouse = MadeWarehouse(tmp_path_factory.mktemp("judged"), (0.8, 0.5, 0.2), judges=("one", "other"))
    warehouse.write()
    last = warehouse.cases()[-1]["case_id"]
    add_evidence(
        warehouse,
        lambda judge, key: (
            f"{judge if (key.configuration, key.case_id) == ('agent-01', last) else ''}{key.configuration}{key.case_id}"
        ),
    )
    add_decisions(
        warehouse, lambda judge, key: ["MATCH", "MISMATCH" if (judge, key.case_id) == ("one", last) else "UNKNOWN"]
    )
    return warehouse


def test_judges_are_compared_where_the_evidence_is_the_same(judged: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(judged.root, "judge-agreement", tmp_path, draws=500).findings
    agreement, decisions, scenes = findings.tables
    (row,) = agreement.rows
    assert (row["first"], row["second"]) == ("one 1", "other 1")
    assert (row["scenes"], row["other_evidence"], row["configurations"]) == (3 * 95 - 1, 1, 3)
    assert row["order"] == 1.0 and row["alpha"] > 0.8 and row["bias_low"] < row["bias"] < row["bias_high"]
    assert len(scenes.rows) == row["scenes"]
    (told,) = decisions.rows
    assert told["decisions"] == 2 * (3 * 95 - 1) and told["alike"] == pytest.approx(1 - 2 / told["decisions"])
    assert told["turned"] == "MISMATCH to UNKNOWN 2" and 0.98 < told["kappa"] < 1


def test_one_judge_or_no_evidence_in_common_is_refused(made: MadeWarehouse, tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="no scored evidence"):
        ask(made.root, "judge-agreement", tmp_path)
    apart = MadeWarehouse(tmp_path / "apart", (0.5,), judges=("one", "other"), shape=[(SETTINGS[0], 4, 4)])
    apart.write()
    add_evidence(apart, lambda judge, key: f"{judge}{key.case_id}")
    with pytest.raises(BadInput, match="same evidence"):
        ask(apart.root, "judge-agreement", tmp_path)
