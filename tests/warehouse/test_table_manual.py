"""docs/warehouse.md is what the records say, and its examples are answered; the notebook runs."""

from __future__ import annotations

from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

from bench.made_warehouse import MadeWarehouse
from warehouse.database import ask, questions
from warehouse.manual import EXAMPLES, PAGE, manual
from warehouse.records import TABLES

NOTEBOOK = PAGE.with_name("analysis.ipynb")


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("home")
    MadeWarehouse(found / "warehouse", (0.7, 0.6, 0.5)).write()
    return found


def test_the_page_is_of_today() -> None:
    assert PAGE.read_text() == manual(), "python -m warehouse.manual"


def test_the_page_tells_every_table_column_and_question() -> None:
    page = manual()
    for name, model in TABLES.items():
        assert f"### {name}\n" in page
        for column in model.model_fields:
            assert f"| `{column}` |" in page
    assert "|  |\n" not in page.replace("| unit | what it is |", ""), "a column that is not described"
    for question in questions():
        (line,) = (line for line in page.splitlines() if line.startswith(f"| `{question}` |"))
        assert len(line) > len(question) + 30


@pytest.mark.parametrize("table", TABLES)
def test_an_example_is_answered(table: str, home: Path) -> None:
    columns, _ = ask(home / "warehouse", EXAMPLES[table])
    assert len(columns) > 1 and f"FROM {table}" in EXAMPLES[table]


def test_the_notebook_runs_and_holds_no_output(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    book = nbformat.read(NOTEBOOK, as_version=4)
    assert all(not cell.outputs and cell.execution_count is None for cell in book.cells if cell.cell_type == "code")
    monkeypatch.setenv("C4S_HOME", str(home))
    NotebookClient(
        book, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(PAGE.parents[1])}}
    ).execute()
    last = book.cells[-1].outputs
    assert "main-results" in str(book.cells[-1].source) and "agent-01" in str(last)
