"""A run on Prefect's own pages: a table of how far it is, and links to the status page and the leaderboard."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Final

from prefect.artifacts import acreate_link_artifact, acreate_table_artifact

from c4s.records.folder import RunFolder
from c4s.run import artifacts
from c4s.run.progress import Progress

REFRESH_S: Final = 60.0


@asynccontextmanager
async def shown(progress: Progress, run: Path, leaderboard: Path) -> AsyncIterator[None]:
    """Show how far a run is: now and then while the block runs, and at its end."""

    async def again() -> None:
        while True:
            await asyncio.sleep(REFRESH_S)
            await _show(progress, run)

    showing = asyncio.create_task(again())
    try:
        yield
    finally:
        showing.cancel()
        await _show(progress, run)
        for text, link in artifacts.links(RunFolder(run), leaderboard).items():
            await acreate_link_artifact(link, text, key=f"{_key(run)}-{text.replace(' ', '-')}")


async def _show(progress: Progress, run: Path) -> None:
    now = await asyncio.to_thread(progress.read)
    rows = artifacts.rows(now) or [{"agent": "none"}]
    await acreate_table_artifact(rows, key=_key(run), description=artifacts.summary(now))


def _key(run: Path) -> str:
    """A key that Prefect takes: lower case letters, digits and dashes."""
    return "run-" + "".join(one if one.isalnum() else "-" for one in run.name.lower())
