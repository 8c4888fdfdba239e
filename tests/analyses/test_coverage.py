"""No study compares a configuration that has outcomes of some cases only, and each refuses one that is not there."""

from __future__ import annotations

from pathlib import Path

import pytest

from bench.made_warehouse import MadeWarehouse
from c4s.errors import BadInput
from tests.analyses.made import ask
from warehouse.analyses import STUDIES

UNLIKE = {"public-private", "judge-agreement", "repeats", "reliability", "drift"}
"""What they need is not here: two sets, two judges, repeats."""
TWO = {"public-private", "judge-agreement"}
"""Of these, what they refuse first."""
COUNTED = {"zero-reasons"}
"""It counts zeros of whatever has an outcome, and says of how many."""


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> MadeWarehouse:
    """The last of four configurations has an outcome of a case in three."""
    folder = tmp_path_factory.mktemp("made")
    cases = MadeWarehouse(folder, (0.5,)).cases()
    pending = frozenset(("agent-04", case["case_id"]) for place, case in enumerate(cases) if place % 3)
    warehouse = MadeWarehouse(folder, (0.7, 0.5, 0.4, 0.9), pending=pending, documents=True)
    warehouse.write()
    return warehouse


@pytest.mark.parametrize("study", sorted(STUDIES.keys() - UNLIKE - COUNTED))
def test_the_incomplete_stand_apart(made: MadeWarehouse, tmp_path: Path, study: str) -> None:
    options = {"agents": ["agent-01", "agent-02"]} if study == "paired" else {}
    tables = ask(made.root, study, tmp_path, **options).findings.tables
    naming = {table.name for table in tables for row in table.rows if "agent-04" in map(str, row.values())}
    assert all(name.startswith("apart") for name in naming)
    assert bool(naming) == (study != "paired")


@pytest.mark.parametrize(
    "study", [name for name, study in STUDIES.items() if "agents" in study.takes and name not in TWO]
)
def test_a_configuration_that_is_not_there_is_refused(made: MadeWarehouse, tmp_path: Path, study: str) -> None:
    with pytest.raises(BadInput, match="agent-9"):
        ask(made.root, study, tmp_path, agents=["agent-01", "agent-9"])


@pytest.mark.parametrize("study", ["paired", "power", "main-results"])
def test_a_configuration_is_named_once(made: MadeWarehouse, tmp_path: Path, study: str) -> None:
    with pytest.raises(BadInput, match="'agent-01' is named twice"):
        ask(made.root, study, tmp_path, agents=["agent-01", "agent-01", "agent-02"])


def test_zeros_are_counted_of_what_has_an_outcome(made: MadeWarehouse, tmp_path: Path) -> None:
    (table, _) = ask(made.root, "zero-reasons", tmp_path).findings.tables
    assert f"of {3 * 95 + 32} trials with an outcome" in table.title
