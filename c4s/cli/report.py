"""``c4s report``: the views and pages anew."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.left_out import refuse_left_out
from c4s.cli.output import print_json, say
from c4s.errors import BadInput
from c4s.folders import check_own_output
from c4s.home import runs_root, site_root, suites_root, warehouse_root
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan


def report(
    from_runs: Annotated[
        bool, typer.Option("--from-runs", help="first write every outcome anew from the run folders")
    ] = False,
    download: Annotated[
        Path | None, typer.Option(help="write the tables into this folder too: one sorted Parquet file each")
    ] = None,
    pictures: Annotated[bool, typer.Option("--pictures", help="with --download: the pictures too")] = False,
    scan: Annotated[
        Path | None, typer.Option(help="make nothing; look through this folder for what private cases hold")
    ] = None,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Rebuild the warehouse's views and render the pages from them. Rows that were lost are written anew.

    Exit 2 where a run could not give all of its outcomes; the pages then show the others. Pages and downloads tell of
    private cases only means over all of them, and are not written where they hold more. With --scan, exit 1 where a
    folder does.
    """
    if pictures and download is None:
        raise BadInput("--pictures needs --download", todo="c4s report --download DIR --pictures")
    if scan is not None:
        if from_runs or download is not None:
            raise BadInput("--scan makes nothing", todo="give it alone")
        _scan(scan, json_output)
        return
    if download is not None:
        from warehouse.release import MANIFEST

        check_own_output(download, MANIFEST)
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
    page = build_site(warehouse_root(), site_root(), suites_root())
    told = {"page": page.as_uri()}
    if download is not None:
        from warehouse.release import write_download

        write_download(warehouse_root(), download, pictures=pictures, suites=suites_root())
        told["download"] = str(download)
    if json_output:
        print_json(told)
    else:
        for place in told.values():
            say(place)
    refuse_left_out(left_out)


def _scan(folder: Path, json_output: bool) -> None:
    """Tell what of private cases stands in a folder; exit 1 where something does."""
    from reports.viewer import three_script
    from warehouse.database import catch_up
    from warehouse.release import leaks_in, secrets_of

    if not folder.is_dir():
        raise BadInput("no such folder", where=str(folder), todo="name a folder that is to be published")
    catch_up(warehouse_root())
    secrets = secrets_of(warehouse_root(), suites_root(), [three_script().decode()])
    found = leaks_in(folder, secrets) if secrets else []
    counted = {"texts": len(secrets.pieces), "pictures": len(secrets.pictures)}
    if json_output:
        print_json({"looked_for": counted, "leaks": [asdict(leak) for leak in found]})
    else:
        for leak in found:
            say(f"{leak.file}: {leak.kind}")
        say(f"{len(found)} leaks; looked for {counted['texts']} texts and {counted['pictures']} pictures")
    if found:
        raise typer.Exit(1)
