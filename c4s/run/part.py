"""A part of a trial's work: what one work pool does of it before another one goes on.

The program of the trial is the same everywhere. A worker runs it with a ``do`` that does the stages of its own pool,
reads those that are on record, and hands the trial over at the first other one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

from c4s.errors import BadInput, C4SError
from c4s.records.evidence_digests import SEEN
from c4s.records.handover import Handover, WorkPool
from c4s.records.plan import Plan
from c4s.run.guards import StoppedByGuard
from c4s.run.limits import Kind, Stage
from c4s.run.plan import Trial
from c4s.run.pool import Pool
from c4s.run.trial import Do, HandedOver

KINDS: Final[dict[WorkPool, Kind]] = {"engines": "engine", "verifiers": "processor", "judges": "request"}
_POOLS: Final[dict[Kind, WorkPool]] = {kind: pool for pool, kind in KINDS.items()}


@dataclass(frozen=True)
class Part:
    """What a worker of a pool does of the trials that it is given.

    ``whole``: it finishes them, whatever the kind of their stages. A control opens an engine for what another pool's
    stage could not do, and the stage is then done where the control was.
    """

    part: str
    pool: WorkPool
    whole: bool = False

    def limited(self, do: Do, pool: Pool, trial: Trial, plan: Plan) -> Do:
        """``do`` for this pool's stages and for those on record; ``HandedOver`` at any other."""

        async def limited(stage: Stage, *arguments: Any) -> Any:
            kind = pool.limit(stage, trial, plan).kind
            if not self.whole and kind != KINDS[self.pool] and not on_record(stage, trial, plan, *arguments):
                raise HandedOver(_POOLS[kind], whole=stage == "control")
            return await do(stage, *arguments)

        return limited

    def note(self, trial: Trial, ended: Exception | None) -> None:
        """Put on record how this part ended for a trial."""
        made = Handover(part=self.part, ended="done")
        if isinstance(ended, HandedOver):
            made = Handover(part=self.part, ended="handed_over", pool=ended.pool, whole=ended.whole)
        elif isinstance(ended, StoppedByGuard):
            made = Handover(part=self.part, ended="stopped", line=ended.line())
        elif ended is not None:
            line = ended.line() if isinstance(ended, C4SError) else f"{type(ended).__name__}: {ended}"
            made = Handover(part=self.part, ended="pending", line=line, bad_input=isinstance(ended, BadInput))
        made.write(trial.folder.handover)


def on_record(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> bool:
    """Whether a stage would only read what it made before."""
    folder = trial.folder
    match stage, *arguments:
        case "attempt", int(number):
            return folder.attempt(number).done
        case "integrity", int(number):
            return folder.attempt(number).integrity.is_file()
        case ["look"]:
            return folder.evidence.digests(SEEN).is_file()
        case ["judge"]:
            return folder.judgements(plan.judge).is_file()
        case "verify", str(name):
            return folder.verdict(name).is_file()
        case ["score"]:
            return folder.score.is_file()
    return False
