"""Stages run in worker processes of their own: an engine slot each, out of reach of Prefect's threads.

The pool is started once, by the flow, before tasks are submitted; its workers die with the process that made them.
"""

from __future__ import annotations

import ctypes
import multiprocessing
import os
import signal
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from typing import ParamSpec, TypeVar

from c4s.errors import MachineryFault

P = ParamSpec("P")
R = TypeVar("R")
PR_SET_PDEATHSIG = 1
_pool: ProcessPoolExecutor | None = None


def _start(parent: int) -> None:
    """In a new worker: die with the parent, leave Ctrl-C to it, and use one thread a numeric library."""
    ctypes.CDLL(None, use_errno=True).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(1)
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _ready() -> int:
    return os.getpid()


@contextmanager
def engine_slots(slots: int) -> Iterator[None]:
    """Worker processes for the duration of a flow, one a slot. Started here so that this thread is their parent."""
    global _pool
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(slots, mp_context=context, initializer=_start, initargs=(os.getpid(),)) as pool:
        pool.submit(_ready).result()
        _pool = pool
        try:
            yield
        finally:
            _pool = None
            pool.shutdown(wait=True, cancel_futures=True)


def in_slot(stage: Callable[P, R], *args: P.args, **kwargs: P.kwargs) -> R:
    """Run a stage in an engine slot and wait for it; without a pool (a task run by hand) run it here."""
    if _pool is None:
        return stage(*args, **kwargs)
    try:
        return _pool.submit(stage, *args, **kwargs).result()
    except OSError as error:
        raise MachineryFault(f"a worker process failed: {error}") from error
