"""Digests of what the warehouse holds, case by case: who keeps something made of them knows when to make it anew."""

from __future__ import annotations

from collections import defaultdict
from pathlib import Path
from typing import Final

from c4s.files import digest
from warehouse.damage import UNHELD
from warehouse.database import ask
from warehouse.parts import HELD

CaseKey = tuple[str, str, str]
"""Suite, the digest of its build, case."""
_SHARED: Final = ("", "", "")


def case_stamps(root: Path) -> dict[CaseKey, str]:
    """A digest of all rows of each case.

    Of tables whose rows stay in their parts it is of the parts' names, sizes and times. One more, of the key of empty
    names, tells of parts that cannot be told to be of one case.
    """
    told: dict[CaseKey, list[object]] = defaultdict(list)
    for table in HELD:
        sql = f"SELECT suite, suite_digest, case_id, bit_xor(hash(t)), count(*) FROM {table} AS t GROUP BY ALL"
        for suite, build, case, hashed, count in ask(root, sql)[1]:
            told[suite, build, case].append([table, hashed, count])
    for key, parts in _parts(root).items():
        told[key].append(sorted(parts))
    return {key: digest(found) for key, found in told.items()}


def _parts(root: Path) -> dict[CaseKey, list[list[str | int]]]:
    """The parts of tables that the database does not hold: name, size, time of change (ns)."""
    found: dict[CaseKey, list[list[str | int]]] = defaultdict(list)
    planned = ask(root, "SELECT DISTINCT suite, suite_digest, case_id, trial_id FROM schedule")[1]
    trials: dict[str, CaseKey] = {trial: (suite, build, case) for suite, build, case, trial in planned}
    cases = {(suite, case): (suite, build, case) for suite, build, case, _ in planned}
    for table in UNHELD:
        for path in (root / table).glob("suite=*/configuration=*/*.parquet"):
            suite = path.parent.parent.name.partition("=")[2]
            key = trials.get(path.stem) or cases.get((suite, path.stem.rpartition("-")[0])) or _SHARED
            seen = path.stat()
            found[key].append([str(path.relative_to(root)), seen.st_size, seen.st_mtime_ns])
    return found
