"""Which assets of a catalog the entities of a prompt name (paper, Evidence ladder: identity bindings).

A head noun names. Tags, categories, descriptions and related words only propose: twenty pen cups are no oak desks,
though their tag says ``desk``. A name of the prompt counts with and without the words that describe it, the described
asset first: ``low table`` is the low table of the catalog where it has one, else any table that is not named otherwise.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from functools import cached_property
from typing import Any

from c4s.errors import BadInput
from c4s.files import digest
from c4s.protocol.bundle import Entity, Requirements
from c4s.protocol.words import spoken
from c4s.records.binding import Binding, BoundEntity, Proposal, ReviewedBindings, ReviewedEntity
from c4s.semantics import lexicon
from c4s.semantics.kinds import Facts
from c4s.semantics.looks import GENERIC, MATERIAL_WORDS
from c4s.semantics.naming import Kind, Named, Phrase, joined, kinds_of, plain_words, read_name, words_of

READ = ("name", "category", "tags", "description")
"""What is read of an asset."""


class _Asset:
    """One asset of the catalog, as its name and its texts are compared."""

    def __init__(self, path: str, facts: Facts, siblings: Collection[str]) -> None:
        self.path = path
        self.name = str(facts.get("name") or "")
        self._tags = [str(tag) for tag in facts.get("tags") or []]
        self._description = str(facts.get("description") or "")
        self._category = str(facts.get("category") or "")
        self.named: Named = read_name(self.name, self._category, self._description, siblings)

    @cached_property
    def labels(self) -> dict[str, str]:
        """Its tags and its category as ``joined`` words, each with what it is."""
        found = {joined(words_of(self._category)): "its category"}
        return found | {joined(words_of(tag)): "its tag" for tag in self._tags}

    @cached_property
    def told(self) -> str:
        """Its description, spoken."""
        return spoken(words_of(self._description))

    @cached_property
    def words(self) -> frozenset[str]:
        """Every word of its name, tags and description."""
        return frozenset(words_of(" ".join((self.name, *self._tags, self._description))))

    @cached_property
    def in_doubt(self) -> bool:
        """Whether neither its tags nor its description repeat the head of its name, though it has both."""
        if not self._tags or not self._description:
            return False
        told = words_of(" ".join((*self._tags, self._description, self._category)))
        return not any(word.endswith(self.named.noun[-1]) for word in told)


def catalog_sha256(catalog: Mapping[str, Facts]) -> str:
    """SHA-256 of what the assets of a catalog are called."""
    return digest({path: [facts.get(field) for field in READ] for path, facts in catalog.items()})


def bundle_sha256(requirements: Requirements) -> str:
    """SHA-256 of a bundle's graph. ``BadInput`` where it holds what JSON cannot."""
    try:
        return digest(dict(requirements.graph))
    except ValueError as error:
        raise BadInput(f"this requirement bundle cannot be read: {error}") from None


def bind(requirements: Requirements, catalog: Mapping[str, Facts], reviewed: ReviewedBindings | None = None) -> Binding:
    """Bind every entity of a bundle to the assets that it names; the same input gives the same binding.

    Args:
        requirements: the bundle.
        catalog: asset path to ``{"name", "category", "tags", "description"}``.
        reviewed: what the case's author added and struck.

    Raises ``BadInput`` where the review names an entity or an asset that is not there.
    """
    review = reviewed.entities if reviewed is not None else {}
    _check_review(review, requirements, catalog)
    index = _Index(catalog)
    entities = requirements.entities
    bound = {
        identity: index.bound(entity, _names(entity, entities), review.get(identity, ReviewedEntity()))
        for identity, entity in entities.items()
    }
    return Binding(
        bundle_sha256=bundle_sha256(requirements),
        catalog_sha256=catalog_sha256(catalog),
        reviewed_sha256=reviewed.sha256() if reviewed is not None else None,
        entities=bound,
    )


def binding_of(
    requirements: Requirements, catalog: Mapping[str, Facts], frozen: Any = None, *, where: str = ""
) -> Binding:
    """The frozen binding of a case, given as plain data and checked; one made on the spot where none was frozen."""
    if frozen is None:
        return bind(requirements, catalog)
    found = Binding.opened(frozen, where=where)
    check_binding(found, requirements, catalog, where=where)
    return found


