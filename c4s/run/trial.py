"""A whole trial in this process, stage by stage, without a scheduler."""

from __future__ import annotations

from c4s.records.plan import Plan
from c4s.records.score import TrialScore
from c4s.run import stages
from c4s.run.plan import Trial


def run_trial(trial: Trial, plan: Plan) -> TrialScore:
    """Attempt (a second one only without a valid submission), evidence, integrity, verifiers, score.

    Stages that are done are read. A ``MachineryFault`` passes through and leaves the trial pending.
    """
    for number in range(1, stages.ATTEMPTS + 1):
        stages.attempt(trial, number)
        if stages.integrity(trial, plan, number):
            break
    if stages.retained(trial) is not None:
        verify = {"physics": stages.physics, "repair": stages.repair}
        for name in stages.needed(trial):
            if name in stages.SEMANTIC:
                stages.semantic(trial, plan, name)
            else:
                verify[name](trial, plan)
    return stages.score(trial, plan)
