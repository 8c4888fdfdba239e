"""The stages of a trial as plain functions. Each skips what is already done and writes its result file last.

Their order is the trial's (``c4s.run.trial``). The files say what is done, so any stage can be repeated alone and a
killed run goes on where it stopped. A ``MachineryFault`` passes through: the trial stays pending.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from typing import Any

from c4s.errors import MachineryFault
from c4s.files import append_json_line, digest_file, read_json, write_json
from c4s.protocol.baselines import ORACLE
from c4s.protocol.rules import DEFAULT_POLICY, GATE, NO_SUBMISSION
from c4s.records.attempt import AttemptOutcome
from c4s.records.evidence import Evidence, ManifestDigests
from c4s.records.evidence_digests import EXPORTED, SEEN, note_digests
from c4s.records.folder import AttemptFolder, RunFolder
from c4s.records.judgement import Judgements
from c4s.records.pack import Pack
from c4s.records.plan import Plan
from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.run.check import LISTING, check_submission, judged_digests, noted_digests
from c4s.run.desk import desk
from c4s.run.faults import of_machinery
from c4s.run.inputs import TrialInputs, evidence_in, inputs, offered
from c4s.run.limits import Stage
from c4s.run.plan import Trial
from c4s.verify.registry import make_verdict, measure, verifier_named, verifiers_of

ATTEMPTS = 2


def record_time(trial: Trial, stage: str, seconds: float) -> None:
    """Append a stage's duration to the trial's stage times."""
    append_json_line(trial.folder.stages, {"stage": stage, "seconds": round(seconds, 4)})


@contextmanager
def timed(trial: Trial, stage: str) -> Iterator[None]:
    """Record how long the block took."""
    started = time.perf_counter()
    yield
    record_time(trial, stage, time.perf_counter() - started)


def attempt(trial: Trial, plan: Plan, number: int) -> AttemptOutcome:
    """Run attempt ``number`` (1 or 2), or read its outcome where it is already on record."""
    from c4s.run.attempt import run_attempt

    folder = trial.folder.attempt(number)
    if folder.done:
        return AttemptOutcome.read(folder.outcome)
    with timed(trial, f"attempt-{number}"):
        given = inputs(trial)
        return run_attempt(
            given.case,
            given.agent_folder,
            trial.working,
            number,
            folder.root,
            given.packs,
            given.withheld_folder.root if trial.working.client == ORACLE else None,
            RunFolder(trial.run).spending,
            plan.engine,
        )


def integrity(trial: Trial, plan: Plan, number: int) -> bool:
    """Export evidence of an attempt's submission and gate it. True when the submission is valid.

    The engine that exported a valid scene takes its pictures too, before it ends: it holds the scene already. Where it
    was cut off, ``look`` takes them. ``SceneUnreadable`` where it does not load, export or draw the scene.
    """
    from c4s.evidence import open_clean
    from c4s.run.looking import cameras_for

    folder = trial.folder.attempt(number)
    if folder.integrity.is_file():
        return Verdict.read(folder.integrity).status == "valid"
    outcome = AttemptOutcome.read(folder.outcome)
    if outcome.submission is None:
        missing = Verdict(
            verifier=GATE,
            status="invalid",
            policy=plan.policy,
            measurements={"reason_code": NO_SUBMISSION},
            reason="no submission was saved",
        )
        missing.write(folder.integrity)
        return False
    given = inputs(trial)
    check_submission(folder, outcome)
    with ExitStack() as engine:
        with timed(trial, f"integrity-{number}"):
            clean = engine.enter_context(
                open_clean(
                    engine=plan.engine,
                    packs=given.packs,
                    submission_content=folder.submission,
                    package=outcome.submission,
                    offered=offered(given.case, given.agent_folder),
                )
            )
            clean.export(trial.folder.evidence.root)
            verdict = _gated(trial, plan, given, folder)
            verdict.write(trial.folder.verdict(GATE))
            verdict.write(folder.integrity)
        if verdict.status == "valid":
            with timed(trial, "look"):
                clean.walk(trial.folder.evidence.root)
                clean.look(trial.folder.evidence.root, cameras_for(given))
    return verdict.status == "valid"


def _gated(trial: Trial, plan: Plan, given: TrialInputs, folder: AttemptFolder) -> Verdict:
    """The gate's verdict on what was exported, with the digest of the list of it."""
    verdict = make_verdict(GATE, evidence(trial, plan, given, manifest=_manifest(given, folder)))
    if verdict.status == "error":
        raise MachineryFault(verdict.reason, where=trial.name, todo="run the same command again")
    listing = {LISTING: digest_file(trial.folder.evidence.digests(EXPORTED))}
    return verdict.model_copy(update={"inputs": verdict.inputs | listing})


def _manifest(given: TrialInputs, attempt_folder: AttemptFolder) -> ManifestDigests:
    """Pack digests as the suite froze them, as the evaluator has them, and as the attempt recorded them."""
    recorded = read_json(attempt_folder.manifest, what="attempt manifest")["packs"]
    return ManifestDigests(
        frozen={reference.pack_id: reference.digest for reference in given.case.packs},
        scorer={folder.name: Pack.read(folder / "pack.json").sha256() for folder in given.packs},
        submission={str(name): str(value) for name, value in recorded.items()},
    )


