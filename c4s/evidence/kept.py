"""Pictures kept in ``C4S_HOME/cache/pictures`` under a digest of all that they show: the PNG, its mask, a note of both.

The note is written last and holds the digests of all three: what is torn or damaged is as if it were not there,
and is made again. The least recently used are dropped beyond ``MOST_BYTES``. Any number of processes may read, keep and
drop at once, and the folder may be deleted at any time.
"""

from __future__ import annotations

import os
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c4s.errors import BadInput
from c4s.files import digest, digest_bytes, is_unfinished, read_json, write_bytes, write_json
from c4s.home import cache_root

MOST_BYTES = 4 << 30


@dataclass(frozen=True)
class KeptPicture:
    """A picture (PNG), its actor mask (npz), and how many pixels each actor has, by object name."""

    picture: bytes
    mask: bytes
    visible: dict[str, int]


def kept_picture(key: str) -> KeptPicture | None:
    """What is kept under a key; None where nothing sound is."""
    picture, mask, note = _files(key)
    try:
        told: Any = read_json(note)
        found = KeptPicture(picture.read_bytes(), mask.read_bytes(), told["visible"])
        if told["sha256"] != _digests(found):
            return None
        os.utime(note)
    except (BadInput, OSError, KeyError, TypeError):
        return None
    return found


def keep_picture(key: str, made: KeptPicture) -> None:
    """Keep a picture under its key, in place of what is there; where it cannot be written, nothing is kept."""
    picture, mask, note = _files(key)
    with suppress(OSError):
        write_bytes(picture, made.picture)
        write_bytes(mask, made.mask)
        write_json(note, {"visible": made.visible, "sha256": _digests(made)}, indent=None)


def drop_oldest(most_bytes: int = MOST_BYTES) -> None:
    """Drop the least recently used until no more than this many bytes are kept, each note before what it names."""
    sizes: dict[str, int] = {}
    used: dict[str, int] = {}
    with suppress(OSError), os.scandir(_folder()) as entries:
        for entry in entries:
            if is_unfinished(entry.name):
                continue
            with suppress(FileNotFoundError):
                found, key = entry.stat(), entry.name.partition(".")[0]
                sizes[key] = sizes.get(key, 0) + found.st_size
                used[key] = max(used.get(key, 0), found.st_mtime_ns)
    total = sum(sizes.values())
    for key in sorted(used, key=used.__getitem__):
        if total <= most_bytes:
            return
        for file in reversed(_files(key)):
            with suppress(OSError):
                file.unlink()
        total -= sizes[key]


def _folder() -> Path:
    return cache_root() / "pictures"


def _files(key: str) -> tuple[Path, Path, Path]:
    """Picture, mask and note of a key."""
    stem = _folder() / key
    return stem.with_suffix(".png"), stem.with_suffix(".npz"), stem.with_suffix(".json")


def _digests(made: KeptPicture) -> list[str]:
    return [digest_bytes(made.picture), digest_bytes(made.mask), digest(made.visible)]
