"""What cases cost and why some are worth zero, over a warehouse of known truth."""

from __future__ import annotations

from pathlib import Path

import pyarrow.parquet as pq
import pytest

from bench.made_warehouse import MadeWarehouse
from c4s.errors import BadInput
from c4s.meter.prices import COST_CLASSES
from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR
from c4s.records.analysis import Findings, Table
from warehouse.analyses import StudyOptions, WantedScope, answer, study_named

USD = [f"{name}_usd" for name in COST_CLASSES]
OUTDOOR = [f"outdoor-{place:02d}" for place in range(1, 51)]
ZEROS = {
    ("agent-01", "outdoor-01"): "no_submission",
    ("agent-01", "outdoor-02"): "no_submission",
    ("agent-01", "text-to-scene-01"): "unresolved_dependencies",
    ("agent-03", "indoor-01"): "",
}


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> MadeWarehouse:
    """The second configuration's use is known of 21 of 50 outdoor cases, the third's of none."""
    unknown = {("agent-02", case) for case in OUTDOOR[21:]} | {("agent-03", case) for case in OUTDOOR}
    warehouse = MadeWarehouse(
        tmp_path_factory.mktemp("warehouse"), (0.7, 0.5, 0.6), zeros=ZEROS, unpriced=frozenset(unknown)
    )
    warehouse.write()
    return warehouse


def ask(made: MadeWarehouse, place: Path, study: str, **options: object) -> Findings:
    return answer(made.root, study_named(study), WantedScope(), StudyOptions.parse(options), place).findings


def named(findings: Findings, name: str) -> Table:
    return next(table for table in findings.tables if table.name == name)


def test_tracks_weigh_by_their_planned_cases_and_means_cover_what_is_known(made: MadeWarehouse, tmp_path: Path) -> None:
    rows = {row["configuration"]: row for row in named(ask(made, tmp_path, "costs"), "costs_public").rows}
    for agent in ("agent-01", "agent-02"):
        attempts = pq.read_table(made.root / f"attempts/suite=made/configuration={agent}").to_pandas()
        usd = attempts[USD].sum(axis=1, skipna=False)
        track = attempts["case_id"].str.rpartition("-")[0]
        means = {name: usd[(track == name) & usd.notna()].mean() for name in set(track)}
        weighted = sum(means[name] * (track == name).mean() for name in means)
        assert rows[agent]["usd_per_case"] == pytest.approx(weighted, abs=1e-12)
        assert sum(float(rows[agent][name] or 0) for name in USD) == pytest.approx(weighted, abs=1e-12)
    assert [rows[agent]["covered"] for agent in sorted(rows)] == [95, 66, 45]
    assert rows["agent-02"][f"covered {OUTDOOR_REPAIR}"] == 21


def test_what_is_not_known_of_a_whole_track_has_no_cost_and_is_on_no_frontier(
    made: MadeWarehouse, tmp_path: Path
) -> None:
    rows = {row["configuration"]: row for row in named(ask(made, tmp_path, "costs"), "costs_public").rows}
    none = rows["agent-03"]
    assert none["usd_per_case"] is None and none["frontier"] == "unpriced"
    assert none[f"usd {INDOOR_REPAIR}"] is not None and none[f"usd {OUTDOOR_REPAIR}"] is None
    assert rows["agent-01"]["frontier"] == "frontier"


def test_no_price_at_all_is_refused(tmp_path: Path) -> None:
    cases = MadeWarehouse(tmp_path / "all", (0.5,)).cases()
    free = MadeWarehouse(tmp_path / "free", (0.5,), unpriced=frozenset(("agent-01", case["case_id"]) for case in cases))
    free.write()
    with pytest.raises(BadInput, match="no recorded run of a complete configuration is priced"):
        ask(free, tmp_path, "costs")


def test_zeros_are_counted_by_code_and_one_without_is_told(made: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(made, tmp_path, "zero-reasons")
    table, sums = named(findings, "zeros_public"), named(findings, "sums_public")
    assert [(row["configuration"], row["setting"], row["total"]) for row in table.rows] == [
        ("agent-01", "Image to scene, outdoor", 2),
        ("agent-01", "Text to scene", 1),
        ("agent-03", "Image to scene, indoor", 1),
    ]
    assert {row["reason"]: row["trials"] for row in sums.rows} == {
        "no_submission": 2,
        "unresolved_dependencies": 1,
        "untold": 1,
        "total": 4,
    }
    assert "4 of 285" in table.title


def test_a_suite_without_zeros_has_an_empty_table_and_no_chart(tmp_path: Path) -> None:
    fine = MadeWarehouse(tmp_path / "fine", (0.5,))
    fine.write()
    findings = ask(fine, tmp_path, "zero-reasons")
    assert not findings.charts and not named(findings, "zeros_public").rows
