"""Prefect's worker as c4s runs it: a flow run is one process from its start."""

from __future__ import annotations

import sys
from typing import Any

from prefect.utilities.processutils import command_to_string
from prefect.workers.process import ProcessJobConfiguration, ProcessWorker


class FlowRunProcess(ProcessJobConfiguration):
    """How a flow run is started where its pool asks for no command of its own.

    By itself Prefect starts a first program, which loads all of Prefect to prepare a folder with the flow's code and is
    then replaced by the one that runs the flow. The flows of c4s are installed with it.
    """

    def prepare_for_flow_run(self, *arguments: Any, **named: Any) -> None:
        """Complete it for a flow run."""
        if self.command is None:
            self.command = command_to_string([sys.executable, "-m", "flows.program", "prefect.engine"])
        super().prepare_for_flow_run(*arguments, **named)


def taker(pool: str, name: str, limit: int) -> ProcessWorker:
    """A worker that takes the work of a pool, so many flow runs at once."""
    worker = ProcessWorker(work_pool_name=pool, name=name, limit=limit)
    worker.job_configuration = FlowRunProcess
    return worker
