"""``python -m bench.attacks``: every attack, tried in every sandbox of this machine, as a table.

An attack that is *refused* raises; the script fails with that error, in a job log that it cannot change. One that
*ends* the engine is the agent's failure, with the reason in the attempt's outcome. Exit code 1 when an attack gets
through that is not known to.
"""

from __future__ import annotations

import re
import sys

from bench.attacks.row import AttackResult
from bench.attacks.trial import results
from c4s.engine.confine.sandbox import faults


def main() -> int:
    """Print the table: an attack in a sandbox a row, and how many got through."""
    found = list(results())
    print("| attack | sandbox | expected | got |\n|---|---|---|---|")
    for row in found:
        got = ("" if row.failed else "through: " if row.known else "**THROUGH** ") + _short(row)
        print(f"| {row.attack} | {row.backend} | {row.expected.replace('|', ' or ')} | {got} |")
    for backend, fault in faults().items():
        if fault is not None:
            print(f"\nNot tried: {backend} ({fault})")
    through = [row for row in found if not row.failed and not row.known]
    known = sum(not row.failed and row.known for row in found)
    print(f"\nrows: {len(found)}, through: {len(through)}, documented: {known}")
    return 1 if through else 0


def _short(result: AttackResult) -> str:
    """The outcome in a few words, without the paths of this run."""
    told = " ".join(result.told.split())
    if told.startswith("the engine ended with"):
        reason = re.search(r"\((its? [^)]*|[^)]*message[^)]*|[^)]*JSON[^)]*)\)", told)
        words = told.split()
        return "ended: " + (reason[1] if reason else words[4] if "SIG" in words[4] else " ".join(words[4:7]))[:60]
    return told.partition(": '/")[0][:70].replace("|", "/")


if __name__ == "__main__":
    sys.exit(main())
