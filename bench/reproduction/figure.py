"""A printed number, the one that our code gives, and how the two agree."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from decimal import ROUND_HALF_UP, Decimal
from typing import Final, Literal

Status = Literal["exact", "within_rounding", "mismatch", "consistent", "diagnostic", "open", "not_recomputable"]
"""``exact``: ours rounds to what is printed. ``within_rounding``: the rounding of the printed inputs allows it.
``mismatch``: it does not. ``consistent``: only a condition can be tested, and it holds. ``diagnostic``: no printed
number, but the test of a reading. ``open``: printed numbers leave a gap that the paper does not explain.
``not_recomputable``: the inputs are not printed."""
HALF: Final = 0.0005
"""Half a unit of the third decimal, which most tables end with."""
_GUARD: Final = 1e-9


@dataclass(frozen=True)
class Draft:
    """What our code says of a printed number."""

    what: str
    ours: float | str | None
    slack: float = 0.0
    """How far the rounding of printed inputs may move ours."""
    reach: Sequence[float] = ()
    """What ours may be where inputs vary within their rounding; taken where a slack cannot be told."""
    status: Status | None = None
    """Told, where it is not a matter of digits."""
    note: str = ""


@dataclass(frozen=True)
class Figure:
    """A row of the table."""

    check: str
    what: str
    published: str
    ours: str
    status: Status
    note: str


def number(what: str, ours: float, slack: float = 0.0, reach: Sequence[float] = (), note: str = "") -> Draft:
    """A printed number."""
    return Draft(what, float(ours), slack=slack, reach=reach, note=note)


def same(what: str, ours: object, published: object, note: str = "") -> Draft:
    """Words, orders and sets: equal or not."""
    return Draft(what, _text(ours), status="exact" if ours == published else "mismatch", note=note)


def holds(what: str, ours: object, condition: bool, note: str = "") -> Draft:
    """A condition that the printed numbers have to meet."""
    return Draft(what, _text(ours), status="consistent" if condition else "mismatch", note=note)


def close(what: str, ours: float, published: float, within: float, note: str) -> Draft:
    """A number of which only the larger part can be computed: it has to be near."""
    return Draft(what, ours, status="consistent" if abs(ours - published) < within else "not_recomputable", note=note)


def seen(what: str, ours: object, note: str) -> Draft:
    """The test of a reading."""
    return Draft(what, _text(ours), status="diagnostic", note=note)


def judged(check: str, draft: Draft, published: str, decimals: int | None) -> Figure:
    """A draft against what is published."""
    status = draft.status or _of_digits(draft, float(published), decimals or 0)
    ours = "" if draft.ours is None else draft.ours if isinstance(draft.ours, str) else f"{draft.ours:.6f}"
    return Figure(check, draft.what, published, ours, status, draft.note)


def half_up(value: float, decimals: int) -> float:
    """Rounded as tables round."""
    exact = Decimal(repr(round(value, 12)))
    return float(exact.quantize(Decimal(1).scaleb(-decimals), rounding=ROUND_HALF_UP))


def _of_digits(draft: Draft, published: float, decimals: int) -> Status:
    assert isinstance(draft.ours, float)
    printed = round(published, decimals)
    if half_up(draft.ours, decimals) == printed:
        return "exact"
    if any(half_up(value, decimals) == printed for value in draft.reach):
        return "within_rounding"
    near = abs(draft.ours - published) <= draft.slack + 0.5 * 10**-decimals + _GUARD
    return "within_rounding" if near and not draft.reach else "mismatch"


def _text(value: object) -> str:
    return "; ".join(map(str, value)) if isinstance(value, list | tuple) else str(value)
