"""What of a run can be dropped, and how many bytes that is. Nothing of it is needed to score, rank or go on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final, Literal, get_args

from c4s.folders import remove_tree
from c4s.records.folder import AttemptFolder, RunFolder
from c4s.run.aside import OUTDATED, TORN

Part = Literal["scratch", "pictures", "interrupted", "aside", "logs"]
PARTS: Final[tuple[Part, ...]] = get_args(Part)
MEANS: Final[dict[Part, str]] = {
    "scratch": "engine logs, job logs and screenshots of attempts",
    "pictures": "pictures that agents were shown",
    "interrupted": "remains of attempts that were cut off",
    "aside": "torn and outdated files that were made again",
    "logs": "logs and journals of processes that have ended",
}


@dataclass(frozen=True)
class Found:
    """A file or folder that can be dropped."""

    part: Part
    path: Path
    size: int
    """Bytes of its files."""


def droppable(run: RunFolder) -> Iterator[Found]:
    """What can be dropped of a run that nobody works on."""
    for trial in run.root.glob("*/*/r[0-9]*"):
        for attempt in trial.glob("attempt-*"):
            if ".interrupted-" in attempt.name:
                yield from _found("interrupted", attempt)
                continue
            kept = AttemptFolder(attempt)
            yield from _found("scratch", kept.scratch)
            yield from _found("pictures", kept.images)
        for what in (TORN, OUTDATED):
            for path in trial.rglob(f"*.{what}-*"):
                if not any(f".{other}-" in parent.name for other in (TORN, OUTDATED) for parent in path.parents):
                    yield from _found("aside", path)
    for folder in (run.logs, run.journals):
        yield from _found("logs", folder)


def drop(found: Found, run: RunFolder) -> None:
    """Remove it."""
    if found.path.is_dir():
        remove_tree(found.path, inside=run.root)
    else:
        found.path.unlink(missing_ok=True)


def size_of(path: Path) -> int:
    """Bytes of a file, or of all files of a folder; links are not followed."""
    if path.is_symlink() or not path.is_dir():
        return path.lstat().st_size
    return sum(inner.lstat().st_size for inner in path.rglob("*") if inner.is_symlink() or inner.is_file())


def _found(part: Part, path: Path) -> Iterator[Found]:
    if path.exists() and not path.is_symlink():
        yield Found(part, path, size_of(path))
