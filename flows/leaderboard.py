"""The leaderboard flow: the views and pages anew from the Parquet parts. Scheduled nightly."""

from __future__ import annotations

from prefect import flow

from c4s.home import site_root, warehouse_root
from flows.server import tie
from tasks.publish import publish

tie()


@flow(name="leaderboard")
def leaderboard() -> str:
    """Rebuild the warehouse's views and the pages. Returns the address of the leaderboard page."""
    return publish(warehouse_root(), site_root()).as_uri()
