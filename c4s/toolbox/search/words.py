"""Words and stems: camel case and underscores separate words, English endings are cut off (Snowball)."""

from __future__ import annotations

import re
from functools import lru_cache

import snowballstemmer

_WORD = re.compile(r"[a-z0-9]+")
_IRREGULAR = {
    "knives": "knife",
    "shelves": "shelf",
    "leaves": "leaf",
    "loaves": "loaf",
    "wolves": "wolf",
    "men": "man",
    "women": "woman",
    "people": "person",
    "children": "child",
    "geese": "goose",
    "mice": "mouse",
    "feet": "foot",
    "sat": "sit",
    "slept": "sleep",
    "kept": "keep",
    "lit": "light",
    "written": "write",
    "wrote": "write",
    "drove": "drive",
    "driven": "drive",
    "held": "hold",
}
_EMPTY = (
    "a an and any are as at be been by can do does for from get gives had has have he her here his how i in into is it "
    "its kind let lets like made make makes me my no not object objects of off on one or our out over own place places "
    "she so some somebody someone something somewhere sort such that the their them then there these they thing things "
    "this those to type up use used uses using very was we were what when where which while who with you your it's "
    "asset assets item items model prop props near next"
)
EMPTY = frozenset(_EMPTY.split())
"""Words that say nothing of what is looked for."""
_STEMMER = snowballstemmer.stemmer("english")


def words_of(value: str) -> list[str]:
    """Lower-case words; camel case, underscores and a number behind letters separate words."""
    return _WORD.findall(re.sub(r"(?<=[a-z])(?=[A-Z0-9])", " ", value).lower())


@lru_cache(maxsize=65536)
def stem_of(word: str) -> str:
    """The stem of a lower-case word."""
    return str(_STEMMER.stemWord(_IRREGULAR.get(word, word)))


def stems_of(value: str) -> list[str]:
    """Stems of a text's words, in their order, without the empty words and single letters."""
    return [stem_of(word) for word in words_of(value) if word not in EMPTY and (len(word) > 1 or word.isdigit())]
