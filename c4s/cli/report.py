"""``c4s report``: the views and pages anew."""

from __future__ import annotations

from typing import Annotated

import typer

from c4s.cli.output import print_json
from c4s.home import site_root, warehouse_root
from reports.site import build_site
from warehouse.database import rebuild


def report(json_output: Annotated[bool, typer.Option("--json")] = False) -> None:
    """Rebuild the warehouse's views and render the pages from them."""
    rebuild(warehouse_root())
    page = build_site(warehouse_root(), site_root())
    if json_output:
        print_json({"page": page.as_uri()})
    else:
        print(page.as_uri())
