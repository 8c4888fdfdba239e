"""Prompts with their requirements written into them: a sentence says once what it asks for and which things it means.

``[# striped market_stalls|*Stall]`` speaks of things: here all whose noun ends in ``Stall``, of which as many stand in
the place as the number says that is put for ``#`` (``~``: about as many, rounded). Its adjectives are requirements; one
behind a ``'`` is not. ``{stalls along road; stalls row|line the road}`` says how they stand. Both may be nested; what is
left when the marks are gone is the prompt. ``cases/DESIGN.md`` has the whole notation.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Final

from c4s.errors import BadInput
from c4s.protocol.words import tokens
from c4s.semantics.looks import MATERIAL_WORDS
from c4s.semantics.quantities import WORDS
from c4s.semantics.shades import shades_of
from cases.graphs.quotes import places
from cases.open190.numerals import numeral, rounded
from cases.requirements import EntitySpec, PredicateSpec, Quantity, RequirementSpec

DETERMINERS: Final = frozenset(
    {"a", "an", "the", "its", "their", "this", "another", "and", "of", "them", "or", "in", "all"}
)
VAGUE: Final = frozenset({"several", "few", "many", "dozens", "some", "numerous"})
LAYOUTS: Final = {
    "row": "in_row", "rows": "in_rows", "grid": "in_grid", "ring": "in_ring", "cluster": "clustered",
    "scattered": "scattered", "regular": "regular",
}  # fmt: skip
"""Words of the notation for how like things lie, with their relation in a bundle."""
RELATIONS: Final = {
    "apart": "apart_from",
    "north": "north_of",
    "south": "south_of",
    "east": "east_of",
    "west": "west_of",
}
"""Relations that the notation has a shorter word for."""
SURROUNDINGS: Final = ("lighting", "atmosphere", "condition")
WHOLES: Final = ("layout", "density", "style")
SCENE: Final = "scene"
_MATERIALS: Final = frozenset().union(*MATERIAL_WORDS.values()) | {"thatched", "tiled", "gravel", "plastered", "straw"}


@dataclass(frozen=True)
class Meant:
    """The things that an entity of a prompt means: how many stand there, what they are called, whether one walks on them."""

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


@dataclass
class _Said:
    """A predicate before the prompt is whole: its span instead of its words."""

    start: int
    end: int
    make: Callable[[str, int], PredicateSpec]


class _Reader:
    """Reads a marked prompt from left to right."""

    def __init__(self, marked: str, meant: Callable[[Sequence[str]], Meant]) -> None:
        self._marked, self._meant = marked, meant
        self._place = 0
        self._text = ""
        self._said: list[_Said] = []
        self._spans: dict[str, tuple[int, int]] = {}
        self._made: dict[str, Callable[[str, int], EntitySpec]] = {}
        self._things: dict[str, tuple[str, ...]] = {}

    def read(self) -> Worded:
        """The whole prompt."""
        self._until("")
        done = Worded(text=self._text, things=self._things)
        for key, make in self._made.items():
            done.entities.append(make(*self._quoted(*self._spans[key])))
        for said in sorted(self._said, key=lambda one: (one.start, one.end)):
            done.predicates.append(said.make(*self._quoted(said.start, said.end)))
        for predicate in done.predicates:
            for key in (predicate.subject, predicate.reference, *predicate.references):
                if key is not None and key not in self._made:
                    raise BadInput(f"{predicate.name!r} speaks of {key!r}, which the prompt does not mark")
        return done

    def _quoted(self, start: int, end: int) -> tuple[str, int]:
        words = self._text[start:end]
        starts = [quote.start for quote in places(self._text, words)]
        if start not in starts:
            raise BadInput(f"{words!r} is cut out of a word")
        return words, starts.index(start)

    def _until(self, close: str) -> None:
        while self._place < len(self._marked):
            letter = self._marked[self._place]
            self._place += 1
            if letter == close:
                return
            if letter == "[":
                self._entity()
            elif letter == "{":
                self._relation()
            else:
                self._text += letter
        if close:
            raise BadInput(f"a {close!r} is missing in {self._marked[:60]!r}")

    def _relation(self) -> None:
        bar = self._marked.find("|", self._place)
        specs = [part.split() for part in self._marked[self._place : bar].split(";")]
        self._place = bar + 1
        start = len(self._text)
        self._until("}")
        words = self._text[start:]
        for spec in specs:
            self._said.append(_Said(start, len(self._text), self._claim([_key(one) for one in spec], words, start)))

    def _claim(self, spec: Sequence[str], words: str, start: int) -> Callable[[str, int], PredicateSpec]:
        kind, *rest = spec
        if kind == "id":
            self._spans[SCENE] = start, len(self._text)
            self._made[SCENE] = lambda text, at: EntitySpec(SCENE, text, (), "region", occurrence=at)
            return lambda text, at: PredicateSpec("scene_identity", f"it is {text}", text, SCENE, occurrence=at)
        if kind in SURROUNDINGS or kind in WHOLES:
            type_ = "environment" if kind in SURROUNDINGS else "composition"
            return lambda text, at: PredicateSpec(
                type_, f"{kind}: {text}"[:60], text, SCENE, qualifiers=((kind, text),), occurrence=at
            )
        if not rest:
            raise BadInput(f"{' '.join(spec)!r} before {words!r} says nothing")
        relation, *references = rest
        relation = RELATIONS.get(relation, relation)
        if relation in LAYOUTS:
            return lambda text, at: PredicateSpec(
                "distribution", f"{kind} {LAYOUTS[relation]}", text, kind, relation=LAYOUTS[relation], occurrence=at
            )
        if relation in ("color", "material", "attribute"):
            told = [one for one in tokens(words) if _kind_of(one) == relation] if relation != "attribute" else [words]
            return lambda text, at: PredicateSpec(
                "material" if relation == "material" else "attribute",
                f"{kind} {relation} {' '.join(told)}"[:60],
                text,
                kind,
                qualifiers=tuple((relation, one) for one in told),
                occurrence=at,
            )
        if not references:
            raise BadInput(f"{' '.join(spec)!r} before {words!r} names no reference")
        return lambda text, at: PredicateSpec(
            "spatial_relation",
            f"{kind} {relation} {' '.join(references)}",
            text,
            kind,
            references[0],
            relation,
            occurrence=at,
            references=tuple(references[1:]),
        )

    def _entity(self) -> None:
        close = self._marked.find("]", self._place)
        phrase, things, *named = self._marked[self._place : close].split("|")
        self._place = close + 1
        nouns = tuple(things.split("+")) if things != "@" else ()
        words = phrase.split()
        key = _key(named[0] if named else words[-1].removeprefix("'").lower())
        meant = self._meant(nouns) if nouns else Meant(0, (), False)
        if nouns and not meant.count:
            raise BadInput(f"no {things} stands in the place")
        if key in self._made:
            raise BadInput(f"{key!r} is marked twice")
        start = len(self._text)
        quantity, adjectives = self._phrase(words, meant)
        span = start, len(self._text)
        many = quantity is not None or re.search(r"[^s]s$", words[-1]) is not None or meant.ground
        self._spans[key], self._things[key] = span, nouns
        kind = "region" if not nouns else "surface" if meant.ground else "object"
        aliases = tuple(dict.fromkeys(meant.names))
        self._made[key] = lambda text, at: EntitySpec(key, text, aliases, kind, many, at)
        if not nouns:
            return
        if quantity is None:
            self._said.append(_Said(*span, lambda text, at: PredicateSpec("existence", key, text, key, occurrence=at)))
        else:
            self._said.append(
                _Said(
                    *span,
                    lambda text, at: PredicateSpec(
                        "quantity", f"count of {key}", text, key, quantity=quantity, occurrence=at
                    ),
                )
            )
        self._looks(key, adjectives, span)

    def _looks(self, key: str, adjectives: Sequence[str], span: tuple[int, int]) -> None:
        by_kind: dict[tuple[str, str], list[str]] = {}
        for word in adjectives:
            kind = _kind_of(word)
            by_kind.setdefault((kind, word if kind == "attribute" else ""), []).append(word)
        for (kind, _), told in by_kind.items():
            made = PredicateSpec(
                "material" if kind == "material" else "attribute",
                f"{key} {' '.join(told)}",
                "",
                key,
                qualifiers=tuple((kind, one) for one in told),
            )
            self._said.append(_Said(*span, lambda text, at, made=made: _worded(made, text, at)))  # type: ignore[misc]

    def _phrase(self, words: Sequence[str], meant: Meant) -> tuple[Quantity | None, list[str]]:
        """Write a phrase; returns its quantity and the adjectives that it asks for."""
        quantity: Quantity | None = None
        adjectives: list[str] = []
        shown: list[str] = []
        for number, word in enumerate(words):
            if word in ("#", "~"):
                count = meant.count if word == "#" else rounded(meant.count)
                quantity = Quantity("exact" if word == "#" else "approximately", count)
                adjectives = []
                word = numeral(count)
            elif word.lower() in VAGUE:
                quantity = Quantity("qualitative", qualitative=word.lower())
            elif number < len(words) - 1:
                plain = word.strip(",").lower()
                if not word.startswith("'") and plain not in DETERMINERS and plain not in WORDS:
                    adjectives.append(plain)
            shown.append(word.removeprefix("'").replace("_", " "))
        phrase = " ".join(shown)
        if not self._text or re.search(r"[.!?:]\s$", self._text) or self._text.endswith("\n\n"):
            phrase = phrase[0].upper() + phrase[1:]
        self._text += phrase
        return quantity, adjectives


def _worded(made: PredicateSpec, text: str, occurrence: int) -> PredicateSpec:
    return PredicateSpec(made.type, made.name, text, made.subject, qualifiers=made.qualifiers, occurrence=occurrence)


def _key(written: str) -> str:
    return written.replace("_", " ")


def _kind_of(word: str) -> str:
    if shades_of(word) is not None:
        return "color"
    return "material" if word in _MATERIALS else "attribute"


def worded(marked: str, meant: Callable[[Sequence[str]], Meant]) -> Worded:
    """Read a marked prompt; ``meant`` says what nouns of the kits mean in a place. ``BadInput`` where it is wrong."""
    paragraphs = [" ".join(part.split()) for part in re.split(r"\n\s*\n", marked.strip())]
    return _Reader("\n\n".join(paragraphs), meant).read()
