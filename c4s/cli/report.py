"""``c4s report``: the views and pages anew."""

from __future__ import annotations

from typing import Annotated

import typer

from c4s.cli.output import print_json
from c4s.home import runs_root, site_root, suites_root, warehouse_root
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan


def report(
    from_runs: Annotated[
        bool, typer.Option("--from-runs", help="first write every outcome anew from the run folders")
    ] = False,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Rebuild the warehouse's views and render the pages from them."""
    from reports.site import build_site
    from warehouse.database import rebuild
    from warehouse.ingest import rebuild_from_run

    if from_runs:
        for run in RunFolder.planned(runs_root()):
            rebuild_from_run(run.root, suites_root() / Plan.read(run.plan).suite_id, warehouse_root())
    rebuild(warehouse_root())
    page = build_site(warehouse_root(), site_root())
    if json_output:
        print_json({"page": page.as_uri()})
    else:
        print(page.as_uri())
