"""Public and private cases: cohorts, validation, selection, difficulty, rates by domain, over a warehouse of known
truth."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pyarrow.parquet as pq
import pytest

from bench.made_warehouse import MadeWarehouse
from c4s.errors import BadInput
from c4s.protocol.settings import INDOOR_REPAIR, SETTINGS, is_construction
from c4s.records.analysis import Findings, Table
from reports.charts import chart_svg
from warehouse.analyses import StudyOptions, WantedScope, answer, study_named

ABILITIES = (0.75, 0.6, 0.62, 0.45, 0.3)
SHAPE = [(setting, 24, 9) for setting in SETTINGS]
PRIVATE = frozenset(
    f"{setting.rpartition('/')[2]}-{place:02d}" for setting in SETTINGS for place in range(1, 25) if place % 3 == 0
)
PENDING = ("agent-05", "indoor-03")


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> MadeWarehouse:
    """Two sets; the last configuration lacks a private case."""
    warehouse = MadeWarehouse(
        tmp_path_factory.mktemp("warehouse"), ABILITIES, SHAPE, private=PRIVATE, pending=frozenset({PENDING})
    )
    warehouse.write()
    return warehouse


def ask(made: MadeWarehouse, place: Path, study: str, **options: object) -> Findings:
    return answer(made.root, study_named(study), WantedScope(), StudyOptions.parse(options), place).findings


def named(findings: Findings, name: str) -> Table:
    return next(table for table in findings.tables if table.name == name)


def outcomes(made: MadeWarehouse) -> pd.DataFrame:
    paths = sorted(made.root.glob("outcomes/suite=made/*/*.parquet"))
    found = [pq.read_table(path).to_pandas().assign(configuration=path.parent.name[14:]) for path in paths]
    return pd.concat(found).assign(private=lambda rows: rows["case_id"].isin(PRIVATE))


def test_cohorts_count_the_complete_and_their_pairs(made: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(made, tmp_path, "cohorts")
    rows = {row["set"]: row for row in named(findings, "cohorts").rows}
    assert [(rows[name]["cases"], rows[name]["configurations"]) for name in rows] == [(48, 5), (24, 4), (72, 4)]
    assert [row["pairs"] for row in rows.values()] == [240, 96, 288]
    assert rows["full"]["indoor_weight"] == "1/2" and rows["public"]["indoor_scenes"] == 6
    assert [row["configuration"] for row in named(findings, "apart_private").rows] == ["agent-05"]


def test_the_public_set_is_held_against_all_cases(made: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(made, tmp_path, "public-private", pool=["agent-01", "agent-02"])
    rows = {row["score"]: row for row in named(findings, "validation").rows}
    trials = outcomes(made)
    own = trials[trials["configuration"] != "agent-05"]
    t2s = own[own["setting"].map(is_construction)]
    delta = t2s[~t2s["private"]].groupby("configuration")["score"].mean() - t2s.groupby("configuration")["score"].mean()
    assert rows["S_T2S"]["mean"] == pytest.approx(delta.mean(), abs=1e-12)
    assert rows["S_T2S"]["largest"] == pytest.approx(delta.abs().max(), abs=1e-12)
    assert rows["S_T2S"]["inside_pool"] == pytest.approx(delta.abs()[["agent-01", "agent-02"]].mean(), abs=1e-12)
    assert rows["S_model"]["tau_b"] == 1.0 and rows["S_model"]["reversed_pairs"] == 0
    parts = {(row["setting"], row["part"]) for row in named(findings, "parts").rows}
    assert ("Text to scene", "semantic score") in parts


def test_a_private_case_is_named_nowhere(made: MadeWarehouse, tmp_path: Path) -> None:
    for study in (
        "public-private",
        "set-selection",
        "cohorts",
        "difficulty",
        "repair-rates",
        "case-ranks",
        "costs",
        "weight-sensitivity",
        "zero-reasons",
    ):
        told = ask(made, tmp_path / study, study).model_dump_json()
        assert not [case for case in PRIVATE if f'"{case}"' in told], study


def test_a_suite_with_one_set_cannot_be_validated(tmp_path: Path) -> None:
    one = MadeWarehouse(tmp_path / "one", (0.5, 0.4, 0.3))
    one.write()
    with pytest.raises(BadInput, match="no two sets"):
        ask(one, tmp_path, "public-private")
    with pytest.raises(BadInput, match="needs 3 complete configurations, there are 2"):
        ask(one, tmp_path, "set-selection", pool=["agent-01", "agent-02"])


@pytest.mark.parametrize("study", ["public-private", "set-selection"])
def test_an_unknown_configuration_of_the_pool_is_refused(made: MadeWarehouse, tmp_path: Path, study: str) -> None:
    with pytest.raises(BadInput, match="unknown configuration 'nobody'"):
        ask(made, tmp_path, study, pool=["nobody"])


def test_greedy_sets_err_less_than_random_ones_and_larger_sets_less(made: MadeWarehouse, tmp_path: Path) -> None:
    rows = named(ask(made, tmp_path, "set-selection"), "methods").rows
    errors = {(row["method"], row["share"]): float(row["part_error"] or 0) for row in rows}
    for share in (0.5, 0.67):
        assert errors["greedy", share] < errors["random", share] < errors["middle scores", share]
    assert errors["random", 0.67] < errors["random", 0.5] < errors["random", 0.32]
    assert any(row["method"] == "the public set" and row["cases"] == 48 for row in rows)


def test_tiers_are_means_of_their_cases(made: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(made, tmp_path, "difficulty")
    row = next(row for row in named(findings, "tiers").rows if row["configuration"] == "agent-01")
    tiers = {case["case_id"]: case["difficulty"] for case in made.cases()}
    trials = outcomes(made).query("configuration == 'agent-01'")
    hard = trials[(trials["case_id"].map(tiers) == "hard") & ~trials["setting"].map(is_construction)]
    assert row["i2s_hard"] == pytest.approx(hard["score"].mean(), abs=1e-12)
    counts = {row["setting"]: row["cases"] for row in named(findings, "counts").rows}
    assert set(counts.values()) == {24}
    assert named(findings, "means").rows[0]["configurations"] == 4


def test_rates_are_means_over_cases_of_a_domain_and_set_inside_their_intervals(
    made: MadeWarehouse, tmp_path: Path
) -> None:
    findings = ask(made, tmp_path, "repair-rates", draws=500)
    trials = outcomes(made).query("configuration == 'agent-02' and not private")
    trials = trials[trials["setting"] == INDOOR_REPAIR]
    (row,) = (
        row
        for row in named(findings, "rates_public").rows
        if row["configuration"] == "agent-02" and row["domain"] == "Image to scene, indoor"
    )
    assert row["repair_f1"] == pytest.approx(trials["repair_f1"].mean(), abs=1e-12)
    assert [how.honest for how in findings.intervals] == [False, False]
    assert "repair_f1_low" not in row and "6 source scenes" in findings.intervals[0].proviso


def test_intervals_of_rates_are_given_where_sources_are_enough(tmp_path: Path) -> None:
    public = MadeWarehouse(tmp_path / "public", (0.6, 0.5))
    public.write()
    findings = ask(public, tmp_path, "repair-rates", draws=500)
    assert findings.intervals[0].honest
    for row in named(findings, "rates_public").rows:
        assert float(row["repair_f1_low"] or 0) < float(row["repair_f1"] or 0) < float(row["repair_f1_high"] or 0)


def test_the_order_of_repairs_by_the_adopted_weight_is_its_own(made: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(made, tmp_path, "weight-sensitivity")
    rows = named(findings, "sensitivity_public").rows
    assert [row["weight"] for row in rows] == [0.0, 0.25, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0]
    (adopted,) = (row for row in rows if row["weight"] == 0.8)
    assert (adopted["spearman"], adopted["tau_b"], adopted["largest_shift"]) == (pytest.approx(1.0), 1.0, 0.0)
    assert adopted["leader"] == "agent-01"
    scores = named(findings, "scores_public").rows
    trials = outcomes(made).query("configuration == 'agent-01' and not private")
    trials = trials[~trials["setting"].map(is_construction)]
    (own,) = (row for row in scores if row["weight"] == 0.8 and row["configuration"] == "agent-01")
    assert own["score"] == pytest.approx(trials["score"].mean(), abs=1e-12)


def test_ranks_by_case_share_the_smallest(made: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(made, tmp_path, "case-ranks")
    rows = pd.DataFrame(named(findings, "ranks").rows)
    assert rows["case"].nunique() == 48 and set(rows["of"]) == {5}
    for _, own in rows.groupby("case"):
        better = [(own["score"] > score).sum() + 1 for score in own["score"]]
        assert own["rank"].tolist() == better
    leads = named(findings, "leads")
    assert sum(int(row["leads_alone"] or 0) for row in leads.rows) == 48 and np.max(leads.column("last")) > 0


@pytest.mark.parametrize(
    "study", ["difficulty", "public-private", "set-selection", "weight-sensitivity", "case-ranks", "costs", "cohorts"]
)
def test_charts_are_drawn_of_columns_that_are_there(made: MadeWarehouse, tmp_path: Path, study: str) -> None:
    findings = ask(made, tmp_path, study)
    assert findings.charts
    for chart in findings.charts:
        columns = {column.name for column in named(findings, chart.table).columns}
        used = {chart.x, chart.y, chart.group, chart.label, chart.low, chart.high, *chart.series} - {None, ""}
        assert used <= columns
        assert "no value to show" not in chart_svg(findings, chart)
