"""How the columns of a table are laid out on a terminal, so that no number and no word is folded."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

GAP = 3
"""Letters between two columns."""
FEW = 2
"""So many rows are told column by column where they are too wide."""
_NUMBER = re.compile(r"[-+]?[\d,]+(\.\d+)?( \*{1,2})?")
_EMPTY = ("", "–")
_DIGEST = re.compile(r"[0-9a-f]{40,}")
SHORT_DIGEST = 12
"""Letters of a digest that are shown where there is no room for all."""


@dataclass(frozen=True)
class Laid:
    """Columns of a table by their places."""

    same: list[int]
    """Those whose cells are all alike: told once."""
    keys: list[int]
    """Those that are repeated with each group: they tell the rows apart."""
    groups: list[list[int]]
    """The others, as many together as fit; none where each row is told column by column."""


def is_numeric(cells: Sequence[str]) -> bool:
    """Whether a column holds numbers, with or without a mark behind them."""
    told = [one for one in cells if one not in _EMPTY]
    return bool(told) and all(_NUMBER.fullmatch(one) for one in told)


def narrowest(title: str, cells: Sequence[str]) -> int:
    """The least width at which no word is folded, and of numbers no cell."""
    whole = is_numeric(cells)
    words = [len(word) for word in title.split()]
    words += [len(cell) if whole else max(map(len, cell.split()), default=0) for cell in cells]
    return max(words, default=0)


def widths_of(titles: Sequence[str], rows: Sequence[Sequence[str]], width: int) -> list[int]:
    """Width of each column: the least, and what is left over for those that would fold, the first ones first."""
    cells = [[row[place] for row in rows] for place in range(len(titles))]
    found = [min(narrowest(title, own), width) for title, own in zip(titles, cells, strict=True)]
    spare = width - sum(found) - GAP * (len(found) - 1)
    for place, (title, own) in enumerate(zip(titles, cells, strict=True)):
        wish = max(len(line) for text in (title, *own) for line in text.split("\n"))
        more = max(0, min(spare, wish - found[place]))
        found[place] += more
        spare -= more
    return found


def laid_out(titles: Sequence[str], rows: Sequence[Sequence[str]], width: int) -> Laid:
    """One group where all columns fit; else what is alike in all rows, and groups that each begin with the keys."""
    places = range(len(titles))
    widths = [narrowest(title, [row[place] for row in rows]) for place, title in enumerate(titles)]
    if sum(widths) + GAP * (len(widths) - 1) <= width:
        return Laid([], [], [list(places)])
    if len(rows) <= FEW:
        return Laid([], [], [])
    same = [place for place in places if len({row[place] for row in rows}) == 1]
    others = [place for place in places if place not in same]
    keys = _keys(others, rows, widths, width // 2)
    groups: list[list[int]] = []
    room = 0
    for place in (place for place in others if place not in keys):
        if not groups or room < widths[place] + GAP:
            groups.append([])
            room = width - sum(widths[key] + GAP for key in keys) + GAP
        groups[-1].append(place)
        room -= widths[place] + GAP
    return Laid(same, keys, groups or [[]])


def cut_digests(row: Sequence[str]) -> list[str]:
    """The cells of a row, digests by their first letters."""
    return [f"{cell[:SHORT_DIGEST]}…" if _DIGEST.fullmatch(cell) else cell for cell in row]


def _keys(places: Sequence[int], rows: Sequence[Sequence[str]], widths: Sequence[int], room: int) -> list[int]:
    """The fewest columns of words, at most three, that tell all rows apart and have room; else the first one."""
    words = [place for place in places if not is_numeric([row[place] for row in rows])]
    for many in (1, 2, 3):
        for keys in combinations(words, many):
            if sum(widths[key] + GAP for key in keys) <= room and len(
                {tuple(row[k] for k in keys) for row in rows}
            ) == len(rows):
                return list(keys)
    return [place for place in words[:1] if widths[place] + GAP <= room]
