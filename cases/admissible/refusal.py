"""One reason against a repair, and the error of a suite that has some."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Final, Literal

from c4s.errors import BadInput

RefusalKind = Literal["loses", "unreachable", "guessed", "seen", "thing", "hanging", "views"]
TOLD: Final[dict[RefusalKind, str]] = {
    "loses": "lose physics",
    "unreachable": "cannot be repaired fully",
    "guessed": "can be guessed",
    "seen": "cannot be seen",
    "thing": "change what is no thing to change",
    "hanging": "leave things hanging",
    "views": "have a wrong number of views",
}
"""What the cases of a kind do."""
_SHOWN = 4
"""Refusals that the message of a build tells."""


@dataclass(frozen=True)
class Refusal:
    """A case that cannot be used, and why."""

    case_id: str
    kind: RefusalKind
    reason: str

    def plain(self) -> dict[str, str]:
        """As a row of a report."""
        return asdict(self)


class Refused(BadInput):
    """Cases of a suite cannot be used; ``refusals`` has all reasons."""

    def __init__(self, found: Sequence[Refusal]) -> None:
        cases = dict.fromkeys(one.case_id for one in found)
        told = "; ".join(f"{one.case_id}: {one.reason}" for one in found[:_SHOWN])
        more = f"; and {len(found) - _SHOWN} more" if len(found) > _SHOWN else ""
        super().__init__(
            f"{len(cases)} case{'s' if len(cases) > 1 else ''} cannot be used: {told}{more}",
            todo="change the views or the changes of these cases",
        )
        self.refusals = tuple(found)


def summed(refused: Sequence[Refusal]) -> str:
    """What was refused in one line: how many for which kind of reason."""
    counts = Counter(one.kind for one in refused)
    return ", ".join(f"{counts[kind]} {what}" for kind, what in TOLD.items() if counts[kind])
