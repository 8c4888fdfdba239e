"""Stored evidence verified, or judged and verified, once more; what was made before is set aside and kept."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from c4s.errors import BadInput
from c4s.protocol.rules import GATE
from c4s.records.plan import Plan
from c4s.records.score import TrialScore
from c4s.run.aside import aside
from c4s.run.plan import Trial
from c4s.run.stages import retained
from c4s.verify.registry import verifiers_of

Again = Literal["verdicts", "judgements"]
_WHAT = "outdated"


@dataclass(frozen=True)
class ScoreChange:
    """A trial's score before and after; null where it has none."""

    trial: str
    before: float | None
    after: float | None

    @property
    def changed(self) -> bool:
        """Whether it is another one."""
        return self.before != self.after


def stored_score(trial: Trial) -> float | None:
    """The score on record; null where there is none."""
    try:
        return TrialScore.read(trial.folder.score).score
    except BadInput:
        return None


def set_back(trial: Trial, plan: Plan, again: Again) -> list[str]:
    """Set aside the verdicts of a trial with evidence, and its judgements too where asked; what was, a line each.

    For the holder of the trial. A trial without a valid submission keeps its score: there is nothing to look at.
    """
    if retained(trial) is None:
        return []
    made = [trial.folder.verdict(verifier.name) for verifier in verifiers_of(trial.case.setting)]
    if again == "judgements":
        made.append(trial.folder.judgements(plan.judge))
    lines = [aside(path, _WHAT, "it is made anew") for path in made if path.is_file() and path.stem != GATE]
    if lines and trial.folder.score.is_file():
        lines.append(aside(trial.folder.score, _WHAT, "what it was made from is made anew"))
    return lines
