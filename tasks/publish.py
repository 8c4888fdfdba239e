"""The database of views and the pages."""

from __future__ import annotations

from pathlib import Path

from prefect import task

from c4s.home import suites_root
from reports.site import build_site
from warehouse.database import rebuild


@task
def publish(warehouse: Path, site: Path) -> Path:
    """Rebuild the views, render the pages from them; returns the leaderboard page."""
    rebuild(warehouse)
    return build_site(warehouse, site, suites_root())
