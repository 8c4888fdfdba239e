"""One rung of the ladder above state: batched claims over shared views, asked once, and once more for what broke."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Final, Literal

from c4s.chat.client import Reply
from c4s.chat.failures import ChatFailed
from c4s.judge.model.batches import Batch, batches, halves
from c4s.judge.model.claims import claim_sheet, claims_text
from c4s.judge.model.clerk import Clerk, Told
from c4s.judge.model.contract import WHOLE, SaidClaim, claims_of, value_of
from c4s.judge.model.requests import Request, Writer, claim_names, view_names
from c4s.judge.model.schemas import claims_schema
from c4s.judge.model.sights import Sights
from c4s.protocol.bundle import Requirements
from c4s.records.judgement import Asked

Sighted = Literal["sight", "alternate", "arbitration"]
_PROMPT: Final[dict[Sighted, str]] = {"sight": "sight", "alternate": "sight", "arbitration": "arbitration"}


@dataclass(frozen=True)
class Answered:
    """What a rung brought for one claim."""

    claim: str
    said: SaidClaim | None
    """None where the contract was broken twice, or no answer came."""
    views: tuple[str, ...]
    """Names in the captures: what was shown."""
    cited: tuple[str, ...]
    asked: Asked
    broken: str = ""
    fault: str = ""


Make = Callable[[Batch, Mapping[str, str]], Request]
"""Writes the request of a batch, and the one after an answer that broke its contract: how, by claim."""


@dataclass
class Rungs:
    """Asks claims of one submission, rung by rung."""

    requirements: Requirements
    sights: Sights
    writer: Writer
    clerk: Clerk
    schedule: list[Asked] = field(default_factory=list)

    def climb(self, rung: Sighted, wanted: Mapping[str, Sequence[str]]) -> dict[str, Answered]:
        """What is said of every claim in its views. The requests go side by side, and on the schedule in their
        order."""
        configuration = self.writer.configuration
        made = batches(
            wanted,
            list(self.sights.views),
            most_claims=configuration.claims_per_request,
            most_views=configuration.pictures_per_request,
        )
        jobs = [partial(self._batch, rung, batch, wanted) for batch in made]
        found: dict[str, Answered] = {}
        for answered, asked in self.clerk.side_by_side(jobs):
            found |= answered
            self.schedule += asked
        return found

    def _batch(
        self, rung: Sighted, batch: Batch, wanted: Mapping[str, Sequence[str]]
    ) -> tuple[dict[str, Answered], list[Asked]]:
        try:
            make = partial(self._request, rung, wanted)
            return asked_twice(self.clerk, rung, batch, make, may_split=len(batch.claims) > 1)
        except ChatFailed as failure:
            if failure.kind != "context" or len(batch.claims) < 2:
                raise
        parts = [self._batch(rung, half, wanted) for half in halves(batch)]
        return {**parts[0][0], **parts[1][0]}, [*parts[0][1], *parts[1][1]]

    def _request(
        self, rung: Sighted, wanted: Mapping[str, Sequence[str]], batch: Batch, broken: Mapping[str, str]
    ) -> Request:
        shown = [(name, picture) for name in batch.views if (picture := self.sights.picture(name)) is not None]
        views = dict(zip(batch.views, view_names(len(batch.views)), strict=True))
        names = claim_names(len(batch.claims))
        sheets = [
            claim_sheet(self.requirements, claim, name, [views[view] for view in batch.views if view in wanted[claim]])
            for claim, name in zip(batch.claims, names, strict=True)
        ]
        return self.writer.write(
            rung,
            _PROMPT[rung],
            shown,
            before="Pictures of the scene:",
            after=claims_text(sheets, broken),
            schema=claims_schema(names, list(views.values()), binary=rung == "arbitration"),
            claims=batch.claims,
            again=bool(broken),
        )


def asked_twice(
    clerk: Clerk, rung: Sighted, batch: Batch, make: Make, *, may_split: bool
) -> tuple[dict[str, Answered], list[Asked]]:
    """What is said of a batch, asked once, and once more for the claims whose answer broke the contract."""
    first = _once(clerk, rung, batch, make(batch, {}), may_split)
    found = _answered(batch, first)
    broken = {claim: one.broken for claim, one in found.items() if one.broken}
    if not broken:
        return found, [first.asked]
    left = Batch(tuple(claim for claim in batch.claims if claim in broken), batch.views)
    second = _once(clerk, rung, left, make(left, broken), may_split and len(left.claims) > 1)
    return {**found, **_answered(left, second)}, [first.asked, second.asked]


def _once(clerk: Clerk, rung: Sighted, batch: Batch, request: Request, may_split: bool) -> Told[dict[str, SaidClaim]]:
    names, views = claim_names(len(batch.claims)), view_names(len(batch.views))
    ids = dict(zip(names, batch.claims, strict=True))

    def read(reply: Reply) -> tuple[dict[str, SaidClaim], dict[str, str]]:
        said, wrong = claims_of(value_of(reply), names, views, binary=rung == "arbitration")
        return {ids[name]: one for name, one in said.items()}, {ids[name]: kind for name, kind in wrong.items()}

    return clerk.ask(request, read, may_split=may_split)


def _answered(batch: Batch, told_of: Told[dict[str, SaidClaim]]) -> dict[str, Answered]:
    asked, said = told_of.asked, told_of.value or {}
    views = dict(zip(view_names(len(batch.views)), batch.views, strict=True))
    return {
        claim: Answered(
            claim,
            said.get(claim),
            batch.views,
            tuple(views[name] for name in said[claim].views) if claim in said else (),
            asked,
            "" if claim in said else asked.broken.get(claim, asked.broken.get(WHOLE, "")),
            asked.fault,
        )
        for claim in batch.claims
    }
