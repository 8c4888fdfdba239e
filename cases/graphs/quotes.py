"""Where the words that an author or a model quotes stand in a prompt."""

from __future__ import annotations

import re
from dataclasses import dataclass

from c4s.errors import BadInput


@dataclass(frozen=True)
class Quoted:
    """A quote, found."""

    start: int
    end: int
    text: str
    """The prompt's own letters."""

    @property
    def span(self) -> dict[str, int]:
        """As it stands in a graph."""
        return {"start": self.start, "end": self.end}


def places(description: str, text: str) -> list[Quoted]:
    """Every place of a quote in a description: as whole words, else as letters, else with other case and blanks."""
    found: list[Quoted] = []
    escaped = re.escape(text)
    loose = r"\s+".join(re.escape(word) for word in text.split())
    for pattern, flags in ((rf"(?<!\w){escaped}(?!\w)", 0), (escaped, 0), (rf"(?<!\w){loose}(?!\w)", re.IGNORECASE)):
        if not text.strip():
            break
        found = [
            Quoted(match.start(), match.end(), match.group()) for match in re.finditer(pattern, description, flags)
        ]
        if found:
            break
    return found


def find_quote(description: str, text: str, occurrence: int = 0, *, where: str = "") -> Quoted:
    """The given occurrence of a quote; ``BadInput`` when it is not there."""
    found = places(description, text)
    if occurrence < len(found):
        return found[occurrence]
    times = f", which stands there {len(found)} time{'s' if len(found) != 1 else ''}" if found else ""
    raise BadInput(f"the prompt does not hold {_short(text)!r} (occurrence {occurrence}){times}", where=where)


def find_inside(description: str, text: str, outer: Quoted, *, where: str = "") -> Quoted:
    """A quote within another's words; the first of several. ``BadInput`` when it is not there."""
    inner = [quote for quote in places(description, text) if outer.start <= quote.start and quote.end <= outer.end]
    if not inner:
        start = outer.text.casefold().find(text.casefold()) if text else -1
        if start < 0:
            raise BadInput(f"{_short(outer.text)!r} does not hold {_short(text)!r}", where=where)
        place = outer.start + start
        return Quoted(place, place + len(text), description[place : place + len(text)])
    return inner[0]


def _short(text: str) -> str:
    return text if len(text) <= 80 else text[:77] + "..."
