"""Stages that take no time: each writes at once what the next ones and the warehouse read of it."""

from __future__ import annotations

import json
import random
from functools import partial
from typing import Any

from bench.scored_run import made_verdict
from c4s.files import digest_file
from c4s.protocol.rules import GATE
from c4s.records.attempt import AttemptOutcome
from c4s.records.plan import Plan
from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.run.drive import Persist, Run, store
from c4s.run.limits import Stage
from c4s.run.plan import Trial
from c4s.run.pool import work
from c4s.run.stages import scored
from c4s.verify.registry import verifiers_of

CALLS = 20
"""Tool calls of an attempt's trajectory."""


def instant_functions(persist: Persist | None = None) -> Run:
    """Runs the stages in worker processes, as ``c4s.run.drive.stage_functions`` does; ``persist`` is the real one."""

    async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        if stage == "persist":
            return None if persist is None else await work(partial(store, persist), trial, plan)
        return await work(instant_stage, stage, trial, plan, *arguments)

    return run


def instant_stage(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
    """One stage; what it gives where the trial's program looks at it."""
    folder = trial.folder
    if stage == "attempt":
        attempt = folder.attempt(*arguments)
        attempt.root.mkdir(parents=True, exist_ok=True)
        calls = [
            {"event": "call", "call": number, "tool": "list_actors", "arguments": {}, "outcome": "ok", "counted": True}
            | {"request": f"r{number}"}
            for number in range(CALLS)
        ]
        attempt.trajectory.write_text("".join(json.dumps(call) + "\n" for call in calls))
        outcome = AttemptOutcome(attempt=1, ended_by="finished", submission=None, client="noop")
        outcome.write(attempt.outcome)
        return outcome
    elif stage == "integrity":
        gate = Verdict(verifier=GATE, status="valid", policy=plan.policy)
        gate.write(folder.verdict(GATE))
        gate.write(folder.attempt(*arguments).integrity)
    elif stage == "verify":
        rng = random.Random(f"{trial.name} {arguments}")
        made_verdict(arguments[0], rng).write(folder.verdict(arguments[0]))
    elif stage == "score":
        return _score(trial, plan)
    return True


def _score(trial: Trial, plan: Plan) -> TrialScore:
    folder = trial.folder
    names = [GATE, *(verifier.name for verifier in verifiers_of(trial.case.setting))]
    made = scored(trial, plan, 1, True, {name: Verdict.read(folder.verdict(name)) for name in names})
    read = {name: digest_file(path) for name, path in folder.verdicts.items()}
    made = made.model_copy(update={"verdicts": read})
    made.write(folder.score)
    return made
