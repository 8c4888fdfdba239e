"""Judgements once more from their own schedule: every request that Detailed Alignment rests on is asked anew, and
nothing else is (paper, "Scenes and repeated judgments").

What was decided before a model was asked stays, and so does who was asked what: a claim's answer is that of the last
request of the schedule that asks for it, as it was when the schedule was made. No other request is added, whatever the
answers are, but the one after an answer that breaks its contract; that is no part of the schedule.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Final, cast

from c4s.errors import BadInput
from c4s.judge.desk import Desk
from c4s.judge.model.batches import Batch
from c4s.judge.model.clerk import Clerk
from c4s.judge.model.combining import combined
from c4s.judge.model.frozen import asked_anew, stored_request
from c4s.judge.model.ladder import told_by
from c4s.judge.model.requests import Request
from c4s.judge.model.rungs import Answered, Sighted, asked_twice
from c4s.judge.model.sights import Sights
from c4s.judge.model.version import model_version
from c4s.protocol.bundle import Requirements, read_requirements
from c4s.records.evidence import Evidence
from c4s.records.judge import JudgeConfiguration
from c4s.records.judgement import Asked, ClaimJudgement, Judgements

NO_OVERVIEW: Final = "a repeat asks for no overview"


def repeat_by_model(
    configuration: JudgeConfiguration, stored: Judgements, evidence: Evidence, exchanges: Path, desk: Desk
) -> Judgements:
    """Judge the claims of a submission anew by the schedule of its judgements.

    Args:
        configuration: of the judge, whose version is the one of the judgements.
        stored: what is on record.
        evidence: that it was made of.
        exchanges: folder of its requests.
        desk: what to work with.

    Raises ``BadInput`` for judgements of another version and for requests or pictures that are not as they were,
    ``ChatFailed`` where the model does not answer.
    """
    if stored.judge_version != model_version(configuration):
        raise BadInput(
            f"these judgements are by another version of the judge {stored.judge!r}",
            todo="judge what the run holds by this version (the flow `rejudge`: docs/judge.md), then repeat",
        )
    requirements = read_requirements(evidence.json("requirements"))
    sights = Sights(evidence, evidence.json("captures"))
    planned = [(asked, stored_request(asked, exchanges, sights)) for asked in stored.claim_schedule()]
    found: dict[str, tuple[Sighted, Answered]] = {}
    schedule: list[Asked] = []
    with Clerk(configuration, desk) as clerk:
        jobs = [partial(_asked, clerk, asked, request) for asked, request in planned]
        for (asked, _), (answered, made) in zip(planned, clerk.side_by_side(jobs), strict=True):
            found |= {claim: (cast(Sighted, asked.purpose), one) for claim, one in answered.items()}
            schedule += made
    claims, beneath = _claims(requirements, stored, found)
    return Judgements(
        judge=stored.judge,
        kind=stored.kind,
        judge_version=stored.judge_version,
        claims=claims,
        beneath=beneath,
        overview_reason=NO_OVERVIEW,
        paired_reason=stored.paired_reason,
        schedule=schedule,
        pictures=sights.digests({name for asked in schedule for name in asked.views}),
        usage=clerk.usage.model_copy(update={"requests": len(schedule)}),
        served=clerk.served,
    )


def _asked(clerk: Clerk, asked: Asked, request: Request) -> tuple[dict[str, Answered], list[Asked]]:
    rung = cast(Sighted, asked.purpose)

    def make(batch: Batch, broken: Mapping[str, str]) -> Request:
        return asked_anew(request, rung, batch, broken) if broken else request

    return asked_twice(clerk, rung, Batch(request.claims, request.views), make, may_split=False)


def _claims(
    requirements: Requirements, stored: Judgements, found: dict[str, tuple[Sighted, Answered]]
) -> tuple[list[ClaimJudgement], list[ClaimJudgement]]:
    """All claims with the fresh answers in the place of the stored ones; what is made of others is made anew."""
    known = {
        claim.claim: _with(claim, found.get(claim.claim))
        for claim in (*stored.claims, *stored.beneath)
        if claim.stage != "combined"
    }
    lost = found.keys() - known.keys()
    if lost:
        raise BadInput(f"these judgements hold no claim {min(lost)!r} of their schedule", todo="judge the trial again")
    for claim in stored.claims:
        combined(requirements, claim.claim, known)
    return [known[claim.claim] for claim in stored.claims], [
        known[claim.claim] for claim in stored.beneath if claim.claim in known
    ]


def _with(claim: ClaimJudgement, found: tuple[Sighted, Answered] | None) -> ClaimJudgement:
    if found is None:
        return claim
    kept = ("claim", "actors", "measures", "seen_actors")
    return ClaimJudgement.model_validate({**{name: getattr(claim, name) for name in kept}, **told_by(*found)})
