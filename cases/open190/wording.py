"""Prompts with their requirements written into them: a sentence says once what it asks for and which things it means.

``[# striped market_stalls|*Stall|stalls]`` speaks of things (``cases.open190.prompts`` says which) and calls them
``stalls``. For ``#`` the number is put of how many stand in the place, for ``~`` a round one with a word like *about*.
Adjectives are requirements, but for one behind a ``'``; ``_`` joins words to one. ``{stalls along road; stalls row|they
line the road}`` says how things stand, and both may hold others of their kind. What is left when the marks are gone is
the prompt. Things of which nothing else is said are asked to be there. ``cases/DESIGN.md`` has all words of it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Final

from c4s.errors import BadInput
from c4s.protocol.words import tokens
from c4s.semantics.looks import MATERIAL_WORDS
from c4s.semantics.quantities import WORDS
from c4s.semantics.shades import shades_of
from cases.graphs.quotes import places
from cases.open190.numerals import numeral, rounded
from cases.requirements import EntitySpec, PredicateSpec, Quantity, RequirementSpec

NO_ADJECTIVES: Final = frozenset(WORDS) | {"the", "its", "their", "and", "of", "them", "or", "in"}
LAYOUTS: Final = {
    "row": "in_row",
    "rows": "in_rows",
    "grid": "in_grid",
    "ring": "in_ring",
    "scattered": "scattered",
    "regular": "regular",
}
"""Words of the notation for how like things lie, with their relation in a bundle."""
RELATIONS: Final = {"apart": "apart_from"}
"""Relations that the notation has a shorter word for."""
SURROUNDINGS: Final = ("lighting", "atmosphere", "condition")
WHOLES: Final = ("layout", "density", "style")
LOOKS: Final = ("color", "material", "attribute")
SCENE: Final = "scene"
ABOUT: Final = ("about", "some", "roughly")
"""Words before a rounded number, in turn."""
LONGEST_NAME: Final = 60
_MATERIALS: Final = frozenset().union(*MATERIAL_WORDS.values()) | {"tiled", "gravel"}


@dataclass(frozen=True)
class Meant:
    """The things that an entity of a prompt means: how many stand there, their names, whether one walks on them."""

    count: int
    names: tuple[str, ...]
    ground: bool


@dataclass
class Worded:
    """A prompt and its requirements; ``things`` says by entity which things its author means (nouns of the kits)."""

    text: str = ""
    entities: list[EntitySpec] = field(default_factory=list)
    predicates: list[PredicateSpec] = field(default_factory=list)
    things: dict[str, tuple[str, ...]] = field(default_factory=dict)

    @property
    def requirements(self) -> RequirementSpec:
        """As a case takes them."""
        return RequirementSpec(self.entities, self.predicates, "c4s open-190")


Span = tuple[int, int]


class _Reader:
    """Reads a marked prompt from left to right. Words and occurrences are put in when the prompt is whole."""

    def __init__(self, marked: str, meant: Callable[[Sequence[str]], Meant]) -> None:
        self._marked, self._meant = marked, meant
        self._place = 0
        self._text = ""
        self._predicates: list[tuple[Span, PredicateSpec]] = []
        self._entities: dict[str, tuple[Span, EntitySpec]] = {}
        self._things: dict[str, tuple[str, ...]] = {}
        self._guesses = len(marked)

    def read(self) -> Worded:
        """The whole prompt."""
        self._until("")
        entities, found = [], []
        for span, entity in self._entities.values():
            words, occurrence = self._quoted(span)
            entities.append(replace(entity, text=words, occurrence=occurrence))
        for span, spec in sorted(self._predicates, key=lambda row: row[0]):
            words, occurrence = self._quoted(span)
            found.append(replace(spec, text=words, occurrence=occurrence))
        told = {spec.subject for spec in found if spec.type != "existence"}
        kept = [spec for spec in found if spec.type != "existence" or spec.subject not in told]
        for spec in kept:
            for key in (spec.subject, spec.reference, *spec.references):
                if key is not None and key not in self._entities:
                    raise BadInput(f"{spec.name!r} speaks of {key!r}, which the prompt does not mark")
        return Worded(self._text, entities, kept, self._things)

    def _quoted(self, span: Span) -> tuple[str, int]:
        words = self._text[slice(*span)]
        starts = [quote.start for quote in places(self._text, words)]
        if span[0] not in starts:
            raise BadInput(f"{words!r} is cut out of a word")
        return words, starts.index(span[0])

    def _until(self, close: str) -> None:
        while self._place < len(self._marked):
            letter = self._marked[self._place]
            self._place += 1
            if letter == close:
                return
            if letter == "[":
                self._entity()
            elif letter == "{":
                self._claims()
            else:
                self._text += letter
        if close:
            raise BadInput(f"a {close!r} is missing in {self._marked[:60]!r}")

    def _upto(self, close: str) -> str:
        end = self._marked.find(close, self._place)
        if end < 0:
            raise BadInput(f"a {close!r} is missing behind {self._marked[self._place :][:40]!r}")
        found, self._place = self._marked[self._place : end], end + 1
        return found

    def _claims(self) -> None:
        claims = [_spaced(part.split()) for part in self._upto("|").split(";")]
        start = len(self._text)
        self._until("}")
        span, words = (start, len(self._text)), self._text[start:]
        for claim in claims:
            if claim == ["id"]:
                self._entities[SCENE] = span, EntitySpec(SCENE, "", entity_type="region")
            self._predicates.append((span, _claimed(claim, words)))

    def _entity(self) -> None:
        marks = self._upto("]")
        if not re.fullmatch(r"[^|]*[^|\s][^|]*\|[^|]+(\|[^|]+)?", marks):
            raise BadInput(f"{marks!r} is no [words|things] or [words|things|name]")
        phrase, things, *named = marks.split("|")
        nouns, words = tuple(things.split("+")), phrase.split()
        (key,) = _spaced(named or [words[-1].removeprefix("'").lower()])
        meant = self._meant(nouns)
        if not meant.count:
            raise BadInput(f"no {things} stands in the place")
        if key in self._entities:
            raise BadInput(f"{key!r} is marked twice")
        start = len(self._text)
        quantity, adjectives = self._phrase(words, meant)
        span = start, len(self._text)
        many = quantity is not None or re.search(r"[^s]s$", words[-1]) is not None or meant.ground
        aliases = tuple(dict.fromkeys(meant.names))
        self._things[key] = nouns
        self._entities[key] = span, EntitySpec(key, "", aliases, "surface" if meant.ground else "object", many)
        amount = (
            PredicateSpec("existence", key, "", key)
            if quantity is None
            else PredicateSpec("quantity", f"count of {key}", "", key, quantity=quantity)
        )
        self._predicates += [(span, spec) for spec in (amount, *_looks(key, adjectives))]

    def _phrase(self, words: Sequence[str], meant: Meant) -> tuple[Quantity | None, list[str]]:
        """Write a phrase; returns its quantity and the adjectives that it asks for."""
        quantity: Quantity | None = None
        adjectives: list[str] = []
        shown: list[str] = []
        for number, word in enumerate(words):
            if word in ("#", "~"):
                count = meant.count if word == "#" else rounded(meant.count)
                exact = count == meant.count
                quantity, adjectives = Quantity("exact" if exact else "approximately", count), []
                shown.append(numeral(count) if exact else f"{self._about()} {numeral(count)}")
                continue
            plain = word.strip(",").lower()
            if number < len(words) - 1 and not word.startswith("'") and plain not in NO_ADJECTIVES:
                adjectives.append(plain)
            shown.append(word.removeprefix("'").replace("_", " "))
        phrase = " ".join(shown)
        if re.search(r"(^|[.!?]\s|\n)$", self._text):
            phrase = phrase[0].upper() + phrase[1:]
        self._text += phrase
        return quantity, adjectives

    def _about(self) -> str:
        self._guesses += 1
        return ABOUT[self._guesses % len(ABOUT)]


def _claimed(claim: Sequence[str], words: str) -> PredicateSpec:
    """What a claim before some words asks for: ``id``, a word for the whole, or a thing, how, and to what."""
    subject, *rest = claim or [""]
    if subject == "id":
        return PredicateSpec("scene_identity", f"it is {words}", "", SCENE)
    if subject in (*SURROUNDINGS, *WHOLES):
        name = f"{subject}: {words}"[:LONGEST_NAME]
        kind = (subject, words)
        if subject in WHOLES:
            return PredicateSpec("composition", name, "", SCENE, qualifiers=(kind,))
        return PredicateSpec("environment", name, "", SCENE, qualifiers=(kind,))
    if not rest:
        raise BadInput(f"{subject!r} before {words!r} says nothing")
    how, *references = rest
    if how in LAYOUTS:
        return PredicateSpec("distribution", f"{subject} {LAYOUTS[how]}", "", subject, relation=LAYOUTS[how])
    if how in LOOKS:
        told = [words] if how == "attribute" else [word for word in tokens(words) if _kind_of(word) == how]
        return _looking(subject, how, told)
    if not references:
        raise BadInput(f"{' '.join(claim)!r} before {words!r} names no reference")
    name = f"{subject} {how} {' '.join(references)}"
    first, *more = references
    return PredicateSpec("spatial_relation", name, "", subject, first, RELATIONS.get(how, how), references=tuple(more))


def _looks(subject: str, adjectives: Sequence[str]) -> list[PredicateSpec]:
    """One requirement for the colours of a thing, one for its materials, one for each other adjective."""
    by_kind: dict[tuple[str, str], list[str]] = {}
    for word in adjectives:
        kind = _kind_of(word)
        by_kind.setdefault((kind, word if kind == "attribute" else ""), []).append(word)
    return [_looking(subject, kind, told) for (kind, _), told in by_kind.items()]


def _looking(subject: str, kind: str, told: Sequence[str]) -> PredicateSpec:
    name = f"{subject} {' '.join(told)}"[:LONGEST_NAME]
    qualifiers = tuple((kind, word) for word in told)
    if kind == "material":
        return PredicateSpec("material", name, "", subject, qualifiers=qualifiers)
    return PredicateSpec("attribute", name, "", subject, qualifiers=qualifiers)


def _spaced(written: Sequence[str]) -> list[str]:
    return [word.replace("_", " ") for word in written]


def _kind_of(word: str) -> str:
    if shades_of(word) is not None:
        return "color"
    return "material" if word in _MATERIALS else "attribute"


def worded(marked: str, meant: Callable[[Sequence[str]], Meant]) -> Worded:
    """Read a marked prompt; ``meant`` says what nouns of the kits mean in a place. ``BadInput`` where it is wrong."""
    paragraphs = [" ".join(part.split()) for part in re.split(r"\n\s*\n", marked.strip())]
    return _Reader("\n\n".join(paragraphs), meant).read()
