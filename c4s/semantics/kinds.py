"""What is known of an asset, and which assets a name of the prompt stands for."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeAlias

from c4s.protocol.words import head, phrases_of, spoken, tokens

Facts: TypeAlias = Mapping[str, Any]
Phrase: TypeAlias = tuple[str, ...]


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
    def labels(self) -> list[Phrase]:
        """Its category and tags, each of which can name it alone."""
        return phrases_of([str(self._own.get("category") or ""), *map(str, self._own.get("tags") or [])])

    @cached_property
    def _texts(self) -> list[str]:
        facts = self.facts or {"name": leaf(self.asset) if self.named else ""}
        texts = [str(facts.get("name") or ""), str(facts.get("description") or ""), *map(str, facts.get("tags") or [])]
        return [spoken(tokens(text)) for text in texts]

    def says(self, phrase: Phrase) -> bool:
        """Whether the asset's own text (name, tags, description) holds the phrase as whole words in a row."""
        wanted = spoken(phrase)
        return not phrase or any(wanted in text for text in self._texts)


class KindIndex:
    """Kinds by the phrases that name them: the ends of their head noun phrase, their category, their tags."""

    def __init__(self, kinds: Iterable[ThingKind]) -> None:
        self._kinds = list(kinds)
        self._labels: dict[Phrase, list[int]] = {}
        for number, kind in enumerate(self._kinds):
            for label in kind.labels:
                self._labels.setdefault(label, []).append(number)
        self._ends: dict[int, dict[Phrase, list[int]]] = {}

    def find(self, phrases: Iterable[Phrase]) -> list[ThingKind]:
        """The kinds that any of the phrases names, in order: a ``table lamp`` is a lamp and no table."""
        found: set[int] = set()
        for phrase in phrases:
            if phrase:
                found.update(self._labels.get(phrase, ()))
                found.update(self._ending(len(phrase)).get(phrase, ()))
        return [self._kinds[number] for number in sorted(found)]

    def _ending(self, length: int) -> dict[Phrase, list[int]]:
        """Numbers of the kinds by the last ``length`` words of their noun."""
        if length not in self._ends:
            ends = self._ends[length] = {}
            for number, kind in enumerate(self._kinds):
                if len(kind.noun) >= length:
                    ends.setdefault(kind.noun[-length:], []).append(number)
        return self._ends[length]
