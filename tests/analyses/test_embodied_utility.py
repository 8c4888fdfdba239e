"""The study of embodied utility: the paper's panels from records that have its printed means, and its rules."""

from __future__ import annotations

import csv
from typing import Any

import numpy as np
import pandas as pd
import pytest
from shared import SHARED

from c4s.protocol.baselines import NOOP
from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, TEXT_TO_SCENE, Setting
from c4s.records.analysis import Findings, Table
from warehouse.analyses import StudyOptions
from warehouse.analyses.embodied_utility import compute

TABLES = SHARED / "reference/tables"
here = pytest.mark.skipif(not TABLES.is_dir(), reason="the paper's tables are not beside")


def record(agent: str, setting: Setting, case: int, utility: float | None, **own: Any) -> dict[str, Any]:
    """One trial as the study's source tells it; a utility of None is withheld."""
    return {
        "configuration": agent,
        "client": agent if agent == NOOP else "api",
        "ranked": True,
        "setting": setting,
        "case_id": f"{setting}-{case:02d}",
        "scene_id": f"{setting}-scene-{case:02d}",
        "repeat": 1,
        "score": 0.5,
        "walked": "not_evaluated" if utility is None else "measured",
        "utility": np.nan if utility is None else utility,
        "approachability": np.nan if utility is None else utility,
        "completion": np.nan if not utility else 1.0,
        "because": None if utility is not None else "no_route",
        "excluded": None if utility is not None else False,
        **own,
    }


def study(rows: list[dict[str, Any]], *agents: str) -> Findings:
    return compute({"trials": pd.DataFrame(rows)}, StudyOptions(agents=list(agents)))


def table(found: Findings, name: str) -> Table:
    return next(one for one in found.tables if one.name == name)


def printed(name: str) -> list[dict[str, str]]:
    return [*csv.DictReader((TABLES / f"{name}.csv").open())]


def as_printed(row: dict[str, str], setting: Setting, planned: int) -> list[dict[str, Any]]:
    """Records with a row's printed counts and measured mean; those that were not retained are excluded."""
    scored, zero, withheld = (int(row[name]) for name in ("scored", "zero", "withheld"))
    value = float(row["measured"]) * (scored + zero) / scored
    values: list[float | None] = [value] * scored + [0.0] * zero + [None] * withheld
    made = [record(row["agent"], setting, case, one) for case, one in enumerate(values)]
    not_read = {"because": "content_failure", "excluded": True}
    return made + [record(row["agent"], setting, case, None, **not_read) for case in range(len(values), planned)]


@here
@pytest.mark.parametrize(
    ("name", "setting", "panel", "planned"),
    [
        ("eus_A_construction", TEXT_TO_SCENE, "panel_text_to_scene", 30),
        ("eus_B_outdoor_edit", OUTDOOR_REPAIR, "panel_image_to_scene_outdoor", 71),
    ],
)
def test_the_panels_of_the_paper(name: str, setting: Setting, panel: str, planned: int) -> None:
    paper = printed(name)
    found = table(study([one for row in paper for one in as_printed(row, setting, planned)]), panel)
    ours = {str(row["configuration"]): row for row in found.rows}
    for row in paper:
        mine = ours[row["agent"]]
        assert mine["eus"] == pytest.approx(float(row["eus"]), abs=0.0011)
        assert mine["measured"] == pytest.approx(float(row["measured"]), abs=1e-9)
        assert round(100 * float(mine["coverage"] or 0)) == int(row["coverage_pct"])
        for count in ("scored", "zero", "withheld", "records"):
            assert mine[count] == int(row[count])
        assert mine["absent"] == planned - int(row["records"])
    best = [str(row["configuration"]) for row in found.rows[:2]]
    assert best == [row["agent"] for row in paper[:2]]


@here
def test_changes_against_the_input_and_rooms_as_units() -> None:
    paper = printed("eus_B_outdoor_edit")
    rows = [record(NOOP, OUTDOOR_REPAIR, case, 0.264) for case in range(71)]
    rows += [one for row in paper for one in as_printed(row, OUTDOOR_REPAIR, 71)]
    changes = {row["configuration"]: row["change"] for row in table(study(rows), "change_image_to_scene_outdoor").rows}
    assert changes["Gemini 3.8 Flash (high)"] == pytest.approx(0.059, abs=0.0011)
    assert changes["GPT-5.6 Sol (high)"] == pytest.approx(-0.019, abs=0.0011)
    others = [value for name, value in changes.items() if name != "Gemini 3.8 Flash (high)"]
    assert (min(others), max(others)) == (pytest.approx(-0.031, abs=0.0011), pytest.approx(0.014, abs=0.0011))
    rooms = []
    for row in printed("eus_C_indoor_rooms"):
        for case in range(80):
            room, measured = case % 10, int(row["rooms_measured"])
            value = float(row["mean_eus"]) if room < measured else None
            rooms.append(record(row["agent"], INDOOR_REPAIR, case, value, scene_id=f"room-{room}"))
    ours = {row["configuration"]: row for row in table(study(rooms), "rooms").rows}
    for row in printed("eus_C_indoor_rooms"):
        assert ours[row["agent"]]["rooms_measured"] == int(row["rooms_measured"])
        assert ours[row["agent"]]["rooms"] == 10
        assert ours[row["agent"]]["mean"] == pytest.approx(float(row["mean_eus"]))


@here
def test_the_alignment_and_the_paired_difference_of_construction() -> None:
    paper = printed("eus_A_construction")
    rows = [one for row in paper for one in as_printed(row, TEXT_TO_SCENE, 30)]
    for one in rows:
        one["score"] = 0.3 + 0.5 * next(float(row["eus"]) for row in paper if row["agent"] == one["configuration"])
    aligned = {row["variant"]: row for row in table(study(rows), "alignment").rows}
    assert aligned["conservative"]["n"] == 9
    assert aligned["conservative"]["pearson"] == pytest.approx(1.0, abs=1e-3)
    assert 0.9 < float(aligned["measured"]["spearman"] or 0) <= 1.0
    two = ("Gemini 3.8 Flash (high)", "GPT-5.6 Sol (high)")
    (row,) = table(study(rows, *two), "difference").rows
    assert row["pairs"] == 30 and row["change"] == pytest.approx(0.002, abs=0.0011) and float(row["se"] or 0) > 0


def test_a_withheld_scene_is_no_zero_and_few_scenes_have_no_error() -> None:
    rows = [record("a", OUTDOOR_REPAIR, case, value) for case, value in enumerate([1.0, 0.0, None, 0.5])]
    (row,) = table(study(rows), "panel_image_to_scene_outdoor").rows
    assert (row["eus"], row["measured"], row["coverage"]) == (0.375, 0.5, 0.75)
    assert (row["scored"], row["zero"], row["withheld"], row["records"], row["se"]) == (2, 1, 1, 4, None)
    assert row["W"] == 1.0 and row["A"] == 0.5
    found = study(rows)
    assert [dict(one) for one in table(found, "reasons").rows] == [
        {"configuration": "a", "setting": OUTDOOR_REPAIR, "because": "no_route", "trials": 1}
    ]


def test_trials_without_a_scene_are_no_records() -> None:
    rows = [record("a", TEXT_TO_SCENE, case, None, walked=None, because=None, excluded=None) for case in range(3)]
    (row,) = table(study(rows), "panel_text_to_scene").rows
    assert (row["records"], row["absent"], row.get("eus")) == (0, 3, None)
