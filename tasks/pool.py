"""Stages run in worker processes of their own: an engine slot each, out of reach of Prefect's threads.

The pool is started once, by the flow, before tasks are submitted; its workers die with the process that made them.
"""

from __future__ import annotations

import ctypes
import multiprocessing
import os
import signal
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Concatenate, ParamSpec, TypeVar

from c4s.errors import MachineryFault
from c4s.run.plan import Trial
from c4s.run.stages import record_time

P = ParamSpec("P")
R = TypeVar("R")
PR_SET_PDEATHSIG = 1


@dataclass(frozen=True)
class _Slots:
    pool: ProcessPoolExecutor
    free: threading.Semaphore


_slots: _Slots | None = None


def _start(parent: int) -> None:
    """In a new worker: die with the parent, and leave Ctrl-C to it."""
    ctypes.CDLL(None, use_errno=True).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(1)
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _timed(stage: Callable[..., R], args: tuple[Any, ...]) -> tuple[R, float]:
    started = time.perf_counter()
    return stage(*args), time.perf_counter() - started


@contextmanager
def engine_slots(slots: int) -> Iterator[None]:
    """Worker processes for the duration of a flow, one a slot. Started here so that this thread is their parent."""
    global _slots
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(slots, mp_context=context, initializer=_start, initargs=(os.getpid(),)) as pool:
        pool.submit(os.getpid).result()
        _slots = _Slots(pool, threading.Semaphore(slots))
        try:
            yield
        finally:
            _slots = None
            pool.shutdown(wait=True, cancel_futures=True)


def in_slot(stage: Callable[Concatenate[Trial, P], R], trial: Trial, *args: P.args, **kwargs: P.kwargs) -> R:
    """Run a stage in an engine slot, and record what handing it over cost beyond the stage itself.

    Waiting for a free slot is not counted. Without a pool (a task run by hand) the stage runs here.
    """
    if _slots is None:
        return stage(trial, *args, **kwargs)
    with _slots.free:
        started = time.perf_counter()
        try:
            result, spent = _slots.pool.submit(_timed, stage, (trial, *args)).result()
        except BrokenProcessPool as error:
            raise MachineryFault(
                "a worker process died", where=trial.name, todo="run the same command again"
            ) from error
        record_time(trial, "orchestration", time.perf_counter() - started - spent)
    return result
