"""``c4s report``: the views and pages anew."""

from __future__ import annotations

from typing import Annotated

import typer

from c4s.cli.left_out import refuse_left_out
from c4s.cli.output import print_json, say
from c4s.errors import BadInput
from c4s.home import runs_root, site_root, suites_root, warehouse_root
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan


def report(
    from_runs: Annotated[
        bool, typer.Option("--from-runs", help="first write every outcome anew from the run folders")
    ] = False,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Rebuild the warehouse's views and render the pages from them. Rows that were lost are written anew.

    Exit 2 where a run could not give all of its outcomes; the pages then show the others.
    """
    from reports.site import build_site, check_place
    from warehouse.database import rebuild
    from warehouse.done import held_by
    from warehouse.ingest import rebuild_from_run

    check_place(site_root())
    left_out: list[BadInput] = []
    for run in RunFolder.planned(runs_root()):
        try:
            suite = suites_root() / Plan.read(run.plan).suite_id
            left_out += rebuild_from_run(
                run.root,
                suite,
                warehouse_root(),
                wanted=lambda trial, plan: from_runs or held_by(trial, plan, warehouse_root()) is None,
            )
        except BadInput as error:
            left_out.append(error)
    rebuild(warehouse_root())
    page = build_site(warehouse_root(), site_root())
    if json_output:
        print_json({"page": page.as_uri()})
    else:
        say(page.as_uri())
    refuse_left_out(left_out)