def check_binding(binding: Binding, requirements: Requirements, catalog: Mapping[str, Facts], *, where: str) -> None:
    """``BadInput`` for a frozen binding that was made of another bundle or another catalog."""
    for what, frozen, here in (
        ("requirement bundle", binding.bundle_sha256, bundle_sha256(requirements)),
        ("catalog", binding.catalog_sha256, catalog_sha256(catalog)),
    ):
        if frozen != here:
            raise BadInput(f"this binding was made of another {what}", where=where, todo=Binding.REMEDY)


def _names(entity: Entity, entities: Mapping[str, Entity]) -> list[str]:
    """The names of an entity, and of what an or-list is made of."""
    members = [entities[member] for member in entity.members if member in entities]
    return [name for one in (entity, *members) for name in one.names]


def _check_review(
    review: Mapping[str, ReviewedEntity], requirements: Requirements, catalog: Mapping[str, Facts]
) -> None:
    for identity, entity in review.items():
        if identity not in requirements.entities:
            raise BadInput(f"the reviewed bindings name an unknown entity {identity!r}")
        for path in (*entity.add, *entity.strike):
            if path not in catalog:
                raise BadInput(f"the reviewed bindings name an asset that the catalog does not hold: {path}")


class _Index:
    """The assets of a catalog, by the words that could name or propose them."""

    def __init__(self, catalog: Mapping[str, Facts]) -> None:
        called = [
            plain_words(str(facts.get("name") or ""), str(facts.get("category") or "")) for facts in catalog.values()
        ]
        siblings = {joined(words) for words in called}
        self.assets = [_Asset(path, facts, siblings) for path, facts in catalog.items()]
        self._ends: dict[str, list[int]] = {}
        self._heads: dict[str, list[int]] = {}
        self._contents: dict[str, list[int]] = {}
        self._labels: dict[str, list[int]] = {}
        self._told: dict[str, list[int]] = {}
        self._openings: dict[str, list[int]] = {}
        self._spelled: dict[str, list[int]] = {}
        for number, asset in enumerate(self.assets):
            named = asset.named
            for ends, words in ((self._ends, named.noun), (self._contents, named.content)):
                for start in range(len(words)):
                    ends.setdefault(joined(words[start:]), []).append(number)
            if joined(named.whole) != joined(named.noun):
                self._ends.setdefault(joined(named.whole), []).append(number)
            for stop in range(1, len(named.noun)):
                self._openings.setdefault(joined(named.noun[:stop]), []).append(number)
            if named.earlier:
                self._openings.setdefault(named.earlier[-1], []).append(number)
            head = named.noun[-1] if named.noun else ""
            self._heads.setdefault(head, []).append(number)
            for label in asset.labels:
                self._labels.setdefault(label, []).append(number)
            for word in set(asset.told.split()):
                self._told.setdefault(word, []).append(number)
            for spelling in _misspelled(head):
                self._spelled.setdefault(spelling, []).append(number)

    def bound(self, entity: Entity, called: Iterable[str], review: ReviewedEntity) -> BoundEntity:
        """The assets that an entity names, and those that something else proposes."""
        names: dict[int, None] = {}
        proposals: dict[int, str] = {}
        kinds = kinds_of((*called, *review.names))
        for kind in kinds:
            names.update(dict.fromkeys(self._naming(kind, entity, proposals)))
        for kind in kinds:
            self._propose(kind, entity, proposals)
        struck = set(review.strike)
        added = set(review.add)
        chosen = [
            asset.path
            for number, asset in enumerate(self.assets)
            if asset.path in added or (number in names and asset.path not in struck)
        ]
        is_chosen = set(chosen)
        return BoundEntity(
            assets=chosen,
            proposed=[
                Proposal(asset=asset.path, why=proposals[number])
                for number, asset in enumerate(self.assets)
                if number in proposals and asset.path not in is_chosen and asset.path not in struck
            ],
        )

    def _naming(self, kind: Kind, entity: Entity, proposals: dict[int, str]) -> list[int]:
        """Assets that are of a kind by their head noun; those that are so in part are proposed instead."""
        wanted = joined(kind.noun)
        found = []
        for number in self._ends.get(wanted, ()):
            asset = self.assets[number]
            if doubt := _doubt(asset, kind):
                proposals.setdefault(number, doubt)
            else:
                found.append(number)
        if entity.kind in ("surface", "region"):
            found += [number for number in self._contents.get(wanted, ()) if self.assets[number].named.form]
        said = [number for number in found if _says_all(self.assets[number], kind.described)]
        if kind.described and said:
            for number in set(found) - set(said):
                proposals.setdefault(number, f"a {kind.noun[-1]}, and another is {' '.join(kind.described)}")
            return said
        for number in found:
            if other := _contradicted(self.assets[number], kind.described):
                proposals.setdefault(number, f"its name says {other}")
        return [number for number in found if number not in proposals]

    def _propose(self, kind: Kind, entity: Entity, proposals: dict[int, str]) -> None:
        head, wanted = kind.noun[-1], joined(kind.noun)

        def add(numbers: Iterable[int], why: str) -> None:
            for number in numbers:
                proposals.setdefault(number, why)

        plain = head not in lexicon.FORMS | lexicon.COLLECTIVES
        if plain:
            add(self._heads.get(head, ()), f"another kind of {head}")
        if len(kind.noun) > 1:
            add(self._ends.get(joined(kind.noun[:-1]), ()), "it is named shorter")
        for number in self._contents.get(wanted, ()):
            proposals.setdefault(number, f"a {self.assets[number].named.noun[-1]} of it")
        for label in (wanted, head) if plain else (wanted,):
            for number in self._labels.get(label, ()):
                proposals.setdefault(number, f"{self.assets[number].labels[label]} says {label}")
        phrase = spoken(kind.noun)
        add((n for n in self._told.get(head, ()) if phrase in self.assets[n].told), "its description says it")
        for group in lexicon.RELATED:
            if head in group:
                for word in sorted(group - {head}):
                    add(self._heads.get(word, ()), f"{word} is related")
        if entity.is_object:
            add(self._openings.get(wanted, ()), "its name opens with it")
        add(self._spelled.get(head, ()), "spelled alike")
        for spelling in _misspelled(head):
            add(self._heads.get(spelling, ()), "spelled alike")


