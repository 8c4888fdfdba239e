"""What the kernel does not limit for an engine process is watched from outside: memory, threads, files."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator, Sequence
from pathlib import Path

from c4s.engine.confine.confinement import Limits
from c4s.errors import shortage

_PAGE = os.sysconf("SC_PAGE_SIZE")
_GONE = (FileNotFoundError, ProcessLookupError)
_UNSEEN = (*_GONE, PermissionError)


class Watch:
    """Looks at an engine process, with all below it, and at the folders that it may write to."""

    def __init__(self, process: int, folders: Sequence[Path], limits: Limits) -> None:
        self._process, self._folders, self._limits = process, folders, limits

    def breach(self) -> str | None:
        """The first limit that is passed, as text; None while all are kept."""
        limits = self._limits
        memory = threads = hidden = written = 0
        for folder in tree(self._process, limits.threads):
            try:
                memory += int((folder / "statm").read_text().split()[1]) * _PAGE
                threads += len(list((folder / "task").iterdir()))
            except _GONE:
                continue  # it has just ended
            hidden += hidden_bytes(folder, mapped_as=limits.file_size)
            written += written_bytes(folder)
        if memory > limits.memory:
            return f"it used more than {limits.memory >> 20} MiB of memory"
        if threads > limits.threads:
            return f"it started more than {limits.threads} threads"
        if written > limits.written:
            return f"it wrote more than {limits.written >> 20} MiB in all"
        return overfull(self._folders, limits, hidden)


def tree(process: int, most: int) -> Iterator[Path]:
    """``/proc`` folders of a process and of all below it; not many more than ``most``."""
    waiting, seen = [process], 0
    while waiting and seen <= most:
        folder = Path("/proc", str(waiting.pop()))
        seen += 1
        yield folder
        try:
            for task in (folder / "task").iterdir():
                waiting += map(int, (task / "children").read_text().split())
        except _GONE:
            continue  # it has just ended


def hidden_bytes(process: Path, mapped_as: int = 0) -> int:
    """Bytes on the disk of the files that a process (its ``/proc`` folder) has open or mapped but that have no name.

    How much of the disk one takes that is only mapped cannot be asked: it counts as ``mapped_as``. Nothing is seen of a
    process of another user.
    """
    found: dict[tuple[int, int], int] = {}
    try:
        handles = [entry.path for entry in os.scandir(process / "fd")]
        for line in (process / "maps").read_text(errors="replace").splitlines():
            fields = line.split(maxsplit=5)
            if line.endswith(" (deleted)") and fields[5].startswith("/") and fields[3] != "00:01":
                major, minor = fields[3].split(":")
                found[os.makedev(int(major, 16), int(minor, 16)), int(fields[4])] = mapped_as
    except _UNSEEN:
        return 0
    for handle in handles:
        try:
            told = os.stat(handle)  # noqa: PTH116 - follows the link to a file that has no path
        except _UNSEEN:
            continue
        if stat.S_ISREG(told.st_mode) and not told.st_nlink:
            found[told.st_dev, told.st_ino] = told.st_blocks * 512
    return sum(found.values())


def written_bytes(process: Path) -> int:
    """Bytes that a process has written to disks since it started; 0 where the kernel does not count them."""
    try:
        lines = (process / "io").read_text().splitlines()
    except _UNSEEN:
        return 0
    return next((int(line.split()[1]) for line in lines if line.startswith("write_bytes:")), 0)


def overfull(folders: Sequence[Path], limits: Limits, hidden: int = 0) -> str | None:
    """The limit that the files below some folders pass together, with bytes of files that have no name.

    Links are not followed; what has just gone is left out. ``OSError`` where it is the machine that cannot look.
    """
    size, count = hidden, 0
    waiting = list(map(str, folders))
    while True:
        if count > limits.files:
            return f"it wrote more than {limits.files} files"
        if size > limits.disk:
            return f"its files take more than {limits.disk >> 20} MiB"
        if not waiting:
            return None
        try:
            with os.scandir(waiting.pop()) as found:
                entries = list(found)
            count, size = count + len(entries), size + sum(map(_size, entries))
        except FileNotFoundError:
            continue
        except OSError as error:
            if shortage(error) is not None:
                raise
            return f"its files cannot be looked at: {error.strerror}"
        waiting += [entry.path for entry in entries if entry.is_dir(follow_symlinks=False)]


def _size(entry: os.DirEntry[str]) -> int:
    """Bytes that a file takes on the disk; none when it has just gone."""
    try:
        return entry.stat(follow_symlinks=False).st_blocks * 512
    except FileNotFoundError:
        return 0
