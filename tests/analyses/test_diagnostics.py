"""Repair, spatial and behaviour studies against the documents that were made, counted here in another way."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import pytest

from bench.made_verdicts import KINDS
from bench.made_warehouse import MadeWarehouse
from c4s.errors import BadInput
from c4s.records.analysis import Findings
from warehouse.analyses import StudyOptions, WantedScope, answer, study_named

Row = dict[str, Any]
MATERIALS = ["property.material_paths"]


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> MadeWarehouse:
    private = frozenset({"indoor-01", "outdoor-07"})
    warehouse = MadeWarehouse(tmp_path_factory.mktemp("made"), (0.7, 0.5, 0.4), documents=True, private=private)
    warehouse.write()
    return warehouse


def ask(made: MadeWarehouse, study: str, place: Path, panel: str | None = None, **options: object) -> Findings:
    wanted = WantedScope(visibility=panel)
    return answer(made.root, study_named(study), wanted, StudyOptions.parse(options), place).findings


def stored(made: MadeWarehouse, table: str, configuration: str = "", prefix: str = "") -> list[Row]:
    """Rows as they were written, of all or of a configuration and the cases that begin so."""
    found: list[Row] = []
    for name in made.names():
        if configuration in ("", name):
            rows = pq.read_table(made.root / table / f"suite=made/configuration={name}").to_pylist()
            found += [{**row, "configuration": name} for row in rows if row["case_id"].startswith(prefix)]
    return found


def repairs(made: MadeWarehouse) -> list[tuple[Row, Row]]:
    found = [(row, json.loads(row["document"])["measurements"]) for row in stored(made, "verdicts")]
    return [(row, told) for row, told in found if "profiles" in told]


def complete(made: MadeWarehouse, profile: str = "nominal") -> list[Row]:
    return [told for _, told in repairs(made) if told["profiles"][profile]["fn"] == 0]


def kept(told: Row) -> list[Row]:
    return [row for row in told["false_positives"] if not row.get("renamed_material")]


def table(findings: Findings, name: str) -> list[Row]:
    return next(one.rows for one in findings.tables if one.name == name)


def test_complete_recoveries_and_what_else_they_change(made: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(made, "selective-repair", tmp_path, draws=500)
    spoilt = [told for told in complete(made) if kept(told)]
    overall = table(findings, "domains")[0]
    assert (overall["count"], overall["of"]) == (len(spoilt), len(complete(made))) and spoilt
    assert overall["share_low"] < overall["share"] < overall["share_high"]
    rows = table(findings, "configurations")
    assert all(row["clean"] + row["spoilt"] + row["incomplete"] == row["cases"] for row in rows)
    for name in made.names():
        own = [told for row, told in repairs(made) if row["configuration"] == name and told["fn"] == 0]
        clean = sum(row["clean"] for row in rows if row["configuration"] == name)
        assert clean == sum(not kept(told) for told in own)


def test_kinds_overlap_and_what_saving_explains_is_left_out(made: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(made, "selective-repair", tmp_path, draws=500)
    for row, kind in zip(table(findings, "kinds"), (*KINDS, "repair_target_wrong"), strict=True):
        held = [sum(one["kind"] == kind for one in kept(told)) for told in complete(made)]
        assert (row["submissions"], row["actors"]) == (sum(map(bool, held)), sum(held))
    renamed = sum(len(told["false_positives"]) - len(kept(told)) for _, told in repairs(made))
    begins = f"{renamed} false positives that saving alone"
    assert renamed > 0 and any(note.startswith(begins) for note in findings.notes)


def test_tolerances_and_exclusions(made: MadeWarehouse, tmp_path: Path) -> None:
    *rows, confined = table(ask(made, "selective-repair", tmp_path, draws=500), "tolerances")
    for row, profile in zip(rows, ("strict", "nominal", "relaxed"), strict=True):
        own = complete(made, profile)
        assert (row["count"], row["of"]) == (sum(bool(kept(told)) for told in own), len(own))
    others = [[row for row in kept(told) if row.get("fields") != MATERIALS] for told in complete(made)]
    assert confined["count"] == sum(map(bool, others)) < rows[1]["count"]


def test_public_and_private_stand_apart(made: MadeWarehouse, tmp_path: Path) -> None:
    rows = table(ask(made, "selective-repair", tmp_path, draws=500), "domains")[1:]
    private = [told for row, told in repairs(made) if row["case_id"] in made.private and told["fn"] == 0]
    assert sum(row["of"] for row in rows if row["set"] == "private") == len(private) > 0


def test_spatial_errors_are_of_requirements_whose_entities_are_there(made: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(made, "conditional-spatial", tmp_path, "public", draws=500)
    told = [json.loads(row["document"])["measurements"].get("decisions", []) for row in stored(made, "verdicts")]
    decisions = [one for rows in told for one in rows]
    there = [one["status"] for one in decisions if one["existence"]["pass"]]
    every, *kinds = table(findings, "kinds")
    assert (every["asked"], every["of"]) == (len(decisions), len(there))
    assert (every["count"], every["open"]) == (there.count("MISMATCH"), there.count("UNKNOWN"))
    assert sum(row["of"] for row in kinds) == every["of"]


def test_python_operations_are_of_scripts_that_parse(made: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(made, "python-operations", tmp_path, agents=["agent-01"])
    scripts = stored(made, "python_submissions", "agent-01", "indoor")
    posed = [row for row in scripts if "pose_editing" in row["families"].split()]
    counted = [row for row in table(findings, "scripts") if "indoor" in row["setting"]]
    assert sum(row["pose_editing"] for row in counted) == len(posed) > 0
    (share,) = (row for row in table(findings, "shares") if "indoor" in row["setting"] and row["set"] == "public")
    public = [row for row in scripts if row["case_id"] not in made.private and row["parseable"]]
    held = [row for row in posed if row["case_id"] not in made.private]
    assert share["pose_editing"] == pytest.approx(len(held) / len(public))


def test_errors_are_shares_of_submissions_that_showed_one(made: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(made, "execution-errors", tmp_path)
    rows = table(findings, "errors")
    bearing = [row["errors"] for row in stored(made, "python_submissions") if row["errors"]]
    every = [row for row in rows if row["configuration"] == "sum of all" and row["setting"] == "all"]
    (both,) = (row for row in every if " or " in row["error"])
    assert both["of"] == len(bearing)
    assert both["submissions"] == sum(errors in ("AttributeError", "TypeError") for errors in bearing)


def test_calls_leave_status_checks_out(made: MadeWarehouse, tmp_path: Path) -> None:
    rows = table(ask(made, "tool-usage", tmp_path, agents=["agent-02"]), "calls")
    attempts = stored(made, "attempts", "agent-02", "text")
    (text,) = (row for row in rows if row["setting"].startswith("Text"))
    calls = sum(row["tool_calls"] - row["polling_calls"] for row in attempts)
    assert text["calls"] == pytest.approx(calls / len(attempts))
    assert text["calls"] == pytest.approx(text["python"] + text["other"])


def test_profiles_are_means_of_a_category(made: MadeWarehouse, tmp_path: Path) -> None:
    rows = table(ask(made, "profiles", tmp_path, "public"), "categories")
    groups = {case["case_id"]: case["operation_group"] for case in made.cases()}
    rows_of_it = [row for row in stored(made, "outcomes", "agent-03") if row["case_id"] not in made.private]
    scores = [row["score"] for row in rows_of_it if groups[row["case_id"]] == "Layout"]
    (own,) = (row for row in rows if row["configuration"] == "agent-03")
    assert own["Layout"] == pytest.approx(sum(scores) / len(scores))


@pytest.mark.parametrize("study", ["selective-repair", "conditional-spatial", "python-operations", "tool-usage"])
def test_an_agent_that_is_not_there_is_refused(made: MadeWarehouse, study: str, tmp_path: Path) -> None:
    with pytest.raises(BadInput):
        ask(made, study, tmp_path, agents=["nobody"])