def _misspelled(word: str) -> set[str]:
    """What is left of a long word without one letter that is not its first; none for a short one."""
    if len(word) < 6:
        return set()
    return {word[:place] + word[place + 1 :] for place in range(1, len(word))}


def _doubt(asset: _Asset, kind: Kind) -> str:
    """Why an asset whose name ends like the kind's is none of it; empty where it is."""
    noun = asset.named.noun
    if joined(kind.noun) in (joined(noun), joined(asset.named.whole)):
        return ""
    odd = next((word for word in noun[:-1] if word in lexicon.PRIVATIVE and word not in kind.noun), "")
    if odd:
        return f"a {odd} {noun[-1]}"
    if len(kind.noun) == 1 and noun[-2:] in lexicon.ODD_COMPOUNDS:
        return f"a {' '.join(noun[-2:])} is called so"
    return "its tags and its description do not say so" if asset.in_doubt else ""


def _says_all(asset: _Asset, described: Phrase) -> bool:
    return all(_says(asset.words, word) for word in described)


def _says(words: frozenset[str], wanted: str) -> bool:
    if wanted in words:
        return True
    return any(wanted in names & GENERIC and words & names for names in MATERIAL_WORDS.values())


def _contradicted(asset: _Asset, described: Phrase) -> str:
    """A colour or material in an asset's name that is none of those described; empty where there is none."""
    own = words_of(asset.name)
    for sort in (lexicon.COLOR_WORDS - lexicon.MATERIALS, lexicon.MATERIALS):
        asked = {word for word in described if word in sort}
        told = [word for word in own[:-1] if word in sort]
        if asked and told and not any(_says(frozenset(told), word) for word in asked):
            return told[0]
    return ""
