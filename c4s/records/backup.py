"""The manifest of a backup: which files it holds, with their digests."""

from __future__ import annotations

from typing import ClassVar, Literal

from pydantic import Field

from c4s.names import InnerPath
from c4s.records.base import Record, Sealed


class KeptFile(Record):
    """A file of the home."""

    path: InnerPath
    """Below ``C4S_HOME``."""
    size: int
    digest: str = Field(pattern="^[0-9a-f]{64}$")
    """SHA-256 of its bytes, under which they are kept."""


class Backup(Sealed):
    """What a backup holds. It is replaced last: a folder without it is a first backup that was cut off."""

    REMEDY: ClassVar[str] = "run `c4s backup` to this folder again"
    schema_version: Literal["c4s.backup.v2"] = "c4s.backup.v2"
    made: str
    """When: UTC, ISO 8601."""
    parts: list[str]
    """Folders of the home: ``runs``, ``suites``, ``warehouse``, ``packs``, ``human``."""
    left_out: list[str]
    """Runs that somebody worked on. Their files are those of the backup before, where it had them."""
    files: list[KeptFile]
