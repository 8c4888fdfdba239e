"""A trial's files against its plan: what evidence, judgements, verdicts and score say of themselves.

A difference is a fault of the machinery: nothing is scored or ranked under a name that did not make it.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from c4s.errors import MachineryFault
from c4s.files import read_json
from c4s.records.judgement import Judgements
from c4s.records.plan import Plan
from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.run.plan import Trial

Said = tuple[Path, str, object, object]
"""A file, a label, what the file says, and what the plan wants."""


def check_agreement(trial: Trial, plan: Plan) -> None:
    """``MachineryFault`` for the first file of a trial that was made under another label than the plan's."""
    for path, label, said, wanted in _labels(trial, plan):
        if said != wanted:
            raise MachineryFault(
                f"made under {label} {said!r}, and the plan's is {wanted!r}",
                where=str(path),
                todo="move the trial's folder away and run the same command again",
            )


def _labels(trial: Trial, plan: Plan) -> Iterator[Said]:
    folder = trial.folder
    for attempt in folder.attempts():
        if attempt.manifest.is_file():
            yield attempt.manifest, "engine", read_json(attempt.manifest).get("engine"), plan.engine
    if folder.evidence.snapshot.is_file():
        own = read_json(folder.evidence.snapshot).get("c4s") or {}
        yield folder.evidence.snapshot, "engine", own.get("engine"), plan.engine
    if folder.evidence.captures_index.is_file():
        yield folder.evidence.captures_index, "engine", read_json(folder.evidence.captures_index)["engine"], plan.engine
    judgements = folder.judgements(plan.judge)
    if judgements.is_file():
        said = Judgements.read(judgements)
        yield judgements, "judge", said.judge, plan.judge
        if plan.judge_version:
            yield judgements, "judge version", said.judge_version, plan.judge_version
    for name, path in folder.verdicts.items():
        verdict = Verdict.read(path)
        yield path, "verifier", verdict.verifier, name
        yield path, "judge", verdict.measurements.get("judge", plan.judge), plan.judge
        if plan.judge_version:
            version = verdict.measurements.get("judge_version", plan.judge_version)
            yield path, "judge version", version, plan.judge_version
    if folder.score.is_file():
        score = TrialScore.read(folder.score)
        yield folder.score, "engine", score.engine, plan.engine
        yield folder.score, "judge", score.judge, plan.judge
        yield folder.score, "policy", score.policy, plan.policy
        yield folder.score, "configuration", score.configuration, trial.configuration.name
        yield folder.score, "case", (score.case_id, score.repeat), (trial.case.case_id, trial.repeat)
