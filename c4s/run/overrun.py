"""What is put on record where a scene made a stage fail: the agent's outcome, never a pending trial."""

from __future__ import annotations

from c4s.folders import remove_tree
from c4s.protocol.rules import GATE
from c4s.records.attempt import AttemptOutcome
from c4s.records.captures import Captures
from c4s.records.evidence_digests import SEEN, note_digests
from c4s.records.plan import Plan
from c4s.records.verdict import Verdict
from c4s.run.faults import SceneFault
from c4s.run.plan import Trial
from c4s.run.stages import retained
from c4s.verify.integrity.verdict import refused


def write_invalid(trial: Trial, number: int, reason: SceneFault) -> None:
    """The gate's verdict on an attempt whose submission cannot be exported or checked."""
    verdict = refused(reason.code, reason.line())
    verdict.write(trial.folder.verdict(GATE))
    verdict.write(trial.folder.attempt(number).integrity)


def write_not_looked(trial: Trial, plan: Plan, reason: SceneFault) -> None:
    """Captures without a view, marked with why none was taken."""
    evidence, kept = trial.folder.evidence, retained(trial)
    remove_tree(evidence.captures, inside=evidence.root, at_best=True)
    package = AttemptOutcome.read(trial.folder.attempt(kept or 1).outcome).submission
    Captures(engine=plan.engine, package=package, not_taken=f"{reason.code}: {reason.line()}").write(
        evidence.captures_index
    )
    note_digests(evidence, SEEN, [evidence.captures_index])


def write_not_evaluated(trial: Trial, plan: Plan, verifier: str, reason: SceneFault) -> None:
    """A verifier's verdict without a score, worth zero at its full weight."""
    Verdict(
        verifier=verifier,
        status="not_evaluated",
        policy=plan.policy,
        measurements={"reason_code": reason.code},
        reason=f"{reason.code}: {reason.line()}",
    ).write(trial.folder.verdict(verifier))
