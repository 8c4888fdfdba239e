"""The two calls over the four overview views, each with a prompt of its own and neither knowing of the other.

The prompt-aware call sees the task's text and rates four dimensions; the prompt-free call sees the pictures alone and
rates structural integrity. A call whose answer breaks its contract twice is a fault: an overview has no unknown.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, TypeVar

from c4s.chat.client import Reply
from c4s.errors import MachineryFault
from c4s.judge.model.clerk import Clerk, Told
from c4s.judge.model.contract import WHOLE, Rated, dimensions_of, structure_of, value_of
from c4s.judge.model.requests import Request, Writer, view_names
from c4s.judge.model.schemas import prompt_aware_schema, prompt_free_schema
from c4s.judge.model.sights import Sights
from c4s.protocol.overview import severe_cap_eligible
from c4s.protocol.rules import OVERVIEW_VIEWS
from c4s.records.judgement import Asked, OverviewDimension, OverviewJudgement, SevereDefect

T = TypeVar("T")
_CUT = re.compile(r"=== (?:GROUND|ASSET PALETTE) ===")
_AGAIN = "An earlier answer could not be used ({kind}). Keep to the fields, anchors and names that are given."


class ContractBroken(MachineryFault):
    """A model broke the contract of an overview twice."""


@dataclass(frozen=True)
class OverviewSaid:
    """What the two calls brought."""

    judgement: OverviewJudgement | None
    reason: str
    """Why there is none."""
    schedule: list[Asked]


def described(prompt: str) -> str:
    """The task's text without the lists that tell an agent what it may build of."""
    return _CUT.split(prompt, maxsplit=1)[0].strip()


def judge_overview(prompt: str, sights: Sights, writer: Writer, clerk: Clerk, *, accept_faults: bool) -> OverviewSaid:
    """Both calls, side by side. ``ContractBroken`` where an answer cannot be used, unless faults are accepted."""
    views = [name for name in sights.overview if sights.picture(name) is not None]
    if len(views) != OVERVIEW_VIEWS:
        return OverviewSaid(None, f"needs {OVERVIEW_VIEWS} overview views, has {len(views)}", [])
    shown = [(name, picture) for name in views if (picture := sights.picture(name)) is not None]
    names = view_names(len(shown))

    def aware(again: str) -> Request:
        text = f"The task:\n{described(prompt)}\n\nPictures of the scene:"
        return writer.write(
            "prompt_aware",
            "prompt_aware",
            shown,
            before=text,
            after=again,
            schema=prompt_aware_schema(),
            again=bool(again),
        )

    def free(again: str) -> Request:
        return writer.write(
            "prompt_free",
            "prompt_free",
            shown,
            before="Pictures of the scene:",
            after=again,
            schema=prompt_free_schema(names),
            again=bool(again),
        )

    calls: list[Callable[[], tuple[Any, list[Asked]]]] = [
        partial(asked_twice, clerk, aware, dimensions_of),
        partial(asked_twice, clerk, free, partial(structure_of, views=names)),
    ]
    (rated, first), (inspected, second) = clerk.side_by_side(calls)
    schedule = [*first, *second]
    if rated is None or inspected is None:
        reason = why_broken(schedule)
        if not accept_faults:
            raise ContractBroken(f"no overview: {reason}", todo="run the same command again, or with --accept-faults")
        return OverviewSaid(None, f"error: {reason}", schedule)
    return OverviewSaid(_judgement(rated, inspected, dict(zip(names, views, strict=True))), "", schedule)


def asked_twice(
    clerk: Clerk, make: Callable[[str], Request], read: Callable[[Mapping[str, Any]], T]
) -> tuple[T | None, list[Asked]]:
    """Ask, and once more where the answer breaks its contract; None where it breaks it again or none comes."""

    def understood(reply: Reply) -> tuple[T, dict[str, str]]:
        return read(value_of(reply)), {}

    told: Told[T] = clerk.ask(make(""), understood)
    if WHOLE not in told.asked.broken:
        return told.value, [told.asked]
    again = clerk.ask(make(_AGAIN.format(kind=told.asked.broken[WHOLE])), understood)
    return again.value, [told.asked, again.asked]


def why_broken(schedule: list[Asked]) -> str:
    """What is wrong with the last requests of a schedule, in a line."""
    told = [f"{asked.purpose}: {asked.fault or asked.broken.get(WHOLE)}" for asked in schedule]
    return "; ".join(line for line, asked in zip(told, schedule, strict=True) if asked.fault or asked.broken)


def _judgement(
    rated: tuple[dict[str, Rated], str], inspected: tuple[Rated, SevereDefect | None], views: Mapping[str, str]
) -> OverviewJudgement:
    (dimensions, summary), (structure, severe) = rated, inspected
    places = {name: number for number, name in enumerate(views)}
    eligible = severe is not None and severe_cap_eligible(
        severe=True,
        confidence=severe.confidence,
        views=[places[name] for name in severe.views],
        categories=severe.categories,
        issues=severe.issues,
    )
    return OverviewJudgement(
        dimensions={name: OverviewDimension(score=one.score, reason=one.reason) for name, one in dimensions.items()},
        structural_integrity_score=structure.score,
        structural_reason=structure.reason,
        severe_structural_cap_eligible=eligible,
        severe=severe and severe.model_copy(update={"views": [views[name] for name in severe.views]}),
        summary=summary,
        views=list(views.values()),
    )
