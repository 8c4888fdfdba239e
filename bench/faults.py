"""Faults done to a run for real, each followed by the same command: what is lost, repeated or left behind.

``python -m bench.faults [--only WORDS]`` prints the table and ends with 1 where a row fails. A row does its fault to a
small run, at a moment that is told by what lies on disk, runs the same command until it ends with 0 (doing what a
refusal asks for), and compares with an undisturbed run: no row of the warehouse is lost or changed, at most one attempt
is repeated, no process and no temporary folder stays.
"""

from __future__ import annotations

import argparse
import os
import shutil
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from bench.fault_table import FAULTS, Fault, Scene
from bench.row import Row
from c4s.folders import remove_tree
from warehouse.database import rows as stored_rows

TABLES = ("outcomes", "attempts", "verdicts", "components", "findings", "schedule")
CLOCKED = {"planned_at", "evaluation_s", "orchestration_s", "attempt_wall_s", "wall_s"}
MARK = "C4S_FAULT"
MISSED = "missed"
"""The first of a row's ends where the run was over before there was anybody to kill."""
MOST_RUNS = 3
COLUMNS = ("fault", "rows lost or changed", "attempts repeated", "orphans", "left", "ends", "holds")


@dataclass(frozen=True)
class FaultResult:
    """What became of a run after a fault."""

    fault: str
    changed: int
    """Rows of the undisturbed run that are not there, and rows that it does not have."""
    repeated: int
    orphans: int
    left: int
    """Entries of the temporary folder."""
    ends: str
    """Exit codes of the command, in order; before them ``MISSED`` where the fault was not done."""

    @property
    def holds(self) -> bool:
        """Whether nothing is lost."""
        return self.ends.endswith("0") and not (self.changed or self.orphans or self.left) and self.repeated <= 1


def contents(home: Path) -> list[str]:
    """All rows of a home's warehouse, without what a clock says."""
    return sorted(
        f"{table} {[value for name, value in row.items() if name not in CLOCKED]}"
        for table in TABLES
        for row in stored_rows(home / "warehouse", f"SELECT * FROM {table}")
    )


