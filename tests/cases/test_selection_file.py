"""A suite file takes its public cases from a selection file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml

from c4s.errors import BadInput
from c4s.records.level import Level, LevelActor
from cases.workshop import read_definition

VIEWS = [{"name": f"view-0{n}", "location_cm": [300 * n, 200, 180], "target_cm": [0, 0, 60]} for n in (1, 2)]


@pytest.fixture
def suite(tmp_path: Path) -> Path:
    """A suite file of two cases that names a selection."""
    actors = [
        LevelActor(name=name, label=name, class_path="/Script/Engine.StaticMeshActor", guid=guid * 32)
        for name, guid in (("Chair", "A"), ("Table", "B"))
    ]
    Level(package="/Game/Shop", actors=actors).write(tmp_path / "shop.level.json")
    repairs = [
        {"case_id": f"shop-{one}", "scene_id": "shop", "corruptions": [{"kind": "removal", "actor": one}]}
        for one in ("Chair", "Table")
    ]
    (tmp_path / "suite.yaml").write_text(
        yaml.safe_dump(
            {
                "suite_id": "shop",
                "title": "Shop",
                "scenes": [{"scene_id": "shop", "level": "shop.level.json", "environment": "indoor", "packs": ["p"]}],
                "repairs": [entry | {"views": VIEWS} for entry in repairs],
                "visibility": "selection.yaml",
            }
        )
    )
    return tmp_path


def select(suite: Path, **fields: Any) -> None:
    told = {
        "suite_id": "shop",
        "suite_digest": "d" * 64,
        "pool": {},
        "sets": [{"size": 1, "cases": ["shop-Chair"]}],
        "visibility": {"shop-Table": "private"},
    }
    (suite / "selection.yaml").write_text(yaml.safe_dump(told | fields))


def test_what_the_selection_says_goes_before_what_the_cases_say(suite: Path) -> None:
    select(suite)
    cases = read_definition(suite / "suite.yaml", suite, suite).cases
    assert {case.case_id: case.visibility for case in cases} == {"shop-Chair": "public", "shop-Table": "private"}


@pytest.mark.parametrize(
    ("fields", "told"),
    [
        ({"suite_id": "other"}, "of suite 'other'"),
        ({"withdrawn": {"shop-Chair": "shop-Table"}}, "withdrawn"),
        ({"visibility": {"shop-Table": "secret"}}, "public"),
    ],
)
def test_a_selection_that_does_not_fit_is_refused(suite: Path, fields: dict[str, Any], told: str) -> None:
    select(suite, **fields)
    with pytest.raises(BadInput, match=told):
        read_definition(suite / "suite.yaml", suite, suite)


def test_a_selection_that_is_missing_is_refused(suite: Path) -> None:
    with pytest.raises(BadInput, match=r"selection\.yaml"):
        read_definition(suite / "suite.yaml", suite, suite)
