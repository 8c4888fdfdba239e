"""Copies of a home's runs, suites, packs, warehouse parts and human studies, each file under its digest, and back.

Both go on where they were cut off: bytes that are there are not copied again. The manifest is replaced last, in one
step, and only then is what it no longer names removed: a backup that is cut off leaves the one before. What is derived
(the warehouse's database, pages, caches) is not copied.
"""

from __future__ import annotations

import fcntl
import hashlib
import os
import tempfile
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path, PurePosixPath
from typing import BinaryIO, Final, Literal, get_args

from c4s.errors import BadInput, MachineryFault
from c4s.files import digest_file
from c4s.home import home
from c4s.names import file_in
from c4s.records.backup import Backup, KeptFile
from c4s.records.folder import RunFolder
from c4s.run.lease import at_work

Part = Literal["runs", "suites", "packs", "warehouse", "human"]
PARTS: Final[tuple[Part, ...]] = get_args(Part)
MANIFEST = "backup.json"
_BYTES = "files"
_LOCK = ".lock"
_STORED = ".parquet"
"""Of the warehouse, only the parts are copied."""
_BLOCK = 1 << 20


@dataclass(frozen=True)
class Copied:
    """What a backup or a restore did."""

    files: int
    """All files of the backup."""
    copied: int
    """Of them: those that were not there yet."""
    size: int
    """Bytes of all files."""
    left_out: list[str]
    """Runs that somebody worked on."""
    links: int = 0
    """Links, which are not copied: frozen content has none."""


def back_up(to: Path, parts: Iterable[Part]) -> Copied:
    """Copy parts of the home to a folder. ``BadInput`` for a folder that is no backup, or lies in the home.

    What an earlier backup holds of other parts, and of runs that somebody works on, stays in it as it was.
    """
    root = home().resolve()
    _check_place(to, root)
    (to / _BYTES).mkdir(parents=True, exist_ok=True)
    with _alone(to):
        left_out = [run.root.name for run in RunFolder.planned(root / "runs") if at_work(run)]
        parts = list(parts)
        before = _before(to)
        kept, copied, links = [file for file in before if not _is_asked(file, parts, left_out)], 0, 0
        for path in _files(root, parts, left_out):
            if path.is_symlink():
                links += 1
                continue
            try:
                file, fresh = _keep(path, to, path.relative_to(root).as_posix())
            except (FileNotFoundError, BadInput):
                if os.path.lexists(path):
                    raise
                continue
            kept.append(file)
            copied += fresh
        made = datetime.now(UTC).isoformat(timespec="seconds")
        held = {file.path.partition("/")[0] for file in kept}
        held_parts: list[str] = [part for part in PARTS if part in parts or part in held]
        Backup(made=made, parts=held_parts, left_out=left_out, files=kept).write(to / MANIFEST)
        _sweep(to / _BYTES, {file.digest for file in kept})
    return Copied(len(kept), copied, sum(file.size for file in kept), left_out, links)


def restore(source: Path) -> Copied:
    """Copy a backup's files back to the home, each compared with its digest before it is in its place.

    ``BadInput`` before anything is written where the backup names what is no file of a part, a file of it is missing,
    or the home holds a file of the same name with other content; ``BadInput`` too for a file of it that has changed.
    """
    manifest = Backup.read(source / MANIFEST)
    targets = _targets(manifest, source)
    waiting = [
        (file, _place(source, file.digest), target)
        for file, target in zip(manifest.files, targets, strict=True)
        if not _is_there(file, target)
    ]
    for file, path, target in waiting:
        if not path.is_file() or path.stat().st_size != file.size:
            raise BadInput(
                f"the bytes of {file.path} are missing or cut off", where=str(path), todo="use another backup"
            )
        if os.path.lexists(target):
            raise BadInput("the home holds another file of this name", where=str(target), todo="move it away first")
    for file, path, target in waiting:
        with path.open("rb") as opened:
            if _put(opened, target.parent, _if_it_is(file.digest, target)) != file.digest:
                raise BadInput(
                    f"the file has changed since it was kept: {file.path}", where=str(path), todo="use another backup"
                )
    return Copied(len(manifest.files), len(waiting), sum(file.size for file in manifest.files), manifest.left_out)


def _if_it_is(digest: str, target: Path) -> Callable[[str], Path | None]:
    return lambda found: target if found == digest else None


