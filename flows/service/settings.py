"""How Prefect is set where c4s starts it: quiet, sending nothing anywhere, its files under ``C4S_HOME``."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Final

from c4s.home import home

QUIET: Final = {
    "DO_NOT_TRACK": "1",
    "PREFECT_SERVER_ANALYTICS_ENABLED": "false",
    "PREFECT_SERVER_LOGGING_LEVEL": "WARNING",
    "PREFECT_LOGGING_TO_API_WHEN_MISSING_FLOW": "ignore",
    "PREFECT_CLI_COLORS": "false",
    "PREFECT_WORKER_QUERY_SECONDS": "2",
    "PREFECT_WORKER_PREFETCH_SECONDS": "2",
    "PREFECT_SERVER_SERVICES_TASK_RUN_RECORDER_BATCH_SIZE": "200",
}


def prefect_home() -> Path:
    """Where Prefect's own files lie. All of them may be deleted while nothing runs: run folders remember."""
    return home() / "prefect"


def environment(url: str | None = None) -> dict[str, str]:
    """The environment of a process that speaks to the server at ``url``; what is set already stays."""
    made = {**QUIET, **os.environ, "PREFECT_HOME": str(prefect_home()), "C4S_HOME": str(home())}
    return made if url is None else made | {"PREFECT_API_URL": url}
