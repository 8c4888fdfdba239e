"""The printed tables and what the studies answer from a warehouse of them."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pandas as pd
import yaml

from bench.reproduction.worlds import write_worlds
from c4s.errors import BadInput
from c4s.records.analysis import Findings, Table
from c4s.stats.bootstrap import Floats
from warehouse.analyses import StudyOptions, WantedScope, answer, study_named

FEW = 100
"""Draws of a study whose intervals are not looked at."""


@dataclass
class Book:
    """Printed values and the warehouse of them."""

    folder: Path
    warehouse: Path
    tables: dict[str, Any]
    """Data frames by name; their cells have no types to check."""
    checks: Any
    """What is published, by the number of its check."""
    constants: dict[str, Any]
    answers: Path
    _kept: dict[tuple[str, str], Findings] = field(default_factory=dict)

    @classmethod
    def of(cls, folder: Path, scratch: Path) -> Book:
        """Load a folder of restated values into a new warehouse in ``scratch``. ``BadInput`` where it is none."""
        paths = sorted((folder / "tables").glob("*.csv"))
        if not paths or not (folder / "checks.csv").is_file():
            raise BadInput("no restated values here: tables/*.csv and checks.csv", where=str(folder))
        tables = {path.stem: pd.read_csv(path) for path in paths}
        with duckdb.connect() as reference:
            for name, table in tables.items():
                reference.register(name, table)
            warehouse = write_worlds(scratch / "warehouse", reference)
        checks = pd.read_csv(folder / "checks.csv", dtype=str, keep_default_na=False).set_index("check_id")
        constants = yaml.safe_load((folder / "constants.yaml").read_text())
        return cls(folder, warehouse, tables, checks, constants, scratch / "analyses")

    def by_agent(self, table: str) -> Any:
        """A printed table with a row a configuration."""
        return self.tables[table].set_index("agent")

    def findings(self, study: str, suite: str) -> Findings:
        """What a study answers over a suite."""
        key = (study, suite)
        if key not in self._kept:
            made = study_named(study)
            options = {"pool": self.pool()} if "pool" in made.takes else {"draws": FEW} if "draws" in made.takes else {}
            result = answer(self.warehouse, made, WantedScope(suite=suite), StudyOptions.parse(options), self.answers)
            self._kept[key] = result.findings
        return self._kept[key]

    def table(self, study: str, suite: str, name: str) -> Table:
        """A table of an answer."""
        return next(table for table in self.findings(study, suite).tables if table.name == name)

    def column(self, study: str, suite: str, name: str, column: str) -> dict[str, float]:
        """A column of an answer by configuration."""
        rows = self.table(study, suite, name).rows
        return {str(row["configuration"]): float(row[column] or 0) for row in rows}

    def pool(self) -> list[str]:
        """Configurations by whose scores the public cases were selected."""
        agents = self.tables["agents"]
        shared = agents[(agents["selection_pool"] == "yes") & (agents["private"] == "yes")]
        return [str(agent) for agent in shared["agent"]]

    def ten(self) -> list[str]:
        """Configurations with outcomes of both sets, in the order of the private table."""
        return [str(agent) for agent in self.tables["main_results_private"]["agent"]]


def column_of(table: Any, column: str) -> Floats:
    """A column of a printed table as numbers."""
    return np.asarray(table[column], dtype=np.float64)
