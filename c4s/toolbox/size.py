"""How much text an answer has: what fits into one, and the guard that holds whatever a tool gives.

Sizes are bytes of UTF-8: no client counts a text as more characters than that. Tools fill their lists only as far as
they fit (``rows_that_fit``, ``side_by_side``) and say where to go on; the gateway holds every answer to its bound
(``held``), so that no name, text or list that somebody made too long can keep an answer from arriving.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

from c4s.toolbox.refusal import ToolRefused

MAX_BODY_BYTES = 4 << 20
"""Of one request to the gateway."""
ANSWER_SIZE = 20_000
"""Most text of an answer."""
ASKED_SIZE = 200_000
"""Most text of an answer whose length the caller asked for."""
ERROR_SIZE = 8_000
"""Most text of an error: clients show less of one than of an answer."""
AROUND = 600
"""What stands around a tool's data in an answer: the budget, and what the tool says besides its lists."""
TEXT_SIZE = 500
"""Longest text within a row of a list."""
_LEVELS = ((2_000, 1_000), (500, 300), (200, 100), (100, 30), (60, 10), (40, 3))
"""Longest text and longest list that the guard leaves, one try after the other."""
_CUTS_TOLD = 10
_MOST_ESCAPED = 6
"""Bytes of a character in JSON, at most."""


def json_text(value: Any) -> str:
    """JSON that can be sent. ``ToolRefused`` for numbers that are not finite."""
    try:
        text = json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    except ValueError:
        raise ToolRefused("the scene holds numbers that are not finite", todo="mend those actors") from None
    return text if whole(text) == text else json.dumps(value, allow_nan=False, separators=(",", ":"))


def whole(text: str) -> str:
    """The text with halves of characters spelt out: they can stand in JSON as escapes, but in no UTF-8."""
    return text if text.isascii() else text.encode("utf-8", "backslashreplace").decode()


def size(text: str) -> int:
    """Bytes of a text."""
    return len(text) if text.isascii() else len(text.encode("utf-8", "backslashreplace"))


def clipped(text: str, most: int) -> str:
    """A text that takes at most ``most`` bytes in JSON: a longer one by its beginning and its end, with what is left
    out counted."""
    if size(text) <= most // _MOST_ESCAPED or _in_json(text) <= most:
        return text
    data = text.encode("utf-8", "backslashreplace")
    room = most
    while True:
        gap = f" ... [{len(data) - room} more bytes] ... "
        kept = max(0, room - len(gap)) // 2
        short = data[:kept].decode("utf-8", "ignore") + gap + data[len(data) - kept :].decode("utf-8", "ignore")
        if _in_json(short) <= most or not kept:
            return short
        room = room * 3 // 4


def _in_json(text: str) -> int:
    """Bytes of a text in JSON, without its quotes."""
    return size(json_text(text)) - 2


def part_that_fits(text: str, room: int, *, of_end: bool) -> str:
    """The beginning or the end of a text that takes at most ``room`` bytes as JSON."""
    while text and (over := size(json_text(text)) - room) > 0:
        less = max(1, over // _MOST_ESCAPED)
        text = text[less:] if of_end else text[:-less]
    return text


def shortened(value: Any, text: int = TEXT_SIZE, rows: int | None = None) -> Any:
    """A value with its long texts clipped, and the ends of its long lists and mappings left out."""
    if isinstance(value, str):
        return clipped(value, text)
    if isinstance(value, Mapping):
        kept = list(value.items())[:rows]
        return {clipped(str(key), text): shortened(one, text, rows) for key, one in kept}
    if isinstance(value, list | tuple):
        return [shortened(one, text, rows) for one in value[:rows]]
    return value


def rows_that_fit(rows: Sequence[Any], room: int) -> list[Any]:
    """The first rows, long texts clipped, that together take at most ``room`` bytes; one at least."""
    kept: list[Any] = []
    for row in map(shortened, rows):
        room -= size(json_text(row)) + 1
        if kept and room < 0:
            break
        kept.append(row)
    return kept


def side_by_side(lists: Mapping[str, Sequence[Any]], room: int) -> dict[str, list[Any]]:
    """The first rows of several lists that together take at most ``room`` bytes: a row of each in turn."""
    kept: dict[str, list[Any]] = {name: [] for name in lists}
    open_lists = dict.fromkeys(lists)
    for number in range(max(map(len, lists.values()), default=0)):
        for name in list(open_lists):
            rows = lists[name]
            row = shortened(rows[number]) if number < len(rows) else None
            needed = 0 if row is None else size(json_text(row)) + 1
            if row is None or needed > room:
                del open_lists[name]
            else:
                kept[name].append(row)
                room -= needed
        if not open_lists:
            break
    return kept


def held(data: dict[str, Any], most: int) -> tuple[str, int]:
    """Data as JSON of at most ``most`` bytes, and how many it has whole.

    Data that is longer keeps the beginnings of its texts and lists; ``cut`` says so and counts what was there.
    """
    text = json_text(data)
    found = size(text)
    if found <= most:
        return text, found
    for longest, rows in _LEVELS:
        said = {"bytes": found, "kept": "the beginnings of long texts and lists", "lists": _long(data, rows)}
        text = json_text({**shortened(data, longest, rows), "cut": said})
        if size(text) <= most:
            return text, found
    return json_text({"cut": {"bytes": found, "kept": "nothing: it does not fit"}}), found


def _long(data: Mapping[str, Any], rows: int) -> dict[str, int]:
    """The lists of the data that are longer than that, with their lengths."""
    found = {key: len(value) for key, value in data.items() if isinstance(value, list) and len(value) > rows}
    return dict(list(found.items())[:_CUTS_TOLD])
