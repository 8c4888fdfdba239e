"""The files of a frozen folder: their names and digests, and what differs from what was frozen.

Content is the relative names of plain files and their bytes. Modes, times and empty folders are not content: nothing
reads them, and not every copy keeps them. A link or a special file is refused: it could lead out of the folder.

A digest that was computed once is kept under ``C4S_HOME/cache`` with the file's size, times and inode, and taken again
while these are the same. A full check reads every byte: also one that a process changed through a mapping of the file,
which shows in the file's times only once the system has written it back.
"""

from __future__ import annotations

import os
import stat
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import msgspec

from c4s.errors import BadInput
from c4s.files import digest, digest_bytes, digest_file
from c4s.home import cache_root

Listing = dict[str, str]
"""Relative name (``/`` between folders) to SHA-256 (64 hex) of the bytes."""
Stamp = tuple[int, int, int, int]
"""Size, time of the last change of the bytes (ns), of the file's record (ns), inode."""
_YOUNG_NS = 100_000_000
"""A file that changed so shortly before it was read could change again under the same times: it is not remembered."""
_MOST_KNOWN = 256
"""Folders whose digests a process holds in memory."""
_known: dict[str, dict[str, tuple[Stamp, str]]] = {}
_decoder = msgspec.json.Decoder(dict[str, tuple[Stamp, str]])


@dataclass(frozen=True)
class Change:
    """A file that is not as it was frozen."""

    file: Path
    what: Literal["changed", "missing", "extra", "unsound"]
    detail: str = ""

    def told(self) -> str:
        """What is wrong with the file, in a few words."""
        if self.what == "unsound":
            return self.detail
        return {
            "changed": "the file has changed since it was frozen",
            "missing": "the file is missing",
            "extra": "the file was not there when this was frozen",
        }[self.what]


def refuse(changes: Iterable[Change], *, todo: str) -> None:
    """Raise ``BadInput`` that names the first change and counts the others; nothing where there is none."""
    found = list(changes)
    if found:
        more = f"; {len(found) - 1} more" if len(found) > 1 else ""
        raise BadInput(f"{found[0].told()}{more}", where=str(found[0].file), todo=todo)


def files_under(folder: Path) -> Iterator[tuple[str, os.stat_result]]:
    """Relative names and records of all plain files; ``BadInput`` for anything else, or when there is no folder."""
    waiting = [(str(folder), "")]
    while waiting:
        place, prefix = waiting.pop()
        try:
            entries = os.scandir(place)
        except OSError as error:
            raise BadInput(f"this folder cannot be read: {error.strerror}", where=place) from None
        with entries:
            for entry in entries:
                record, name = entry.stat(follow_symlinks=False), prefix + entry.name
                if not name.isprintable():
                    raise BadInput(f"the name {name!a} is no text", where=place)
                if stat.S_ISDIR(record.st_mode):
                    waiting.append((entry.path, f"{name}/"))
                elif stat.S_ISREG(record.st_mode):
                    yield name, record
                else:
                    kind = "a link" if stat.S_ISLNK(record.st_mode) else "a special file"
                    raise BadInput(f"{kind} is not allowed in a frozen folder", where=entry.path)


def digests(folder: Path, *, full: bool = False, told: Callable[[str], None] | None = None) -> Listing:
    """The listing of a folder. ``full``: read every byte, whatever was known; ``told``: called with each name."""
    place = str(folder.absolute())
    kept = cache_root() / "digests" / f"{digest_bytes(place.encode())[:32]}.json"
    known = {} if full else _known.get(place) or _read(kept)
    young = time.time_ns() - _YOUNG_NS
    listing: Listing = {}
    fresh: dict[str, tuple[Stamp, str]] = {}
    for name, record in files_under(folder):
        if told is not None:
            told(name)
        stamp = (record.st_size, record.st_mtime_ns, record.st_ctime_ns, record.st_ino)
        before = known.get(name)
        listing[name] = before[1] if before is not None and before[0] == stamp else digest_file(folder / name)
        if max(stamp[1], stamp[2]) < young:
            fresh[name] = (stamp, listing[name])
    if fresh != known:
        _write(kept, fresh)
    if len(_known) >= _MOST_KNOWN:
        _known.clear()
    _known[place] = fresh
    return listing


def _read(kept: Path) -> dict[str, tuple[Stamp, str]]:
    """What was kept; nothing where there is no such file, or none that this version wrote."""
    try:
        return _decoder.decode(kept.read_bytes())
    except (FileNotFoundError, msgspec.MsgspecError):
        return {}


def _write(kept: Path, known: Mapping[str, tuple[Stamp, str]]) -> None:
    """Keep digests. Not synced: what a crash loses is computed again."""
    kept.parent.mkdir(parents=True, exist_ok=True)
    new = kept.with_name(f".{kept.name}.{os.getpid()}.{time.monotonic_ns()}")
    new.write_bytes(msgspec.json.encode(known))
    new.replace(kept)


def listing_digest(listing: Mapping[str, str]) -> str:
    """SHA-256 of a listing: the digest of the folder."""
    return digest([[name, listing[name]] for name in sorted(listing, key=lambda name: name.split("/"))])


def read_listing(folder: Path) -> Listing:
    """The listing of a folder, every byte read and nothing kept."""
    return {name: digest_file(folder / name) for name, _ in files_under(folder)}


def digest_tree(folder: Path) -> str:
    """SHA-256 of the sorted relative names and contents of all files under ``folder``, every byte read."""
    return listing_digest(read_listing(folder))


def changes(folder: Path, frozen: Mapping[str, str], found: Mapping[str, str]) -> list[Change]:
    """What differs between a folder's frozen listing and the one that is found, in the order of the names."""
    rows = []
    for name in sorted({**frozen, **found}):
        if name not in found:
            rows.append(Change(folder / name, "missing"))
        elif name not in frozen:
            rows.append(Change(folder / name, "extra"))
        elif frozen[name] != found[name]:
            rows.append(Change(folder / name, "changed"))
    return rows
