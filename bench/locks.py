"""The two locks as tables: ``requirements.lock`` is the whole, ``requirements-run.lock`` what runs c4s."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Final

ROOT: Final = Path(__file__).resolve().parents[1]
WHOLE: Final = "requirements.lock"
RUN: Final = "requirements-run.lock"
_ENTRY: Final = re.compile(
    r"^([\w.-]+)(?:\[[\w, -]+\])?==(\S+)(?: ; ([^\n]+?))?((?: \\\n    --hash=sha256:[0-9a-f]{64})+)$", re.MULTILINE
)
"""A package with its version, its marker and its hashes."""


@dataclass(frozen=True)
class Locked:
    """A version of a package: where it is installed (a marker, empty: everywhere), and the digests of its files."""

    name: str
    version: str
    marker: str
    hashes: tuple[str, ...]


def normal(name: str) -> str:
    """A package's name as it is compared."""
    return re.sub(r"[-_.]+", "-", name).lower()


def locked(name: str) -> list[Locked]:
    """The rows of a lock. ``ValueError`` where a line is of another kind."""
    text = (ROOT / name).read_text()
    if left := _ENTRY.sub("", text).strip():
        raise ValueError(f"{name}: {left.splitlines()[0]!r} is no locked package")
    return [
        Locked(normal(package), version, marker, tuple(re.findall(r"[0-9a-f]{64}", hashes)))
        for package, version, marker, hashes in _ENTRY.findall(text)
    ]
