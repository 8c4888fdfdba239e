"""Whether there is room to work: disk, descriptors, memory. A run without it pauses, and goes on by itself.

Room is asked for before each stage and looked at while stages run. What fails while there is none says nothing of the
agent: it is done again once there is room.
"""

from __future__ import annotations

import asyncio
import os
import resource
import tempfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from c4s.errors import MachineryFault
from c4s.home import home, runs_root, warehouse_root
from c4s.run.logs import LOGGER
from c4s.stderr import as_json, tell

LOOK_S = 1.0
MOST_DESCRIPTORS = 1 << 16
REPEATS = 2
"""How often a stage is done again that ended while there was no room."""


class NoRoom(MachineryFault):
    """Something ended while there was no room to work."""


@dataclass(frozen=True)
class Floors:
    """Below one of these nothing is started: free bytes and files of a disk, free descriptors, bytes of memory."""

    disk_bytes: int = 256 << 20
    disk_files: int = 2000
    descriptors: int = 64
    memory_bytes: int = 512 << 20


def raise_descriptors() -> None:
    """Let this process and those that it starts open as many files as the system allows them, up to a bound."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    allowed = MOST_DESCRIPTORS if hard == resource.RLIM_INFINITY else min(hard, MOST_DESCRIPTORS)
    if soft != resource.RLIM_INFINITY and soft < allowed:
        resource.setrlimit(resource.RLIMIT_NOFILE, (allowed, hard))


def shortages(places: Sequence[Path], floors: Floors) -> Iterator[str]:
    """What there is too little of, and where, each in a few words."""
    for place in places:
        found = os.statvfs(_there(place))
        free = found.f_bavail * found.f_frsize
        if free < floors.disk_bytes:
            yield f"{place} has {free >> 20} MiB of disk left and a run needs {floors.disk_bytes >> 20}"
        if found.f_files and found.f_favail < floors.disk_files:
            yield f"{place} has room for {found.f_favail} files and a run needs {floors.disk_files}"
    limit = resource.getrlimit(resource.RLIMIT_NOFILE)[0]
    free_descriptors = limit - len(os.listdir("/proc/self/fd"))  # noqa: PTH208
    if limit != resource.RLIM_INFINITY and free_descriptors < floors.descriptors:
        yield f"process {os.getpid()} may open {free_descriptors} more files and needs {floors.descriptors}"
    available = _memory_available()
    if available < floors.memory_bytes:
        yield f"this machine has {available >> 20} MiB of memory left and a run needs {floors.memory_bytes >> 20}"


def _memory_available() -> int:
    """Bytes that processes may still take."""
    for line in Path("/proc/meminfo").read_text().splitlines():
        name, _, value = line.partition(":")
        if name == "MemAvailable":
            return int(value.split()[0]) << 10
    return 1 << 62


def places() -> list[Path]:
    """Where runs write, one folder a disk: ``C4S_HOME``, its parts that lie elsewhere, the temporary folder."""
    by_disk: dict[int, Path] = {}
    for place in (home(), runs_root(), warehouse_root(), Path(tempfile.gettempdir())):
        by_disk.setdefault(_there(place).stat().st_dev, place)
    return list(by_disk.values())


def _there(place: Path) -> Path:
    """The folder, or the lowest above it that is there."""
    return next(path for path in (place, *place.parents) if path.exists())


def check_room() -> None:
    """``NoRoom`` where this process has none, so that what just ended is nobody's outcome."""
    for short in shortages(places(), Floors()):
        raise NoRoom(short, todo="make room and run the same command again")


def print_line(line: str) -> None:
    """A line for the operator, and for the log of the run."""
    LOGGER.info(line)
    if not (LOGGER.handlers and as_json()):
        tell(f"c4s: {line}")


class Headroom:
    """The watch over room for a run.

    Args:
        floors: how much is needed.
        tell: is given one line when a run pauses, and one when it goes on.
    """

    def __init__(self, floors: Floors | None = None, tell: Callable[[str], None] = print_line) -> None:
        self._floors = floors or Floors()
        self._tell = tell
        self._short = False
        self.times_short = 0
        """How often a look found no room: it does not change while there is enough."""

    def look(self) -> bool:
        """Whether there is room; tells when that has changed."""
        short = "; ".join(shortages(places(), self._floors))
        if short:
            self.times_short += 1
        if bool(short) != self._short:
            self._short = bool(short)
            self._tell(f"paused: {short} (the run goes on by itself)" if short else "there is room again: going on")
        return not short

    async def room(self, give_up: Callable[[], None] = lambda: None) -> None:
        """Wait until there is room, or until ``give_up`` raises: it is called after each look that found none."""
        while not self.look():
            give_up()
            await asyncio.sleep(LOOK_S)
