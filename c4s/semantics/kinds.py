"""What is known of an asset."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Final, TypeAlias

from c4s.protocol.words import CUTS, head, spoken, tokens

Facts: TypeAlias = Mapping[str, Any]
Phrase: TypeAlias = tuple[str, ...]
_OF_PARTS: Final = CUTS - {"and"}
"""A description tells of the whole thing before the first of these, or of a comma."""


def leaf(path: str) -> str:
    """The last part of an asset path, without the class suffix ``_C``."""
    name = path.rstrip("'").rsplit("/", 1)[-1].rsplit(".", 1)[-1]
    return name.removesuffix("_C")


@dataclass(frozen=True, eq=False)
class ThingKind:
    """One asset."""

    asset: str
    facts: Facts | None
    """Catalog facts; None for an asset that the catalog does not hold."""
    named: bool = True
    """Whether the name of an asset without facts can be trusted."""

    @property
    def basic_shape(self) -> bool:
        """Whether it is an engine primitive, which could stand for anything."""
        return self.asset.lower().startswith("/engine/basicshapes/")

    @cached_property
    def _own(self) -> Facts:
        return self.facts if self.facts is not None else {}

    @cached_property
    def noun(self) -> Phrase:
        """The head noun phrase of its name; empty where the name is not to be trusted."""
        if self.facts is None and not self.named:
            return ()
        return head(str(self._own.get("name") or leaf(self.asset)))

    @cached_property
    def _texts(self) -> list[str]:
        facts = self.facts or {"name": leaf(self.asset) if self.named else ""}
        texts = [str(facts.get("name") or ""), str(facts.get("description") or ""), *map(str, facts.get("tags") or [])]
        return [spoken(tokens(text)) for text in texts]

    @cached_property
    def _whole(self) -> list[str]:
        facts = self.facts or {}
        words = tokens(re.split(r"[,.;:(]", str(facts.get("description") or ""), maxsplit=1)[0])
        end = next((place for place, word in enumerate(words) if word in _OF_PARTS), len(words))
        name, _, *tags = self._texts
        return [name, spoken(words[:end]), *tags]

    def says_of_all(self, phrase: Phrase) -> bool:
        """As ``says``, but of the whole thing: not what its description tells of a part (``a kettle with a black
        handle``)."""
        wanted = spoken(phrase)
        return not phrase or any(wanted in text for text in self._whole)

    def says(self, phrase: Phrase) -> bool:
        """Whether the asset's own text (name, tags, description) holds the phrase as whole words in a row."""
        wanted = spoken(phrase)
        return not phrase or any(wanted in text for text in self._texts)
