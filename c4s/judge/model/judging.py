"""What a model judge writes down: a judgement of every claim, of the scene as a whole, and of a repair beside its
truth."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from c4s.judge.desk import Desk
from c4s.judge.model.clerk import Clerk
from c4s.judge.model.contract import WHOLE
from c4s.judge.model.ladder import Ladder
from c4s.judge.model.overview import judge_overview
from c4s.judge.model.paired import judge_pairs
from c4s.judge.model.requests import Writer
from c4s.judge.model.rungs import Rungs
from c4s.judge.model.sights import Sights
from c4s.judge.model.version import model_version
from c4s.protocol.bundle import read_requirements
from c4s.protocol.settings import is_construction
from c4s.records.evidence import Evidence
from c4s.records.judge import JudgeConfiguration
from c4s.records.judgement import OF_CLAIMS, Asked, ClaimJudgement, Judgements
from c4s.semantics.binding import binding_of
from c4s.semantics.state import StateDecider
from c4s.semantics.views import read_views


def judge_by_model(configuration: JudgeConfiguration, evidence: Evidence, desk: Desk) -> Judgements:
    """Judge a submission by a model, above what its state decides.

    Raises ``BadInput`` for a bundle that cannot be read and for an endpoint that is not described, ``ChatFailed``
    where the model does not answer, ``SpendingLimitReached`` at a limit of the run. Then nothing is written but the
    answers so far.
    """
    writer = Writer(configuration)
    with Clerk(configuration, desk) as clerk:
        if is_construction(evidence.setting):
            made = _construction(evidence, writer, clerk, desk)
        else:
            made = _repair(evidence, writer, clerk, desk)
        return Judgements.model_validate(
            {
                "judge": configuration.name,
                "kind": configuration.kind,
                "judge_version": model_version(configuration),
                "usage": clerk.usage.model_copy(update={"requests": len(made["schedule"])}),
                "served": clerk.served,
                **made,
                "accepted_faults": [*clerk.faults, *_broken_twice(made["schedule"])],
            }
        )


def _broken_twice(schedule: Sequence[Asked]) -> list[str]:
    """The calls over the whole scene and over pairs whose second answer broke its contract too; of a claim that is a
    fallback."""
    return [
        f"{asked.purpose}: {asked.broken[WHOLE]}"
        for asked in schedule
        if asked.purpose not in OF_CLAIMS and asked.again and WHOLE in asked.broken
    ]


def _construction(evidence: Evidence, writer: Writer, clerk: Clerk, desk: Desk) -> dict[str, Any]:
    captures = evidence.json("captures")
    sights = Sights(evidence, captures)
    claims: list[ClaimJudgement] = []
    beneath: list[ClaimJudgement] = []
    schedule: list[Asked] = []
    if evidence.has("requirements"):
        requirements = read_requirements(evidence.json("requirements"))
        catalog = evidence.catalog()
        binding = binding_of(requirements, catalog, evidence.json("binding") if evidence.has("binding") else None)
        decider = StateDecider(requirements, evidence.json("candidate_snapshot"), catalog, binding)
        rungs = Rungs(requirements, sights, writer, clerk)
        claims, beneath = Ladder(decider, sights, rungs, read_views(captures)).judged()
        schedule = rungs.schedule
    overview = judge_overview(evidence.prompt, sights, writer, clerk, accept_faults=desk.accept_faults)
    schedule = [*schedule, *overview.schedule]
    return {
        "claims": claims,
        "beneath": beneath,
        "overview": overview.judgement,
        "overview_reason": overview.reason,
        "paired_reason": "a construction has no truth to compare it with",
        "schedule": schedule,
        "pictures": sights.digests({name for asked in schedule for name in asked.views}),
    }


def _repair(evidence: Evidence, writer: Writer, clerk: Clerk, desk: Desk) -> dict[str, Any]:
    paired, reason, schedule = judge_pairs(evidence, writer, clerk, accept_faults=desk.accept_faults)
    shown = {name for asked in schedule for name in asked.views}
    files = {
        str(view["name"]): evidence.digests[f"captures/{view['file']}"]
        for view in evidence.json("captures").get("views") or []
        if view["name"] in shown
    }
    return {
        "claims": [],
        "overview_reason": "a repair has no overview",
        "paired": paired,
        "paired_reason": reason,
        "schedule": schedule,
        "pictures": files,
    }
