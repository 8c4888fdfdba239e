"""Texts as runs of words, so that one text is found in another however it is written down there."""

from __future__ import annotations

import html
import re
from collections.abc import Collection, Iterator, Mapping
from typing import Any
from urllib.parse import unquote

PIECE: int = 6
"""Words of a longer text that tell it: every run of so many is looked for."""
_BETWEEN = re.compile(r"[\W_]+")
_JOINT = re.compile(r"(?:(?!&#)[^\w\s<>|,;]|_){1,3}")
_UNSEEN = re.compile("[\u00ad\u200b-\u200f\u2060\ufeff]")
_ESCAPE = re.compile(r"\\(?:u([0-9a-fA-F]{4})|x([0-9a-fA-F]{2})|([\"'\\/bfnrt]))")
_TAG = re.compile(r"<[^<>]*>")
_HTML = (
    "a|article|aside|b|body|button|caption|circle|code|details|dialog|figure|footer|form|g|head|header|i|image|label|legend"
    "|line|link|main|map|mark|menu|nav|object|option|output|p|path|pattern|picture|q|s|script|section|select|small|source"
    "|strong|style|summary|table|template|text|time|title|u|use|video"
)
"""Elements of HTML and SVG that are words too; what else is written as a tag is read."""
_NAME_OF_TAG = re.compile(rf"</(?:{_HTML})\s*>|<(?:{_HTML})(?=\s+[\w-]+=)")


def words(text: str) -> list[str]:
    """The words of a text: letters and digits, in small letters; all else is between words."""
    return _BETWEEN.sub(" ", _UNSEEN.sub("", text).casefold()).split()


def pieces(text: str) -> Iterator[str]:
    """What tells a text: its words, or each run of ``PIECE`` of them where it has more."""
    found = words(text)
    for first in range(max(1, len(found) - PIECE + 1)):
        yield " ".join(found[first : first + PIECE])


def readings(text: str) -> Iterator[str]:
    """A text as it stands there but for HTML's tag names, and without escapes of HTML, JSON, addresses, and tags."""
    plain = _unescaped(text) if "\\" in text else text
    for one in dict.fromkeys((text, plain)):
        yield _NAME_OF_TAG.sub("<>", one) if "<" in one else one
        if "&" in one:
            yield html.unescape(_NAME_OF_TAG.sub("<>", one))
        if "<" in one:
            yield html.unescape(_TAG.sub(" ", one))
    if "%" in text:
        yield unquote(text)


def beginnings_of(wanted: Collection[str]) -> dict[str, tuple[int, ...]]:
    """By the first word of pieces, how many words they have."""
    found: dict[str, set[int]] = {}
    for piece in wanted:
        found.setdefault(piece.partition(" ")[0], set()).add(piece.count(" ") + 1)
    return {word: tuple(sorted(lengths)) for word, lengths in found.items()}


def found_in(
    text: str, wanted: Collection[str], beginnings: Mapping[str, tuple[int, ...]], joined: Collection[str] = ()
) -> set[str]:
    """Which of some pieces, which begin so, stand in a text, in any of its readings.

    Those that are ``joined`` stand there only as a name does: a number in a table beside a word is none.
    """
    found: set[str] = set()
    for reading in readings(text):
        there = words(reading)
        close: list[bool] = []
        for first, word in enumerate(there):
            for length in beginnings.get(word, ()):
                piece = " ".join(there[first : first + length])
                if piece not in wanted or piece in found:
                    continue
                if piece in joined:
                    close = close or _close(reading)
                    if not all(close[first : first + length - 1]):
                        continue
                found.add(piece)
    return found


def _close(text: str) -> list[bool]:
    """Of each word of a text, whether it is written together with the next one."""
    plain = _UNSEEN.sub("", text).casefold()
    between = _BETWEEN.finditer(plain)
    return [_JOINT.fullmatch(one[0]) is not None for one in between if one.start()]


def strings_of(value: Any) -> Iterator[str]:
    """Every text in a JSON value, the names of fields too."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for name, inner in value.items():
            yield str(name)
            yield from strings_of(inner)
    elif isinstance(value, list | tuple):
        for inner in value:
            yield from strings_of(inner)


def _unescaped(text: str) -> str:
    named = {"b": "\b", "f": "\f", "n": "\n", "r": "\r", "t": "\t"}

    def plain(found: re.Match[str]) -> str:
        code, byte, one = found.groups()
        return chr(int(code or byte, 16)) if code or byte else named.get(one, one)

    return _ESCAPE.sub(plain, text)
