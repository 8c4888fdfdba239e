"""What is worked on has one holder at a time: a run, and each trial in work.

The lease in force is the one of the highest number at its place (``c4s.run.store``). Whoever takes the lease puts a new
one under the next number, which succeeds for one taker alone, on a shared file system and in an object store too; a
lower number is never in force again, so the highest stays when a lease is given back. A holder on this machine that has
ended is replaced at once. Of any other only signs of life tell: a lease is renewed while its holder lives. One that was
not, and is not while it is watched for some beats more (clocks jump), is taken over, be its holder cut off or stopped.
A holder that finds another lease in force, or its own gone, stops before it writes more.
"""

from __future__ import annotations

import asyncio
import os
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from functools import cache
from pathlib import Path

from c4s.errors import BadInput, MachineryFault
from c4s.folders import remove_tree
from c4s.records.folder import RunFolder
from c4s.records.lease import Lease
from c4s.run.owner import is_gone, is_near, this_process
from c4s.run.store import FolderLeases, LeasePlace, open_store

LASTS_S = 60.0
BEAT_S = 5.0
WATCHED_BEATS = 2.5
WAIT_S = 1.0


class RunHeld(BadInput):
    """Somebody else works on the run."""


class LeaseLost(MachineryFault):
    """The lease was taken over or removed."""


class _Keeper:
    """Gives a sign of life for every lease that this process holds, in a thread that is begun with the first one."""

    def __init__(self) -> None:
        self._kept: set[Held] = set()
        self._lock = threading.Lock()
        self._thread: threading.Thread | None = None

    def keep(self, held: Held) -> None:
        with self._lock:
            self._kept.add(held)
            if self._thread is None or not self._thread.is_alive():
                self._thread = threading.Thread(target=self._run, name="leases", daemon=True)
                self._thread.start()

    def let_go(self, held: Held) -> None:
        with self._lock:
            self._kept.discard(held)

    def _run(self) -> None:
        pause = threading.Event()
        while not pause.wait(BEAT_S):
            with self._lock:
                kept = list(self._kept)
            for held in kept:
                with suppress(OSError, MachineryFault):
                    held.beat()


@cache
def _keeper_of(process: int) -> _Keeper:
    """The keeper of a process: one that a fork copied has no thread."""
    return _Keeper()


class Held:
    """A lease that this process holds."""

    def __init__(self, place: LeasePlace, number: int, lease: Lease, what: str) -> None:
        self._place, self._number, self._lease, self._what = place, number, lease, what
        _keeper_of(os.getpid()).keep(self)

    def check(self) -> None:
        """``LeaseLost`` where the lease is no longer this process's."""
        newest = self._place.newest()
        if newest == self._number:
            return
        taken = "the lease was removed"
        if newest is not None and newest > self._number and (now := self._place.read(newest)):
            taken = f"the lease was taken over by {told(now)}"
        raise LeaseLost(
            f"this {self._what} is no longer held here: {taken}",
            where=self._place.where,
            todo=f"nothing more was written; run the same command again once nobody works on the {self._what}",
        )

    async def check_beside(self) -> None:
        """``check``, beside the event loop where it asks over a network."""
        if isinstance(self._place, FolderLeases):
            self.check()
        else:
            await asyncio.to_thread(self.check)

    def beat(self) -> None:
        """A sign of life."""
        self._place.renew(self._number, self._lease)

    def give_back(self) -> None:
        """Let the next one in."""
        _keeper_of(os.getpid()).let_go(self)
        with suppress(LeaseLost):
            self.check()
            self._place.replace(self._number, self._lease.model_copy(update={"given_back": True}))


@contextmanager
def holding(run: Path, *, wait: Callable[[str], None] | None = None) -> Iterator[Held]:
    """Hold the lease of a run folder for the block; the folder is made where it is not there.

    Args:
        run: the run folder.
        wait: where somebody else holds it, is told so in a line, and the call waits; without it ``RunHeld``.
    """
    folder = RunFolder(run)
    place = open_store().leases(folder.leases)
    held = take(place, "run")
    if not isinstance(held, Held) and wait is not None:
        wait(f"waiting for {told(held)}, at work on run {run.name!r}")
        while not isinstance(held, Held):
            time.sleep(WAIT_S)
            held = take(place, "run")
    if not isinstance(held, Held):
        raise RunHeld(
            f"{told(held)} works on this run",
            where=str(run),
            todo=f"wait for it with `c4s run --wait`, or {_way_out(held)}",
        )
    try:
        yield held
    finally:
        held.give_back()
        if isinstance(place, FolderLeases) and not folder.plan.is_file():
            _remove_empty(folder)


def holder(run: RunFolder) -> Lease | None:
    """The lease that somebody holds of a run; None where nobody does. It is not watched for it."""
    return in_force(open_store().leases(run.leases), watch=False)


def at_work(run: RunFolder, *, holders: bool = True) -> str:
    """Who works on a run, for people, be it on a trial alone; empty where nobody does.

    ``holders``: whoever holds the run counts too, not only those that have a trial.
    """
    if holders and (held := holder(run)) is not None:
        return told(held)
    for folder in run.trials():
        if not folder.score.is_file() and (held := in_force(open_store().leases(folder.leases), watch=False)):
            return f"{told(held)}, on the trial {folder.root.relative_to(run.root)}"
    return ""


def take(place: LeasePlace, what: str) -> Held | Lease:
    """The lease of a place, or the one of somebody else that is in force. ``what`` it is of, for people."""
    mine = Lease(owner=this_process(), since=datetime.now(UTC).isoformat(timespec="seconds"), lasts_s=LASTS_S)
    while True:
        newest = place.newest()
        if newest is not None and (other := _in_force(place, newest)) is not None:
            return other
        number = 1 if newest is None else newest + 1
        if not place.take(number, mine):
            continue
        numbers = place.numbers()
        if max(numbers, default=None) == number:
            for older in numbers:
                if older < number:
                    place.remove(older)
            return Held(place, number, mine, what)
        place.remove(number)


def in_force(place: LeasePlace, *, watch: bool = True) -> Lease | None:
    """The lease that somebody holds; None where nobody does. Without ``watch`` a clock that jumped may hide one."""
    newest = place.newest()
    return None if newest is None else _in_force(place, newest, watch=watch)


def _in_force(place: LeasePlace, number: int, *, watch: bool = True) -> Lease | None:
    """A lease; None where it was given back, its holder has ended, or gives no sign of life."""
    lease = place.read(number)
    if lease is None or lease.given_back:
        return None
    if is_near(lease.owner) and is_gone(lease.owner):
        return None
    sign = place.sign(number)
    if sign is None:
        return None
    if place.now() - sign < lease.lasts_s:
        return lease
    if not watch:
        return None
    watched = time.monotonic() + WATCHED_BEATS * BEAT_S
    while time.monotonic() < watched:
        time.sleep(min(WAIT_S, BEAT_S))
        if place.sign(number) not in (None, sign):
            return lease
    return None


def _remove_empty(run: RunFolder) -> None:
    """A run that was never planned leaves no folder."""
    if [path for path in run.root.iterdir() if path != run.leases]:
        return
    remove_tree(run.leases, inside=run.root)
    with suppress(OSError):
        run.root.rmdir()


def _way_out(lease: Lease) -> str:
    if is_near(lease.owner):
        return "stop that process"
    return f"end it there: the run is free {lease.lasts_s:.0f} s after its last sign of life"


def told(lease: Lease) -> str:
    """Who holds it, for people."""
    owner = lease.owner
    return f"process {owner.pid} on {owner.host}, since {lease.since}"