def orphans(mark: str) -> list[int]:
    """Processes that carry a mark in their environment."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            if f"{MARK}={mark}".encode() in (folder / "environ").read_bytes().split(b"\0"):
                found.append(int(folder.name))
        except OSError:
            continue
    return found


@contextmanager
def scene(built: Path, done: Path | None, kind: type[Scene] = Scene) -> Iterator[Scene]:
    """A home with the built suite, with or without the run that is done, and a temporary folder of its own."""
    root = Path(tempfile.mkdtemp(prefix="f-"))
    home, temporary = root / "h", root / "t"
    home.mkdir()
    temporary.mkdir()
    (built / "cache").mkdir(exist_ok=True)
    for name in ("packs", "suites", "cache"):
        (home / name).symlink_to(built / name)
    for name in ("runs", "warehouse", "site"):
        if done is not None:
            shutil.copytree(done / name, home / name)
    mark = root.name
    settings = {**os.environ, "C4S_HOME": str(home), "TMPDIR": str(temporary), MARK: mark, "COLUMNS": "140"}
    settings |= {"PREFECT_HOME": str(root / "p"), "DO_NOT_TRACK": "1", "PREFECT_SERVER_ANALYTICS_ENABLED": "false"}
    made = kind(home, temporary, settings, mark)
    try:
        yield made
    finally:
        made.close()
        for process in orphans(mark):
            os.kill(process, 9)
        remove_tree(root, inside=root.parent, at_best=True)


def tried(fault: Fault, built: Path, done: Path, wanted: Sequence[str], kind: type[Scene] = Scene) -> FaultResult:
    """Do a fault and go on."""
    with scene(built, done if fault.after else None, kind) as made:
        ends = [str(fault.do(made))] if not fault.after else []
        if fault.after:
            fault.do(made)
        for _ in range(MOST_RUNS):
            again = made.run()
            ends.append(str(again.returncode))
            if again.returncode == 0:
                break
            made.obey(again.stderr)
        made.close()
        found = contents(made.home) if ends[-1] == "0" else []
        repeated = len(list((made.home / "runs").glob("*/*/*/r*/attempt-?.interrupted-*")))
        changed = len(set(found) ^ set(wanted))
        stay = _gone(made.mark)
        return FaultResult(fault.name, changed, repeated, stay, len(list(made.temporary.iterdir())), " ".join(ends))


def _gone(mark: str) -> int:
    """How many processes stay, once those that are ending have ended."""
    deadline = time.monotonic() + 10.0
    while orphans(mark) and time.monotonic() < deadline:
        time.sleep(0.05)
    return len(orphans(mark))


@contextmanager
def undisturbed(built: Path) -> Iterator[tuple[Path, list[str]]]:
    """A home after the command ran without a fault, and its rows."""
    with scene(built, None) as made:
        ended = made.run()
        if ended.returncode:
            raise SystemExit(f"the undisturbed run failed: {ended.stderr}")
        yield made.home, contents(made.home)


def results(built: Path, only: str = "") -> Iterator[FaultResult]:
    """Every fault whose name holds ``only``."""
    with undisturbed(built) as (done, wanted):
        for fault in FAULTS:
            if only in fault.name:
                yield tried(fault, built, done, wanted)


@contextmanager
def small_suite() -> Iterator[Path]:
    """A home with the flat of the starter suite and two of its repairs."""
    from cases.model import SuiteDefinition
    from cases.starter import indoor_cases
    from cases.suite import build_suite
    from catalog.build import ensure_pack

    with tempfile.TemporaryDirectory(prefix="c4s-faults-") as name:
        home, flat = Path(name), indoor_cases.scenes()[1]
        ensure_pack("c4s-home", home / "packs")
        cases = indoor_cases.flat_cases(flat)[:2]
        definition = SuiteDefinition("small", "Small", "The flat", ("c4s-home",), (flat,), cases)
        build_suite(definition, home / "suites" / "small", home / "packs", lambda line: None)
        yield home


def rows() -> list[Row]:
    """The totals over all faults, as rows of ``python -m bench``."""
    with small_suite() as built:
        found = list(results(built))
    failed = [result.fault for result in found if not result.holds]
    totals = {
        "rows lost or changed": sum(result.changed for result in found),
        "attempts repeated after one fault, at most": max(result.repeated for result in found),
        "processes left": sum(result.orphans for result in found),
        "temporary folders left": sum(result.left for result in found),
    }
    return [
        Row(f"{len(found)} faults: {name}", value, "at most 1" if "most" in name else "0", not failed, unit="")
        for name, value in totals.items()
    ]


def print_table(found: Sequence[FaultResult]) -> None:
    """A fault a row, and the totals."""
    print(f"| {' | '.join(COLUMNS)} |\n|{'---|' * len(COLUMNS)}")
    for one in found:
        cells: list[Any] = [one.fault, one.changed, one.repeated, one.orphans, one.left, one.ends]
        print("|", *(f"{cell} |" for cell in (*cells, "yes" if one.holds else "**NO**")))
    print(
        f"\n{len(found)} faults, {sum(one.holds for one in found)} hold; {sum(one.changed for one in found)} rows lost "
        f"or changed, {sum(one.repeated for one in found)} attempts repeated, {sum(one.orphans for one in found)} "
        f"processes and {sum(one.left for one in found)} temporary folders left; "
        f"{sum(one.ends.startswith(MISSED) for one in found)} came too late to kill anybody"
    )


def main() -> int:
    """Print the table; 1 where a row fails."""
    parser = argparse.ArgumentParser(prog="python -m bench.faults", description=__doc__)
    parser.add_argument("--only", default="", help="faults whose name holds these words")
    parser.add_argument("--home", type=Path, help="a home with a suite `small` that is built already")
    given = parser.parse_args()
    found: list[FaultResult] = []

    def collect(built: Path) -> None:
        for result in results(built, given.only):
            print(f"{result.fault}: {'holds' if result.holds else result}", file=sys.stderr, flush=True)
            found.append(result)

    if given.home is not None:
        collect(given.home)
    else:
        with small_suite() as built:
            collect(built)
    print_table(found)
    return 0 if found and all(result.holds for result in found) else 1


if __name__ == "__main__":
    sys.exit(main())
