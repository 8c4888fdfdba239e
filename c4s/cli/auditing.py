"""``c4s suite audit``: what a suite gives away."""

from __future__ import annotations

from typing import Annotated

import typer

from c4s.cli.output import print_json, print_table, say
from c4s.cli.progress import bars
from c4s.cli.suites import built_suite
from c4s.home import packs_root
from c4s.numbers import half_up
from c4s.protocol.settings import is_construction
from c4s.records.suite import SuiteFolder


def audit_suite(
    name: Annotated[str, typer.Argument(help="id of a built suite")],
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Look for leaks in what agents see of every case, and try to repair each without a picture (docs/cheats.md).

    Exit 2 where something leaks, or a repair succeeds too often.
    """
    from cases.audit import MOST_F1, audit, check_blind, mean_f1
    from cases.leaks import CHECKS, check_leaks, leaks

    folder = SuiteFolder(built_suite(name))
    leaked = leaks(folder)
    with bars() as progress:
        repairs = [case for case in folder.suite().cases if not is_construction(case.setting)]
        task = progress.add_task(f"guessing {name:42.42}", total=len(repairs))
        rows = []
        for row in audit(folder, packs_root()):
            rows.append(row)
            progress.update(task, completed=len(rows))
    means = mean_f1(rows)
    if json_output:
        cases = [{"case_id": row.case_id, "f1": dict(row.f1)} for row in rows]
        print_json(
            {"suite": name, "repairs": len(rows), "mean_f1": means, "most": MOST_F1, "cases": cases}
            | {"checks": list(CHECKS), "leaks": [vars(leak) for leak in leaked]}
        )
    else:
        counts = {kind: sum(leak.kind == kind for leak in leaked) for kind in CHECKS}
        print_table(["leak", "found"], list(map(list, counts.items())), title=f"Agent folders of {name}")
        for leak in leaked:
            say(f"{leak.case_id}: {leak.file}: {leak.problem} ({leak.kind})")
        print_table(
            ["case", "best blind way", "F1"],
            [[row.case_id, row.best[0] if row.best[1] else "none", half_up(row.best[1], 3)] for row in rows],
            title=f"Repairs of {name} guessed without a picture",
        )
        if means:
            way, value = next(iter(means.items()))
            say(f"best way over all {len(rows)} repairs: {way!r}, mean Repair F1 {value:.4f} (at most {MOST_F1})")
    check_leaks(leaked)
    check_blind(rows)