@contextmanager
def _alone(to: Path) -> Iterator[None]:
    """Hold a backup's folder for the block. ``BadInput`` where another process writes to it."""
    with (to / _LOCK).open("ab") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise BadInput("another backup to this folder is at work", where=str(to), todo="wait for it") from None
        yield


def _before(to: Path) -> list[KeptFile]:
    """The files of the backup that lies there; none where it has no manifest that can be used."""
    try:
        return Backup.read(to / MANIFEST).files
    except BadInput:
        return []


def _is_asked(file: KeptFile, parts: list[Part], left_out: list[str]) -> bool:
    """Whether a file belongs to what is copied now."""
    part, _, inner = file.path.partition("/")
    return part in parts and not (part == "runs" and inner.partition("/")[0] in left_out)


def _place(backup: Path, digest: str) -> Path:
    """Where a backup keeps bytes."""
    return backup / _BYTES / digest[:2] / digest


def _sweep(kept: Path, named: set[str]) -> None:
    """Remove bytes that no file of the backup has, and what copies that were cut off left."""
    for path in kept.glob("??/*"):
        if path.name not in named:
            path.unlink()


def _check_place(to: Path, root: Path) -> None:
    real = to.resolve()
    if real == root or root in real.parents or real in root.parents:
        raise BadInput("a backup lies outside of the home that it is of", where=str(to), todo="name another folder")
    if os.path.lexists(to) and (not to.is_dir() or (any(to.iterdir()) and not (to / _BYTES).is_dir())):
        raise BadInput("this is no backup and no new or empty folder", where=str(to), todo="name another folder")


def _files(root: Path, parts: list[Part], left_out: list[str]) -> Iterator[Path]:
    """The files and links of the parts, in order; links are not followed."""
    for part in parts:
        for folder, inner, names in os.walk((root / part).resolve()):
            inside = Path(folder).relative_to((root / part).resolve())
            if part == "runs" and not inside.parts:
                inner[:] = [name for name in inner if name not in left_out]
            inner.sort()
            for name in sorted([*names, *(name for name in inner if (Path(folder) / name).is_symlink())]):
                path = root / part / inside / name
                if part == "warehouse" and path.suffix != _STORED:
                    continue
                if path.is_symlink() or path.is_file():
                    yield path


def _keep(path: Path, to: Path, name: str) -> tuple[KeptFile, bool]:
    """Keep a file's bytes where they are not there yet: its row, and whether they were copied."""
    size, found = path.stat().st_size, digest_file(path)
    target = _place(to, found)
    if target.is_file() and target.stat().st_size == size and digest_file(target) == found:
        return KeptFile(path=name, size=size, digest=found), False
    with path.open("rb") as opened:
        found = _put(opened, target.parent, lambda digest: _place(to, digest))
    return KeptFile(path=name, size=_place(to, found).stat().st_size, digest=found), True


def _put(source: BinaryIO, scratch: Path, place: Callable[[str], Path | None]) -> str:
    """Copy a file by way of a folder to the place that its digest has, if any; returns the digest."""
    scratch.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=scratch, prefix=".copy.")
    made, digest = Path(name), hashlib.sha256()
    try:
        with os.fdopen(handle, "wb") as out:
            while block := source.read(_BLOCK):
                digest.update(block)
                out.write(block)
            out.flush()
            os.fsync(out.fileno())
        if (target := place(digest.hexdigest())) is not None:
            target.parent.mkdir(parents=True, exist_ok=True)
            made.chmod(0o644)
            made.replace(target)
    except OSError as error:
        raise MachineryFault(f"cannot copy: {error}", where=str(scratch), todo="run the same command again") from error
    finally:
        made.unlink(missing_ok=True)
    return digest.hexdigest()


def _is_there(file: KeptFile, target: Path) -> bool:
    return target.is_file() and target.stat().st_size == file.size and digest_file(target) == file.digest


def _targets(manifest: Backup, source: Path) -> list[Path]:
    """Where the files of a backup belong in the home. ``BadInput`` for names that no backup of a home has."""
    where, root = str(source / MANIFEST), home()
    times = Counter(PurePosixPath(file.path) for file in manifest.files)
    for file in manifest.files:
        path = PurePosixPath(file.path)
        if len(path.parts) < 2 or path.parts[0] not in PARTS:
            raise BadInput(f"{file.path} is in no part that a backup has", where=where)
        if times[path] > 1 or any(above in times for above in path.parents):
            raise BadInput(f"{file.path} and another file of this backup have one place", where=where)
    return [file_in(root, file.path) for file in manifest.files]
