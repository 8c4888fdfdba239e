"""The row of the paired views (paper, Judge configuration; rubric ``visual-gt-paired``). It has no weight."""

from __future__ import annotations

from collections.abc import Iterator

from c4s.protocol.paired import PAIRED_BLEND, PAIRED_POLICY, PAIRED_WEIGHTS, SAID
from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR
from c4s.records.evidence import Evidence
from c4s.records.judgement import Judgements
from c4s.records.verdict import Verdict
from c4s.verify.faults import accepted_faults
from c4s.verify.verifier import Components, Finding, Verifier, dotted, shares


def verify_paired(judgements: Judgements) -> Verdict:
    """What a judge said of the pairs of views. Without a pair it is not evaluated.

    ``taken`` names the parts of each dimension that were there: a judge without a model has measures alone, and no
    capture holds base colours.
    """
    made = {"judge": judgements.judge, "judge_version": judgements.judge_version}
    said = judgements.paired
    if said is None:
        return Verdict(
            verifier=PAIRED.name,
            status="not_evaluated",
            policy=PAIRED_POLICY,
            measurements=made,
            advisories=accepted_faults(judgements),
            reason=judgements.paired_reason or "this judge compares no views",
        )
    parts = {part for view in said.views for part in view.measures}
    parts |= {SAID for view in said.views if view.said}
    return Verdict(
        verifier=PAIRED.name,
        status="measured",
        score=said.score,
        policy=PAIRED_POLICY,
        advisories=accepted_faults(judgements),
        measurements={
            **made,
            "dimensions": said.dimensions,
            "views": [view.plain() for view in said.views],
            "taken": {name: [part for part in blend if part in parts] for name, blend in PAIRED_BLEND.items()},
        },
        population={"views": len(said.views), "by_model": sum(bool(view.said) for view in said.views)},
    )


def _verify(evidence: Evidence) -> Verdict:
    return verify_paired(Judgements.opened(evidence.json("judgements"), where=str(evidence.path("judgements"))))


def _components(verdict: Verdict) -> Components:
    return dotted("dimensions", shares(verdict.measurements.get("dimensions", {}), PAIRED_WEIGHTS))


def _findings(verdict: Verdict) -> Iterator[Finding]:
    for view in verdict.measurements.get("views", []):
        told = ", ".join(f"{name} {value:.2f}" for name, value in view["dimensions"].items())
        yield Finding(str(view["pair"]), told, str(view["reason"]))


PAIRED = Verifier(
    name="paired",
    title="Paired views",
    settings=(INDOOR_REPAIR, OUTDOOR_REPAIR),
    needs=frozenset({"judgements"}),
    verify=_verify,
    parts=_components,
    findings=_findings,
)
