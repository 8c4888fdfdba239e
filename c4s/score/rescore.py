"""Scoring stored verdicts again under another policy, and telling what that changes. Stored files are only read.

Each verdict keeps what its score was made of: the physics leaves, the decided requirement rows, the repair counts of
each tolerance profile. From these the components are made again by the same functions that made them first.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Any

from c4s.errors import BadInput
from c4s.protocol.numbers import mean
from c4s.protocol.rules import GATE
from c4s.protocol.settings import Setting
from c4s.records.folder import RunFolder, TrialFolder
from c4s.records.plan import Plan
from c4s.records.policy import ScorePolicy
from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.score.case import case_score
from c4s.verify.registry import verifier_named, weighed_of


@dataclass(frozen=True, slots=True)
class Delta:
    """One component of a trial that a policy changes."""

    trial: str
    setting: str
    component: str
    before: float | None
    after: float | None

    def plain(self) -> dict[str, Any]:
        """As JSON data."""
        return {
            "trial": self.trial,
            "setting": self.setting,
            "component": self.component,
            "from": self.before,
            "to": self.after,
        }


def under(verdict: Verdict, policy: ScorePolicy, setting: Setting) -> Verdict:
    """A measured verdict with the score that its stored measurements have under a policy.

    Raises ``BadInput`` when the measurements are not there.
    """
    if verdict.status != "measured":
        return verdict
    again = verifier_named(verdict.verifier).score_under
    if again is None:
        return verdict
    try:
        score, measurements = again(verdict, policy, setting)
    except (KeyError, TypeError) as error:
        raise BadInput(
            f"{verdict.verifier} verdict has no {error} among its measurements", todo="verify the trial again"
        ) from None
    status = "not_evaluated" if score is None else verdict.status
    return verdict.model_copy(update={"status": status, "score": score, "measurements": measurements})


def rescored(stored: TrialScore, verdicts: Mapping[str, Verdict], policy: ScorePolicy) -> TrialScore:
    """A trial's score under a policy, from its stored score and its verdicts. A zero by rule stays a zero."""
    if stored.status.startswith("zero_"):
        return stored.model_copy(update={"policy": policy.policy_id})
    return case_score(
        case_id=stored.case_id,
        setting=stored.setting,
        configuration=stored.configuration,
        repeat=stored.repeat,
        judge=stored.judge,
        engine=stored.engine,
        submitted=True,
        retained_attempt=stored.retained_attempt,
        verdicts={name: under(verdict, policy, stored.setting) for name, verdict in verdicts.items()},
        policy=policy.policy_id,
        weights=policy.weights(stored.setting),
    )


def read_verdicts(folder: TrialFolder, stored: TrialScore) -> dict[str, Verdict]:
    """The verdicts that a stored score was made from; none for a zero by rule."""
    if stored.status.startswith("zero_"):
        return {}
    names = (GATE, *(verifier.name for verifier in weighed_of(stored.setting)))
    return {name: Verdict.read(folder.verdict(name)) for name in names}


def _numbers(score: TrialScore) -> dict[str, float | None]:
    """What a policy may change of a trial: its components, and its score last."""
    return {**score.components, "score": score.score}


@dataclass(frozen=True, slots=True)
class Rescoring:
    """All trials of a run under a policy, beside what is stored."""

    run_id: str
    policy: ScorePolicy
    pairs: list[tuple[str, TrialScore, TrialScore]]
    """Trial name, stored score, new score."""
    pending: list[str]
    """Trials without a stored score: they have no number to compare."""

    def deltas(self) -> Iterator[Delta]:
        """Every component that differs, trial by trial."""
        for name, old, new in self.pairs:
            befores, afters = _numbers(old), _numbers(new)
            for component, before in befores.items():
                if before != (after := afters.get(component)):
                    yield Delta(name, old.setting, component, before, after)

    def means(self) -> list[dict[str, Any]]:
        """Mean case score by configuration and setting, stored and new. Trials that are pending are not in it."""
        groups: dict[tuple[str, str], list[tuple[float, float]]] = {}
        for _, old, new in self.pairs:
            if old.score is not None and new.score is not None:
                groups.setdefault((old.configuration, old.setting), []).append((old.score, new.score))
        return [
            {
                "configuration": configuration,
                "setting": setting,
                "trials": len(scores),
                "from": mean(before for before, _ in scores),
                "to": mean(after for _, after in scores),
            }
            for (configuration, setting), scores in sorted(groups.items())
        ]

    def report(self) -> dict[str, Any]:
        """The delta report as JSON data."""
        changed = [delta.plain() for delta in self.deltas()]
        return {
            "schema_version": "c4s.rescoring.v1",
            "run_id": self.run_id,
            "policy": self.policy.plain(),
            "stored_policies": sorted({old.policy for _, old, _ in self.pairs}),
            "trials": len(self.pairs),
            "changed_trials": len({delta["trial"] for delta in changed}),
            "pending": self.pending,
            "means": self.means(),
            "deltas": changed,
        }


def rescore(run: Path, policy: ScorePolicy) -> Rescoring:
    """Score the stored verdicts of a run folder under a policy.

    Raises ``BadInput`` for a folder without a plan and for a verdict that is missing or cannot be read.
    """
    folder = RunFolder(run)
    plan = Plan.read(folder.plan)
    pairs, pending = [], []
    for case, configuration, repeat in product(plan.cases, plan.configurations, range(1, plan.repeats + 1)):
        trial = folder.trial(configuration.name, case.alias, repeat)
        name = f"{configuration.name}/{case.case_id}/r{repeat}"
        if not trial.score.is_file():
            pending.append(name)
            continue
        stored = TrialScore.read(trial.score)
        try:
            new = rescored(stored, read_verdicts(trial, stored), policy)
        except BadInput as error:
            raise BadInput(error.line(), where=name) from None
        pairs.append((name, stored, new))
    return Rescoring(plan.run_id, policy, pairs, pending)
