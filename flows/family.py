"""Processes that a worker starts end with it, however it ends."""

from __future__ import annotations

import ctypes
import os
import tempfile
from typing import Final

from c4s.run.worker import PR_SET_CHILD_SUBREAPER, die_with

WORKER: Final = "C4S_WORKER"
"""Process id of the worker that started this process's flow run."""


TEMPORARY: Final = "C4S_WORKER_TMPDIR"
"""The temporary folder of what works on trials, whose folders tell whose they are; ``TMPDIR`` is for Prefect's own."""


def die_with_the_worker() -> None:
    """Let the kernel end this process with the worker that started it, and take the machine's temporary folder again.
    Nothing where no worker of c4s started it."""
    worker = os.environ.get(WORKER)
    if worker is not None and str(os.getppid()) == worker:
        die_with(int(worker))
    if TEMPORARY in os.environ:
        os.environ["TMPDIR"] = tempfile.tempdir = os.environ.pop(TEMPORARY)


def adopt() -> None:
    """What a child of this process leaves behind becomes a child of this process."""
    ctypes.CDLL(None, use_errno=True).prctl(PR_SET_CHILD_SUBREAPER, 1)
