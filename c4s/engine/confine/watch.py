"""What the kernel does not limit for an engine process is watched from outside: memory, threads, files."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from c4s.engine.confine.confinement import Limits

_PAGE = os.sysconf("SC_PAGE_SIZE")


class Watch:
    """Looks at an engine process, with all below it, and at the folders that it may write to."""

    def __init__(self, process: int, folders: Sequence[Path], limits: Limits) -> None:
        self._process, self._folders, self._limits = process, folders, limits

    def breach(self) -> str | None:
        """The first limit that is passed, as text; None while all are kept."""
        limits = self._limits
        memory, threads = self._usage()
        if memory > limits.memory:
            return f"it used more than {limits.memory >> 20} MiB of memory"
        if threads > limits.threads:
            return f"it started more than {limits.threads} threads"
        return next((found for folder in self._folders if (found := overfull(folder, limits)) is not None), None)

    def _usage(self) -> tuple[int, int]:
        """Resident memory (bytes) and threads of the process and all below it."""
        memory = threads = 0
        waiting = [self._process]
        while waiting:
            folder = Path("/proc", str(waiting.pop()))
            try:
                memory += int((folder / "statm").read_text().split()[1]) * _PAGE
                tasks = list((folder / "task").iterdir())
                threads += len(tasks)
                waiting += [int(child) for task in tasks[:4] for child in (task / "children").read_text().split()]
            except (FileNotFoundError, ProcessLookupError):
                continue  # it has just ended
        return memory, threads


def overfull(folder: Path, limits: Limits) -> str | None:
    """The limit that the files below a folder pass. Links are not followed; what has just gone is left out."""
    size = count = 0
    waiting = [str(folder)]
    while waiting:
        try:
            with os.scandir(waiting.pop()) as found:
                entries = list(found)
        except FileNotFoundError:
            continue
        except OSError as error:
            return f"its files cannot be looked at: {error.strerror}"
        count += len(entries)
        size += sum(_size(entry) for entry in entries)
        if count > limits.files:
            return f"it wrote more than {limits.files} files"
        if size > limits.disk:
            return f"its files take more than {limits.disk >> 20} MiB"
        waiting += [entry.path for entry in entries if entry.is_dir(follow_symlinks=False)]
    return None


def _size(entry: os.DirEntry[str]) -> int:
    """Bytes that a file takes on the disk; none when it has just gone."""
    try:
        return entry.stat(follow_symlinks=False).st_blocks * 512
    except FileNotFoundError:
        return 0
