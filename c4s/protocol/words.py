"""Words and phrases: whole-word, plural-tolerant matching of a named object against names of assets."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable


def word_set(text: str) -> frozenset[str]:
    """The words of a text, as a set."""
    return frozenset(text.split())


_TOKEN = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+|[^\W\d_A-Za-z]+")
_POSSESSIVE = re.compile(r"['’]s\b")
_IRREGULAR = {
    "people": "person",
    "men": "man",
    "women": "woman",
    "children": "child",
    "leaves": "leaf",
    "shelves": "shelf",
    "knives": "knife",
    "loaves": "loaf",
    "wolves": "wolf",
    "geese": "goose",
    "mice": "mouse",
    "feet": "foot",
    "benches": "bench",
    "axes": "axe",
    "movies": "movie",
    "shoes": "shoe",
    "canoes": "canoe",
    "toes": "toe",
    "buses": "bus",
    "calves": "calf",
    "halves": "half",
    "hooves": "hoof",
    "scarves": "scarf",
    "thieves": "thief",
    "oxen": "ox",
    "cacti": "cactus",
    "teeth": "tooth",
}
_COMPOUND = ("shelves", "children", "knives", "leaves", "women", "wolves")
"""Irregular plurals that end compounds too: bookshelves."""
_UNCHANGED = ("ss", "us", "is")
CUTS = frozenset({"with", "of", "on", "for", "in", "and", "at"})
"""A name's head noun stands before the first of these."""
VARIANTS = word_set("""
    large small big little tall short long wide narrow tiny huge medium mini left right front back
    straight curved corner open closed broken old new worn rusty dirty clean ruined empty full single double triple
    red orange yellow green blue purple pink brown black white grey gray beige dark pale bright gold silver
    wood wooden metal metallic steel concrete plastic leather fabric marble variant version bp sm lod""")
"""Words behind a head noun that only name a variant: ``Crate_Large_02`` is a crate."""
PREFIXES = frozenset({"sm", "bp", "sk", "s", "mesh"})


def singular(word: str) -> str:
    """A noun's singular by common English rules; anything else as it is."""
    if word in _IRREGULAR:
        return _IRREGULAR[word]
    for plural in _COMPOUND:
        if word.endswith(plural):
            return word.removesuffix(plural) + _IRREGULAR[plural]
    if len(word) <= 3 or not word.endswith("s") or word.endswith(_UNCHANGED):
        return word
    if word.endswith("ies"):
        return word[:-3] + "y"
    if word.endswith(("ches", "shes", "sses", "xes", "zes", "oes")):
        return word[:-2]
    return word[:-1]


def tokens(text: str) -> tuple[str, ...]:
    """Lower-case singular words of a text, split at capitals, digits and punctuation; accents and ``'s`` dropped."""
    if not text.isascii():
        letters = unicodedata.normalize("NFKD", text)
        text = "".join(letter for letter in letters if not unicodedata.combining(letter))
    return tuple(singular(part.lower()) for part in _TOKEN.findall(_POSSESSIVE.sub("", text)))


def head(text: str) -> tuple[str, ...]:
    """The words of a name up to and including its head noun: prefixes, what follows ``with``, variants dropped."""
    found = tokens(text)
    words = found[next((i for i, word in enumerate(found) if word not in PREFIXES), len(found)) :]
    end = next((i for i, word in enumerate(words) if i and word in CUTS), len(words))
    while end > 1 and (words[end - 1].isdigit() or len(words[end - 1]) == 1 or words[end - 1] in VARIANTS):
        end -= 1
    return words[:end]


def spoken(words: Iterable[str]) -> str:
    """Words as one text in which ``spoken`` of some of them in a row is found as a part."""
    return " ".join(("", *words, ""))
