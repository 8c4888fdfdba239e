"""What a name says: the head noun of an asset's name, and the kinds of thing that an entity's names ask for.

Both are read by English word order: the head comes last (``Table Lamp`` is a lamp), ``Barrel of apples`` is an apple
barrel, and words that describe are no part of the kind. Names of assets also have what packs write behind a noun:
numbers, letters, sizes, materials (``Window Wood 01a``).
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from dataclasses import dataclass
from typing import TypeAlias

from c4s.protocol.words import CUTS, PREFIXES, tokens
from c4s.semantics import lexicon
from c4s.semantics.looks import COLORS

Phrase: TypeAlias = tuple[str, ...]
_LIST = re.compile(r"\s+(?:or|and)\s+|\s*[/;]\s*")
_BEHIND = CUTS | {
    "between", "near", "by", "from", "under", "over", "behind", "beside", "around", "along", "against", "to",
    "that", "which", "where", "without", "inside", "outside", "above", "below", "through",
}  # fmt: skip
"""In prose a noun phrase ends before the first of these."""


def joined(words: Iterable[str]) -> str:
    """Words without blanks, as they are compared: ``street light`` is ``streetlight``."""
    return "".join(words)


def words_of(text: str) -> Phrase:
    """The ``tokens`` of a text, each word for one and the same thing as the same word."""
    return tuple(lexicon.SAME.get(word, word) for word in tokens(text))


def _mark(word: str) -> bool:
    """Whether a word only numbers a variant: ``01``, ``b``."""
    return word.isdigit() or len(word) == 1


@dataclass(frozen=True)
class Kind:
    """A kind of thing that an entity's name asks for."""

    noun: Phrase
    """What it is: ``("dining", "table")``."""
    described: Phrase = ()
    """Words that only tell how it looks: ``("oak",)``."""


def kinds_of(names: Iterable[str]) -> list[Kind]:
    """The kinds that an entity's name and aliases ask for, without repeats. ``A or B`` asks for both."""
    found: dict[Kind, None] = {}
    for name in names:
        parts = [part for part in map(_kind, _LIST.split(name)) if part is not None]
        found.update(dict.fromkeys(parts))
    nouns = [kind for kind in found if not lexicon.DESCRIBING.issuperset(kind.noun)]
    return nouns or list(found)


def _kind(text: str) -> Kind | None:
    words = [word for word in words_of(text) if word not in ("a", "an", "the")]
    end = next((i for i, word in enumerate(words) if i and word in _BEHIND), len(words))
    before, after = words[:end], words[end:]
    if after[:1] == ["of"] and len(after) > 1:
        stop = next((i for i, word in enumerate(after[1:], 1) if word in _BEHIND), len(after))
        content = after[1:stop]
        if before[-1] in lexicon.GATHERINGS:
            before = []
        before = content + before
    words = [word for word in before if word not in lexicon.NUMBERS and not word.isdigit()] or before
    if not words:
        return None
    if words[-1] in COLORS and len(words) > 1:
        words = [words[-1], *words[:-1]]
    head, rest = words[-1], [word for word in words[:-1] if word not in lexicon.VAGUE]
    told = frozenset() if head in lexicon.FORMS | lexicon.COLLECTIVES else lexicon.DESCRIBING
    noun = (*(word for word in rest if word not in told), head)
    if lexicon.GATHERINGS.issuperset(noun) or (head in lexicon.GATHERINGS and lexicon.DESCRIBING.issuperset(noun[:-1])):
        return None
    return Kind(noun=noun, described=tuple(word for word in rest if word in told))


@dataclass(frozen=True)
class Named:
    """An asset's name, read."""

    noun: Phrase
    """Its words up to the head noun, variants dropped: ``("market", "stall")`` of ``Market Stall Red 02``."""
    content: Phrase = ()
    """Of a form or a collective, what it is of: ``("water",)`` of ``Water Tile``, ``("book",)`` of ``Book Stack``."""
    form: bool = False
    """Whether the head is a form (a tile), which is as good as its content for surfaces and regions."""
    whole: Phrase = ()
    """The name's words in their own order: ``("floor", "kitchen")``, whose noun is ``("kitchen", "floor")``."""
    earlier: Phrase = ()
    """Words before a number in the middle of the name, which could be the noun: ``Chair 01 Leg``."""


