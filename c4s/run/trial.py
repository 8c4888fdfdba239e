"""A whole trial in this process, stage by stage, without a scheduler."""

from __future__ import annotations

from c4s.records.plan import Plan
from c4s.records.score import TrialScore
from c4s.run import stages
from c4s.run.plan import Trial
from c4s.verify.registry import is_judged, verifiers_of


def run_trial(trial: Trial, plan: Plan) -> TrialScore:
    """Attempt (a second one only without a valid submission), evidence, integrity, judgements, verifiers, score.

    Stages that are done are read. A ``MachineryFault`` passes through and leaves the trial pending.
    """
    for number in range(1, stages.ATTEMPTS + 1):
        stages.attempt(trial, plan, number)
        if stages.integrity(trial, plan, number):
            stages.look(trial, plan)
            if is_judged(trial.case.setting):
                stages.judge(trial, plan)
            for verifier in verifiers_of(trial.case.setting):
                stages.verify(trial, plan, verifier.name)
            break
    return stages.score(trial, plan)
