"""A run has one holder at a time: the lease of its folder.

The lease in force is the file of the highest number in the run's lease folder. Whoever takes the lease links a new file
under the next number, which succeeds for one taker alone, on a shared file system too; a lower number is never in
force again, so the highest file stays when a lease is given back. A holder on this machine that has ended is replaced
at once. Of a holder elsewhere only the file's time tells: it is renewed while the holder lives, and a lease that was
not is taken over. A holder that finds another lease in force, or its own gone, stops before it writes more.
"""

from __future__ import annotations

import os
import threading
import time
import uuid
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from pathlib import Path

from c4s.errors import BadInput, MachineryFault
from c4s.folders import remove_tree
from c4s.records.folder import RunFolder
from c4s.records.lease import Lease
from c4s.run.owner import is_gone, is_near, this_process

LASTS_S = 60.0
BEAT_S = 5.0
WAIT_S = 1.0


class RunHeld(BadInput):
    """Somebody else works on the run."""


class LeaseLost(MachineryFault):
    """The lease was taken over or removed."""


class Held:
    """A lease that this process holds."""

    def __init__(self, run: RunFolder, number: int, lease: Lease) -> None:
        self._run, self._number, self._lease = run, number, lease
        self._ended = threading.Event()
        self._beating = threading.Thread(target=self._beat, name="lease", daemon=True)
        self._beating.start()

    def check(self) -> None:
        """``LeaseLost`` where the lease is no longer this process's."""
        newest = _newest(self._run)
        if newest == self._number and self._run.lease(newest).exists():
            return
        taken = "the lease was removed"
        if newest is not None and newest > self._number and (now := _read(self._run.lease(newest))):
            taken = f"the lease was taken over by {_told(now)}"
        raise LeaseLost(
            f"this run is no longer held here: {taken}",
            where=str(self._run.root),
            todo="nothing more was written; run the same command again once nobody works on the run",
        )

    def give_back(self) -> None:
        """Let the next one in."""
        self._ended.set()
        self._beating.join()
        with suppress(LeaseLost):
            self.check()
            self._lease.model_copy(update={"given_back": True}).write(self._run.lease(self._number))

    def _beat(self) -> None:
        while not self._ended.wait(BEAT_S):
            with suppress(OSError):
                os.utime(self._run.lease(self._number))


@contextmanager
def holding(run: Path, *, wait: Callable[[str], None] | None = None) -> Iterator[Held]:
    """Hold the lease of a run folder for the block; the folder is made where it is not there.

    Args:
        run: the run folder.
        wait: where somebody else holds it, is told so in a line, and the call waits; without it ``RunHeld``.
    """
    folder = RunFolder(run)
    held = _taken(folder)
    if not isinstance(held, Held) and wait is not None:
        wait(f"waiting for {_told(held)}, at work on run {run.name!r}")
        while not isinstance(held, Held):
            time.sleep(WAIT_S)
            held = _taken(folder)
    if not isinstance(held, Held):
        raise RunHeld(
            f"{_told(held)} works on this run",
            where=str(run),
            todo=f"wait for it with `c4s run --wait`, or {_way_out(held)}",
        )
    try:
        yield held
    finally:
        held.give_back()
        if not folder.plan.is_file():
            _remove_empty(folder)


def holder(run: RunFolder) -> Lease | None:
    """The lease that somebody holds of a run, by this machine's clock; None where nobody does."""
    newest = _newest(run)
    lease = None if newest is None else _read(run.lease(newest))
    if newest is None or lease is None or lease.given_back:
        return None
    if is_near(lease.owner):
        return None if is_gone(lease.owner) else lease
    with suppress(FileNotFoundError):
        if time.time() - run.lease(newest).stat().st_mtime < lease.lasts_s:
            return lease
    return None


def _taken(run: RunFolder) -> Held | Lease:
    """The lease, or the one of somebody else that is in force."""
    mine = Lease(owner=this_process(), since=datetime.now(UTC).isoformat(timespec="seconds"), lasts_s=LASTS_S)
    run.leases.mkdir(parents=True, exist_ok=True)
    fresh = run.leases / f".{uuid.uuid4().hex}"
    mine.write(fresh)
    try:
        while True:
            newest = _newest(run)
            if newest is not None and (other := _in_force(run.lease(newest), fresh)) is not None:
                return other
            number = 1 if newest is None else newest + 1
            try:
                os.link(fresh, run.lease(number))
            except FileExistsError:
                continue
            if _newest(run) == number:
                _remove_older(run, number)
                return Held(run, number, mine)
            run.lease(number).unlink(missing_ok=True)
    finally:
        fresh.unlink(missing_ok=True)


def _in_force(path: Path, fresh: Path) -> Lease | None:
    """The lease of a file; None where it was given back, its holder has ended, or it was not renewed in time.

    ``fresh`` was written just now: its time is what the file system's clock says.
    """
    lease = _read(path)
    if lease is None or lease.given_back:
        return None
    if is_near(lease.owner):
        return None if is_gone(lease.owner) else lease
    try:
        silent_s = fresh.stat().st_mtime - path.stat().st_mtime
    except FileNotFoundError:
        return None
    return lease if silent_s < lease.lasts_s else None


def _read(path: Path) -> Lease | None:
    """A lease on file; None for a file that is gone or no lease: it holds nothing."""
    try:
        return Lease.read(path)
    except BadInput:
        return None


def _newest(run: RunFolder) -> int | None:
    with suppress(FileNotFoundError):
        return max((int(path.stem) for path in run.leases.glob("[0-9]*.json")), default=None)
    return None


def _remove_older(run: RunFolder, number: int) -> None:
    for path in run.leases.glob("[0-9]*.json"):
        if int(path.stem) < number:
            path.unlink(missing_ok=True)


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


def _told(lease: Lease) -> str:
    owner = lease.owner
    return f"process {owner.pid} on {owner.host}, since {lease.since}"
