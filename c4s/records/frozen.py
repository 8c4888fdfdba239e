"""What a suite was frozen on: who found each case solvable and clear, and under which licences its content lies."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from c4s.names import Name
from c4s.records.base import Record, Sealed
from c4s.records.pack import AIUse


class FrozenPack(Record):
    """A pack of the suite."""

    pack_id: Name
    license: str
    ai_use: AIUse


class FrozenReview(Record):
    """Who said yes of a case, by pseudonym: none of them made it."""

    author: Name | None = None
    solvable: list[Name] = Field(default_factory=list)
    """Everything can be told from the references, or built from the palette."""
    prompt: list[Name] = Field(default_factory=list)
    """The prompt is clear and without contradiction."""


class Frozen(Sealed):
    """A suite that was reviewed and may be released."""

    schema_version: Literal["c4s.frozen.v1"] = "c4s.frozen.v1"
    suite: Name
    suite_digest: str
    packs: list[FrozenPack]
    cases: dict[Name, FrozenReview]