def read_name(name: str, category: str = "", description: str = "", siblings: Collection[str] = ()) -> Named:
    """Read an asset's name. ``siblings``: its catalog's names, each as ``joined`` ``plain_words``."""
    words, earlier = _plain(name, category)
    words = _without_doubtful(words, siblings)
    turned = _turned(words, description)
    head, rest = turned[-1:], tuple(turned[:-1])
    form, collective = rest and head[0] in lexicon.FORMS, rest and head[0] in lexicon.COLLECTIVES
    return Named(
        noun=tuple(turned),
        content=rest if form or collective else (),
        form=bool(form),
        whole=tuple(words),
        earlier=earlier,
    )


def plain_words(name: str, category: str = "") -> Phrase:
    """The words of an asset's name in their order, without numbers, letters and plain variants behind its noun."""
    return tuple(_plain(name, category)[0])


def _plain(name: str, category: str) -> tuple[list[str], Phrase]:
    found = words_of(name)
    words = list(found[next((i for i, word in enumerate(found) if word not in PREFIXES), len(found)) :])
    words = _of(words)
    opening = _opened_by_category(words, category)
    if opening:
        return words[:opening], ()
    words = _bare(words)
    middle = next((i for i, word in enumerate(words) if i and word.isdigit()), 0)
    earlier = tuple(word for word in words[:middle] if not _mark(word))
    words = [word for word in words if not _mark(word)] or words
    return words, earlier


def _of(words: list[str]) -> list[str]:
    """``barrel of apple`` as ``apple barrel``; what follows another preposition is dropped."""
    end = next((i for i, word in enumerate(words) if i and word in CUTS), len(words))
    if words[end : end + 1] == ["of"] and end + 1 < len(words):
        after = words[end + 1 :]
        stop = next((i for i, word in enumerate(after) if i and word in CUTS), len(after))
        return [word for word in after[:stop] if not _mark(word)] + _bare(words[:end])
    return words[:end] if end else words


def _bare(words: list[str]) -> list[str]:
    while len(words) > 1 and (_mark(words[-1]) or words[-1] in lexicon.POSTPOSED):
        words = words[:-1]
    return words


def _opened_by_category(words: list[str], category: str) -> int:
    """How many words repeat the category before a number or letter: ``House 10 United Homes`` of ``house`` is one."""
    named = words_of(category)
    if not named or any(_mark(word) for word in named):
        return 0
    for length in range(1, len(words)):
        marked = _mark(words[length]) or (
            words[length] == "set" and len(words) > length + 1 and _mark(words[length + 1])
        )
        if marked and joined(words[:length]) == joined(named):
            return length
    return 0


def _without_doubtful(words: list[str], siblings: Collection[str]) -> list[str]:
    """A colour or material at the end is dropped where the catalog has the same thing without it."""
    kept = words
    while len(kept) > 1 and kept[-1] in lexicon.DOUBTFUL:
        kept = kept[:-1]
    return kept if joined(kept) in siblings else words


def _turned(words: list[str], description: str) -> list[str]:
    """Noun first, where the description's own head says so: ``Floor Kitchen`` is a ``chequered kitchen floor tile``."""
    told = description_noun(description)
    if not told or told[-1] in words[-1:]:
        return words
    head = told[-2] if told[-1] in lexicon.FORMS and len(told) > 1 else told[-1]
    if head in words[:-1] and head != words[-1] and head not in lexicon.DESCRIBING:
        place = words.index(head) + 1
        return [*words[place:], *words[:place]]
    return words


def description_noun(description: str) -> Phrase:
    """The noun phrase that a description opens with, without articles and numbers; empty where it opens with none."""
    text = re.split(r"[,.;:(]", description, maxsplit=1)[0]
    words = [word for word in words_of(text) if not _mark(word)]
    end = next((i for i, word in enumerate(words) if i and word in _BEHIND), len(words))
    return tuple(words[:end])
