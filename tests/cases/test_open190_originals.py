"""A half of a scene where no repair is found begins again over another original, and stops after the last one."""

from __future__ import annotations

from pathlib import Path

import pytest

from c4s.errors import BadInput
from c4s.files import read_json, write_json
from c4s.records.pack import STAMP
from c4s.records.suite import SuiteFolder
from cases.open190.build import sources
from cases.open190.layout import StagedPlace
from cases.open190.repairs import unit
from cases.open190.repairs.plan import WantedRepair
from cases.open190.scenes import SceneSpec
from cases.open190.suite import UnitPlan, build_units
from catalog.build import build_pack
from catalog.kits.styles import DOMESTIC

WANTED = WantedRepair("parlour-1", "parlour", "indoor", "Restore", 1, "easy", "public", 61)


def parlour(p: StagedPlace) -> None:
    """A small room with a table, chairs and shelves."""
    p.room((-400, -300, 400, 300), "Planks", S=("Plain", "Door"))
    table = p.put(p.one("table", kind="Round"), 0, 0)
    p.around(table, p.one("chair"), 4)
    p.on(table, p.kit("dish", 3), 3)
    p.along((390, 290), (-390, 290), [*p.kit("cupboard", 2), *p.kit("sofa", 1), *p.kit("bookcase", 1)], gap=20)
    p.put(p.one("house-plant"), -320, -200)
    p.put(p.one("decor"), 320, 0)
    p.light(0, 0)


PARLOUR = UnitPlan(
    SceneSpec("parlour", "indoor", "Parlour", DOMESTIC, parlour), "public", "seed of the parlour", (WANTED,)
)


@pytest.fixture
def packs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Packs with that of the parlour, in a home where nothing can be drawn."""
    monkeypatch.setenv("C4S_HOME", str(tmp_path))
    monkeypatch.setattr(unit, "DRAFTS", 0)
    assert isinstance(PARLOUR.spec, SceneSpec)
    place = PARLOUR.spec.place()
    build_pack(place.assortment.pack(place.pack_id, "Parlour"), tmp_path / "packs", previews=False)
    write_json(tmp_path / "packs" / place.pack_id / STAMP, {"sources": sources()})
    return tmp_path / "packs"


def test_where_nothing_is_found_it_stops_after_the_last_original_with_the_commonest_reason(
    packs: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(unit, "ORIGINALS", 2)
    steps: list[str] = []
    with pytest.raises(BadInput) as failed:
        build_units([PARLOUR], packs, steps.append)
    tried = unit.ORIGINALS * unit.ROUNDS
    assert failed.value.what == f"no good repair found for 1 of 1: nothing to draw ({tried})"
    assert failed.value.where == "parlour-1 Restore 1 easy"
    assert sum(step.endswith("another original") for step in steps) == unit.ORIGINALS - 1
    assert sum("things to change" in step for step in steps) == unit.ORIGINALS
    assert not list((packs.parent / "cache").rglob(unit.UNIT))


def test_the_second_original_is_built_where_the_first_gave_nothing(
    packs: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    drafts, steps = 400, list[str]()

    def step(message: str) -> None:
        steps.append(message)
        if message.endswith("another original"):
            monkeypatch.setattr(unit, "DRAFTS", drafts)

    folder = build_units([PARLOUR], packs, step)[0]
    assert sum(step.endswith("another original") for step in steps) == 1
    note = read_json(folder / unit.UNIT)
    assert list(note["cases"]) == ["parlour-1"] and note["refused"]["nothing to draw"] >= unit.ROUNDS
    assert SuiteFolder(folder).withheld_case("parlour-1").operation_group == "Restore"
