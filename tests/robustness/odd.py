"""Documents that are wrong somewhere: a place in them is replaced by a value of another kind, or left out."""

from __future__ import annotations

import copy
import json
from typing import Any

from hypothesis import strategies as st

ODD: st.SearchStrategy[Any] = st.sampled_from(
    [
        None,
        True,
        0,
        -1,
        2**70,
        1e308,
        -1e308,
        1e-320,
        float("nan"),
        float("inf"),
        "",
        "/Game/../..",
        "\x00",
        "ü" * 2000,
        [],
        {},
        [[]],
        {"a": {}},
        [1, 2],
        ["x"] * 4,
        "NaN",
        "/Script/Engine.Actor",
        "/Game/Made/None.None",
    ]
)


def places(value: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Paths of all values in a document."""
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    return [path, *(place for key, item in inner for place in places(item, (*path, key)))]


def replaced(document: Any, path: tuple[Any, ...], value: Any) -> Any:
    """A copy with another value at a path."""
    if not path:
        return value
    made = copy.deepcopy(document)
    target = made
    for key in path[:-1]:
        target = target[key]
    target[path[-1]] = value
    return made


@st.composite
def wrong(draw: st.DrawFn, document: Any) -> bytes:
    """The document as text with one to three places replaced, or cut off, or with bytes that are no text."""
    for _ in range(draw(st.integers(1, 3))):
        document = replaced(document, draw(st.sampled_from(places(document))), draw(ODD))
    text = json.dumps(document).encode()
    match draw(st.integers(0, 5)):
        case 0:
            return text[: draw(st.integers(0, len(text)))]
        case 1:
            at = draw(st.integers(0, len(text)))
            return text[:at] + draw(st.binary(min_size=1, max_size=4)) + text[at:]
        case _:
            return text
