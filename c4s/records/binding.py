"""The binding of a case: which assets of its catalog each entity of its prompt names, frozen when its suite is built.

``withheld/<case>/binding.json``, and ``withheld/<case>/bindings.reviewed.json`` where the case's author reviewed it.
"""

from __future__ import annotations

from typing import ClassVar, Literal

from pydantic import Field

from c4s.records.base import Record, Sealed


class Proposal(Record):
    """An asset that could be meant, and why. It is no evidence of identity."""

    asset: str
    why: str


class BoundEntity(Record):
    """What an entity of the prompt is bound to."""

    assets: list[str] = Field(default_factory=list)
    """Paths of the assets that are such a thing by the head noun of their name, in the catalog's order."""
    proposed: list[Proposal] = Field(default_factory=list)
    """Assets that only a tag, a category, a description or a related word speaks for."""


class ReviewedEntity(Record):
    """What a case's author says of one entity."""

    names: list[str] = Field(default_factory=list)
    """Further names of it, which count as its aliases do."""
    add: list[str] = Field(default_factory=list)
    """Paths of assets that are such a thing, whatever they are called."""
    strike: list[str] = Field(default_factory=list)
    """Paths of assets that are none, whatever they are called."""


class ReviewedBindings(Record):
    """Bindings that a case's author reviewed, by entity id."""

    schema_version: Literal["c4s.reviewed-bindings.v1"] = "c4s.reviewed-bindings.v1"
    entities: dict[str, ReviewedEntity]


class Binding(Sealed):
    """The entities of one requirement bundle, bound to the assets of one catalog."""

    REMEDY: ClassVar[str] = "restore the file, or build the suite again with --replace"
    schema_version: Literal["c4s.binding.v1"] = "c4s.binding.v1"
    bundle_sha256: str
    """SHA-256 of the canonical JSON of the bundle's graph."""
    catalog_sha256: str
    """SHA-256 of what the catalog's assets are called: name, category, tags and description of each path."""
    reviewed_sha256: str | None = None
    """SHA-256 of the author's reviewed bindings; null where there are none."""
    entities: dict[str, BoundEntity]
    """By entity id."""
