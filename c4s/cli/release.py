"""``c4s release``: what others need to check and repeat published numbers, in one folder."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.output import print_json, say
from c4s.cli.runs import run_folder
from c4s.cli.suites import built_suite
from c4s.folders import beside, check_new, put_folder
from c4s.home import analyses_root, suites_root, warehouse_root
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan
from c4s.records.suite import DIGESTS, SuiteFolder


def release(
    out: Annotated[Path, typer.Option(help="new folder")],
    run: Annotated[list[str] | None, typer.Option("--run", help="run ids or folders")] = None,
    suite: Annotated[list[str] | None, typer.Option("--suite", help="ids of built suites, besides the runs'")] = None,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Pack code, public cases, configurations, skill text, schemas, judge instructions and answers of studies.

    Only what is on an allow-list is packed, with the digest of every file. It is looked through for what private cases
    hold and for keys of the environment; where it holds one, nothing is written and the exit code is 3.
    """
    from cases.workshop.exporting import export_suite
    from warehouse.database import catch_up
    from warehouse.release import pack_release, secrets_of

    plans = {plan.run_id: plan for plan in (Plan.read(RunFolder(run_folder(name)).plan) for name in run or ())}
    ids = sorted({*(suite or ()), *(plan.suite_id for plan in plans.values())})
    suites = [SuiteFolder(built_suite(name)) for name in ids]
    check_new(out)
    catch_up(warehouse_root())
    with beside(out) as scratch:
        made = scratch / "made"
        made.mkdir()
        for one in suites:
            export_suite(one, made / "suites" / one.root.name, public_only=True)
        digests = pack_release(
            made,
            runs=plans,
            analyses=analyses_root(),
            private=suites,
            secrets=secrets_of(warehouse_root(), suites_root()),
        )
        put_folder(made, out, marker=DIGESTS)
    if json_output:
        print_json({"folder": str(out), "files": len(digests), "suites": ids, "runs": sorted(plans)})
    else:
        say(f"{out}: {len(digests)} files; {len(suites)} suites, {len(plans)} runs")