def evidence(trial: Trial, plan: Plan, given: TrialInputs, manifest: ManifestDigests | None = None) -> Evidence:
    """The files of a trial that its judge and its verifiers may read."""
    exported = trial.folder.evidence
    noted = noted_digests(exported) if manifest else judged_digests(trial.folder)
    return evidence_in(exported, given, trial.folder.judgements(plan.judge), noted, manifest)


def look(trial: Trial, plan: Plan) -> None:
    """Take the pictures of the retained submission, where they are not there: what a judge and pages show.

    Their list of digests is written last, so pictures without it are a part of what was being put there.
    """
    from c4s.evidence import collect
    from c4s.run.looking import cameras_for

    if trial.folder.evidence.digests(SEEN).is_file():
        return
    kept = retained(trial)
    if kept is None:
        raise MachineryFault("there is no valid submission to look at", where=trial.name)
    with timed(trial, "look"):
        given, folder = inputs(trial), trial.folder.attempt(kept)
        collect.look(
            engine=plan.engine,
            packs=given.packs,
            submission_content=folder.submission,
            package=str(AttemptOutcome.read(folder.outcome).submission),
            out=trial.folder.evidence.root,
            cameras=cameras_for(given),
            offered=offered(given.case, given.agent_folder),
        )


def retained(trial: Trial) -> int | None:
    """The first attempt with a valid submission, if any."""
    for folder in trial.folder.attempts():
        if folder.integrity.is_file() and Verdict.read(folder.integrity).status == "valid":
            return folder.number
    return None


def judge(trial: Trial, plan: Plan) -> Judgements:
    """What the plan's judge says of the retained submission, or what is on record of it."""
    from c4s.judge.registry import make_judgements

    path = trial.folder.judgements(plan.judge)
    if path.is_file():
        return Judgements.read(path)
    with timed(trial, "judge"):
        given = evidence(trial, plan, inputs(trial))
        made = make_judgements(plan.judge_configuration, given, desk(trial, plan))
        made.write(path)
    return made


def verify(trial: Trial, plan: Plan, name: str) -> Verdict:
    """A verifier's verdict on the retained submission, or the one on record."""
    path = trial.folder.verdict(name)
    if path.is_file():
        return Verdict.read(path)
    with timed(trial, name):
        given = inputs(trial)
        exported = evidence(trial, plan, given)
        made = measure(name, exported)
        for measured, record in made.items():
            write_json(exported.path(measured), record, indent=None)
        if made:
            note_digests(
                trial.folder.evidence, verifier_named(name).maker, [exported.path(measured) for measured in made]
            )
            exported = evidence(trial, plan, given)
        verdict = make_verdict(name, exported)
        verdict.write(path)
    return verdict


def control(trial: Trial, plan: Plan, stage: Stage, *arguments: Any) -> None:
    """Do what a stage does, for the case's own start level: what fails there too is not the scene's fault.

    ``BadInput`` where the case or a pack is not as it was frozen, ``MachineryFault`` for all else that fails.
    """
    from c4s.run.control import same_for_the_start_level

    with timed(trial, "control"):
        given = inputs(trial)
        try:
            same_for_the_start_level(trial, plan, given, stage, *arguments)
        except Exception as error:
            told = of_machinery(error, where=trial.name)
            raise MachineryFault(
                f"{stage} fails on the case's own start level too: {told.what}",
                where=told.where or trial.name,
                todo=told.todo or "run the same command again",
            ) from error


def score(trial: Trial, plan: Plan) -> TrialScore:
    """The trial's score from its verdicts; zero with its reason where no attempt left a valid submission."""
    from c4s.run.labels import check_agreement

    check_agreement(trial, plan)
    path = trial.folder.score
    if path.is_file():
        return TrialScore.read(path)
    with timed(trial, "score"):
        kept, attempts = retained(trial), trial.folder.attempts()
        verdicts = {GATE: Verdict.read([folder for folder in attempts if folder.integrity.is_file()][-1].integrity)}
        if kept is not None:
            names = [verifier.name for verifier in verifiers_of(trial.case.setting)]
            verdicts |= {name: Verdict.read(trial.folder.verdict(name)) for name in names}
        submitted = any(AttemptOutcome.read(folder.outcome).submission for folder in attempts)
        made = scored(trial, plan, kept, submitted, verdicts)
        if made.status == "pending":
            raise MachineryFault(made.reason, where=trial.name, todo="run the same command again")
        read = {name: digest_file(verdict) for name, verdict in trial.folder.verdicts.items()}
        made = made.model_copy(update={"verdicts": read})
        made.write(path)
    return made


def scored(trial: Trial, plan: Plan, kept: int | None, submitted: bool, verdicts: dict[str, Verdict]) -> TrialScore:
    """The score that verdicts give under the plan's policy; nothing is read or written.

    Args:
        trial: the trial.
        plan: the run's plan.
        kept: number of the retained attempt, if any.
        submitted: whether any attempt saved a submission.
        verdicts: by verifier.
    """
    from c4s.score.case import case_score
    from c4s.score.policies import policy_named
    from c4s.score.rescore import rescored

    made = case_score(
        case_id=trial.case.case_id,
        setting=trial.case.setting,
        repeat=trial.repeat,
        configuration=trial.configuration.name,
        policy=plan.policy,
        judge=plan.judge,
        engine=plan.engine,
        retained_attempt=kept,
        submitted=submitted,
        verdicts=verdicts,
    )
    return made if plan.policy == DEFAULT_POLICY else rescored(made, verdicts, policy_named(plan.policy))
