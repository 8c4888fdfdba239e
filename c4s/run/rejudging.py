"""A trial's stored evidence judged anew, aside from its record: how far the score depends on the judge's day."""

from __future__ import annotations

import tempfile
from pathlib import Path

from c4s.errors import MachineryFault
from c4s.judge.registry import make_judgements
from c4s.protocol.rules import GATE
from c4s.records.plan import Plan
from c4s.records.verdict import Verdict
from c4s.run.check import judged_digests
from c4s.run.inputs import evidence_in, inputs
from c4s.run.plan import Trial
from c4s.run.stages import evidence, retained, scored
from c4s.verify.registry import make_verdict, verifiers_of


def judged_anew(trial: Trial, plan: Plan) -> float:
    """The score from fresh judgements of the stored evidence.

    Nothing of the trial's record is changed. Verdicts that need no judgement are the stored ones.
    """
    kept = retained(trial)
    if kept is None:
        raise MachineryFault("there is no valid submission to judge", where=trial.name)
    given = inputs(trial)
    with tempfile.TemporaryDirectory(prefix="c4s-judged-") as name:
        judgements = Path(name) / trial.folder.judgements(plan.judge).name
        make_judgements(plan.judge, evidence(trial, plan, given)).write(judgements)
        shown = evidence_in(trial.folder.evidence, given, judgements, judged_digests(trial.folder))
        verdicts = {GATE: Verdict.read(trial.folder.verdict(GATE))}
        for verifier in verifiers_of(trial.case.setting):
            fresh = "judgements" in verifier.needs
            verdicts[verifier.name] = (
                make_verdict(verifier.name, shown) if fresh else Verdict.read(trial.folder.verdict(verifier.name))
            )
    made = scored(trial, plan, kept, True, verdicts)
    if made.status == "pending" or made.score is None:
        raise MachineryFault(made.reason or "the repeat has no score", where=trial.name)
    return made.score
