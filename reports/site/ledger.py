"""What a site was made of, kept beside its pages: so that the next build writes what changed and keeps the rest."""

from __future__ import annotations

from pathlib import Path
from typing import Final, Literal

from pydantic import Field

from c4s.errors import BadInput
from c4s.records.base import Record

LEDGER: Final = ".c4s-site.json"


class PageMade(Record):
    """A page as it was written."""

    made_of: str
    """Digest of what it was made of."""
    files: list[str]
    """What it shows besides: pictures and data, by their paths below the site."""


class SiteLedger(Record):
    """What lies in a site's folder."""

    schema_version: Literal["c4s.site.v1"] = "c4s.site.v1"
    made_of: str
    """Digest of all that decides the site: code, warehouse, secrets."""
    secrets: str
    """Digest of what the files were looked through for."""
    pages: dict[str, PageMade] = Field(default_factory=dict)
    """By path below the site."""


def ledger_of(site: Path) -> SiteLedger | None:
    """What an earlier build left; None where there is none, or one of another version."""
    try:
        return SiteLedger.read(site / LEDGER) if (site / LEDGER).is_file() else None
    except BadInput:
        return None
