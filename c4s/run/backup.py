"""Copies of a home's runs, suites, packs and warehouse parts, each file with its digest; and the way back.

Both go on where they were cut off: a file that is there with the same bytes is not copied again, and the manifest is
written last. What is derived (the warehouse's database, pages, caches) is not copied.
"""

from __future__ import annotations

import hashlib
import os
import stat
import tempfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import BinaryIO, Final, Literal, get_args

from c4s.errors import BadInput, MachineryFault
from c4s.files import digest_file
from c4s.home import home
from c4s.names import file_in
from c4s.records.backup import Backup, KeptFile
from c4s.records.folder import RunFolder
from c4s.run.lease import at_work

Part = Literal["runs", "suites", "packs", "warehouse"]
PARTS: Final[tuple[Part, ...]] = get_args(Part)
MANIFEST = "backup.json"
_BYTES = "files"
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
    """Copy parts of the home to a folder. ``BadInput`` for a folder that is no backup, or lies in the home."""
    root = home().resolve()
    _check_place(to, root)
    (to / _BYTES).mkdir(parents=True, exist_ok=True)
    left_out = [run.root.name for run in RunFolder.planned(root / "runs") if at_work(run)]
    parts = list(parts)
    (to / MANIFEST).unlink(missing_ok=True)
    kept, copied, links = [], 0, 0
    for path in _files(root, parts, left_out):
        if path.is_symlink():
            links += 1
            continue
        name = path.relative_to(root).as_posix()
        try:
            file, fresh = _keep(path, to / _BYTES / name, name)
        except FileNotFoundError:
            continue
        kept.append(file)
        copied += fresh
    made = datetime.now(UTC).isoformat(timespec="seconds")
    Backup(made=made, parts=[*parts], left_out=left_out, files=kept).write(to / MANIFEST)
    return Copied(len(kept), copied, sum(file.size for file in kept), left_out, links)


def restore(source: Path) -> Copied:
    """Copy a backup's files back to the home, each compared with its digest before it is in its place.

    ``BadInput`` before anything is written where a file of the backup is missing, or the home holds a file of the same
    name with other content; ``BadInput`` too for a file of the backup that has changed.
    """
    manifest = Backup.read(source / MANIFEST)
    root = home()
    waiting = [
        (file, _inside(source / _BYTES, file, source), target)
        for file in manifest.files
        if not _is_there(file, target := _inside(root, file, source))
    ]
    for file, path, target in waiting:
        if not path.is_file() or path.stat().st_size != file.size:
            raise BadInput("this file of the backup is missing or cut off", where=str(path), todo="use another backup")
        if os.path.lexists(target):
            raise BadInput("the home holds another file of this name", where=str(target), todo="move it away first")
    for file, path, target in waiting:
        with path.open("rb") as opened:
            if _put(opened, target, file.digest) != file.digest:
                raise BadInput("the file has changed since it was kept", where=str(path), todo="use another backup")
    return Copied(len(manifest.files), len(waiting), sum(file.size for file in manifest.files), manifest.left_out)


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
                if path.is_symlink() or stat.S_ISREG(path.lstat().st_mode):
                    yield path


def _keep(path: Path, target: Path, name: str) -> tuple[KeptFile, bool]:
    """Copy a file where it is not there yet: its row, and whether it was copied."""
    size = path.stat().st_size
    if target.is_file() and target.stat().st_size == size and (found := digest_file(target)) == digest_file(path):
        return KeptFile(path=name, size=size, digest=found), False
    with path.open("rb") as opened:
        found = _put(opened, target, None)
    return KeptFile(path=name, size=target.stat().st_size, digest=found), True


def _put(source: BinaryIO, target: Path, wanted: str | None) -> str:
    """Copy a file to its place, where its digest is the wanted one; returns the digest that it has."""
    target.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name[:80]}.")
    made, digest = Path(name), hashlib.sha256()
    try:
        with os.fdopen(handle, "wb") as out:
            while block := source.read(_BLOCK):
                digest.update(block)
                out.write(block)
            out.flush()
            os.fsync(out.fileno())
        if wanted in (None, digest.hexdigest()):
            made.chmod(0o644)
            made.replace(target)
    except OSError as error:
        raise MachineryFault(f"cannot copy: {error}", where=str(target), todo="run the same command again") from error
    finally:
        made.unlink(missing_ok=True)
    return digest.hexdigest()


def _is_there(file: KeptFile, target: Path) -> bool:
    return target.is_file() and target.stat().st_size == file.size and digest_file(target) == file.digest


def _inside(root: Path, file: KeptFile, source: Path) -> Path:
    if file.path.partition("/")[0] not in PARTS:
        raise BadInput(f"{file.path} is in no part that a backup has", where=str(source / MANIFEST))
    return file_in(root, file.path)
