"""What pages show besides numbers, for a made warehouse: calls, claims, verdicts, pictures and scenes of real trials.

Every made trial is given the rows of a real trial of its setting, as if it were its own: the pages are as long, and
the files as large, as those of a run that took place. Pictures and scenes carry a mark each, so that no two trials
share a file. Scores stay the planted ones, so a made page says that numbers which it works out are not the stored ones.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

import pyarrow as pa
import pyarrow.parquet as pq

from bench.made_warehouse import SUITE, MadeWarehouse
from cases.model import SuiteDefinition
from cases.starter import indoor_cases, outdoor_cases
from cases.suite import build_suite
from catalog.build import ensure_pack
from warehouse.database import rebuild, rows
from warehouse.parquet import arrow_schema, part_path
from warehouse.pictures import CASE_PARTITION
from warehouse.scenes import SHAPE_PARTITION, packed, unpacked

PLAYED: Final = "planner"
HELD: Final = ("verdicts", "findings", "claims", "tool_use", "python_submissions")
"""Tables that the database holds: a part a configuration. Of the others each trial has a part, as runs write them."""
UNHELD: Final = ("calls", "pictures", "scenes")
OF_CASES: Final = ("pictures", "scenes")

PlayedRow = dict[str, Any]


def play(home: Path) -> Path:
    """Build a suite of a text, an indoor and an outdoor repair, and run the planner on it; returns the warehouse."""
    flat, harbour = indoor_cases.scenes()[1], outdoor_cases.scenes()[0]
    packs = tuple(dict.fromkeys((*flat.packs, *harbour.packs)))
    for pack in packs:
        ensure_pack(pack, home / "packs")
    texts = [case for case in indoor_cases.cases(indoor_cases.scenes()) if case.case_id == "text-flat-family"]
    outdoor = outdoor_cases.cases(outdoor_cases.scenes())
    cases = (*texts, *indoor_cases.flat_cases(flat)[:1], outdoor[0])
    suite = SuiteDefinition("donor", "Donor", "A case a setting", packs, (flat, harbour), cases)
    build_suite(suite, home / "suites" / "donor", home / "packs", lambda line: None)
    command = [sys.executable, "-m", "c4s.cli", "run", "donor", "-a", PLAYED, "--json"]
    subprocess.run(command, env={**os.environ, "C4S_HOME": str(home)}, check=True, stdout=subprocess.DEVNULL)
    return home / "warehouse"


class ShownRows:
    """The rows of real trials, one a setting, to be given to made ones."""

    def __init__(self, warehouse: Path) -> None:
        """``warehouse``: where the planner did at least one case of each setting."""
        self._trials: dict[str, dict[str, list[PlayedRow]]] = {}
        self._cases: dict[str, dict[str, list[PlayedRow]]] = {}
        planned = f"SELECT * FROM outcomes WHERE configuration = '{PLAYED}' AND status <> 'pending' ORDER BY case_id"
        for trial in rows(warehouse, planned):
            if trial["setting"] not in self._trials:
                own = f"trial_id = '{trial['trial_id']}'"
                case = f"case_id = '{trial['case_id']}' AND configuration = '{CASE_PARTITION}'"
                self._trials[trial["setting"]] = {name: _of(warehouse, name, own) for name in (*HELD, *UNHELD)}
                self._cases[trial["setting"]] = {name: _of(warehouse, name, case) for name in OF_CASES}
        self._shapes = rows(warehouse, "SELECT * FROM shapes")

    def write(self, made: MadeWarehouse) -> None:
        """Give every trial and case of a made warehouse its rows, and build the database anew."""
        cases = made.cases()
        for case in cases:
            key = {**made.key("", "", case, 0), "trial_id": "", "configuration": CASE_PARTITION}
            for table, found in self._cases[case["setting"]].items():
                _write(made.root, table, CASE_PARTITION, f"{case['case_id']}-made", _given(table, found, key))
        for shape in self._shapes:
            row = {**shape, "suite": SUITE}
            _write(made.root, "shapes", SHAPE_PARTITION, row["shape_sha256"], [row])
        for name in made.names():
            held: dict[str, list[PlayedRow]] = {table: [] for table in HELD}
            for case in cases:
                for repeat in range(1, made.repeats + 1):
                    key = made.key(name, made.judges[0], case, repeat)
                    for table, found in self._trials[case["setting"]].items():
                        given = _given(table, found, key)
                        if table in HELD:
                            held[table] += given
                        else:
                            _write(made.root, table, name, key["trial_id"], given)
            for table, given in held.items():
                _write(made.root, table, name, "shown", given)
        rebuild(made.root)


def _of(warehouse: Path, table: str, where: str) -> list[PlayedRow]:
    return rows(warehouse, f"SELECT * FROM {table} WHERE {where}")


def _given(table: str, found: list[PlayedRow], key: PlayedRow) -> list[PlayedRow]:
    mark = f"{key['trial_id'] or key['case_id']}".encode()
    own = _MARKED.get(table)
    given = [{**row, **key} for row in found]
    return [own(row, mark) for row in given] if own else given


def _marked_picture(row: PlayedRow, mark: bytes) -> PlayedRow:
    """A comment behind the start of the JPEG makes it a file of its own."""
    comment = b"\xff\xfe" + (len(mark) + 2).to_bytes(2, "big") + mark
    return {**row, "jpeg": row["jpeg"][:2] + comment + row["jpeg"][2:]}


def _marked_scene(row: PlayedRow, mark: bytes) -> PlayedRow:
    return {**row, "document": packed({**unpacked(row["document"]), "mark": mark.decode()})}


_MARKED: Final[dict[str, Callable[[PlayedRow, bytes], PlayedRow]]] = {
    "pictures": _marked_picture,
    "scenes": _marked_scene,
}


def _write(root: Path, table: str, configuration: str, key: str, found: list[PlayedRow]) -> None:
    schema = arrow_schema(table, partitions=False)
    made = pa.table({column: [row.get(column) for row in found] for column in schema.names}, schema=schema)
    path = part_path(root, table, SUITE, configuration, key)
    path.parent.mkdir(parents=True, exist_ok=True)
    pq.write_table(made, path, compression="zstd")
