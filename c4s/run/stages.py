"""The stages of a trial as plain functions. Each skips what is already done and writes its result file last.

The order is attempt, evidence, integrity; a second attempt only where the first left no valid submission; then the
verifiers of the setting; then the score. The files say what is done, so any stage can be repeated alone and a killed
run goes on where it stopped. A ``MachineryFault`` passes through: the trial stays pending.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c4s.errors import BadInput, MachineryFault
from c4s.files import append_json_line, digest_file, read_json
from c4s.home import packs_root
from c4s.protocol.settings import is_construction
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import RunFolder
from c4s.records.pack import Pack
from c4s.records.plan import Plan
from c4s.records.score import TrialScore
from c4s.records.suite import AgentCase, SuiteFolder, WithheldCase
from c4s.records.verdict import Verdict
from c4s.run.plan import Trial

ATTEMPTS = 2
SEMANTIC = ("detailed", "overview")


@dataclass(frozen=True)
class TrialInputs:
    """What the stages of a trial read of its suite."""

    case: AgentCase
    withheld: WithheldCase
    agent_folder: Path
    withheld_folder: Path
    packs: list[Path]


def inputs(trial: Trial) -> TrialInputs:
    """Open the case package and check that every pack is there with the frozen digest (``BadInput`` otherwise)."""
    suite = SuiteFolder(trial.suite)
    case = suite.agent_case(trial.case.case_id)
    folders = []
    for reference in case.packs:
        folder = packs_root() / reference.pack_id
        if not (folder / "pack.json").is_file():
            raise BadInput(
                f"pack {reference.pack_id!r} is missing", where=trial.case.case_id, todo=f"build it into {packs_root()}"
            )
        folders.append(folder)
    return TrialInputs(
        case=case,
        withheld=suite.withheld_case(case.case_id),
        packs=folders,
        agent_folder=suite.agent(case.case_id),
        withheld_folder=suite.withheld(case.case_id),
    )


def record_time(trial: Trial, stage: str, seconds: float) -> None:
    """Append a stage's duration to the trial's ``stages.jsonl``."""
    append_json_line(trial.folder.root / "stages.jsonl", {"stage": stage, "seconds": round(seconds, 4)})


@contextmanager
def timed(trial: Trial, stage: str) -> Iterator[None]:
    """Record how long the block took."""
    started = time.perf_counter()
    yield
    record_time(trial, stage, time.perf_counter() - started)


def _timed(trial: Trial, stage: str, started: float) -> None:
    record_time(trial, stage, time.perf_counter() - started)


def attempt(trial: Trial, number: int) -> AttemptOutcome:
    """Run attempt ``number`` (1 or 2), or read its outcome where it is already on record."""
    from c4s.run.attempt import run_attempt

    folder = trial.folder.attempt(number)
    if (folder / "outcome.json").is_file():
        return AttemptOutcome.read(folder / "outcome.json")
    started, given = time.perf_counter(), inputs(trial)
    outcome = run_attempt(
        given.case,
        given.agent_folder,
        trial.configuration,
        number,
        folder,
        given.packs,
        given.withheld_folder if trial.configuration.client == "oracle" else None,
        trial.run / "spending.jsonl",
        Plan.read(RunFolder(trial.run).plan).engine,
    )
    _timed(trial, f"attempt-{number}", started)
    return outcome


def integrity(trial: Trial, plan: Plan, number: int) -> bool:
    """Export evidence of an attempt's submission and gate it. True when the submission is valid.

    The retained attempt's evidence moves to the trial's ``evidence/``; an invalid one stays with its attempt.
    """
    from c4s.evidence.cameras import SIZE_PX, overview_cameras
    from c4s.evidence.collect import export_and_look
    from c4s.verify.integrity.verdict import ManifestDigests, content_actors, unloadable, verify_integrity

    attempt_folder = trial.folder.attempt(number)
    path = attempt_folder / "integrity.json"
    if path.is_file():
        return Verdict.read(path).status == "valid"
    outcome = AttemptOutcome.read(attempt_folder / "outcome.json")
    if outcome.submission is None:
        Verdict(verifier="integrity", status="invalid", policy=plan.policy, reason="no submission was saved").write(
            path
        )
        return False
    started, given = time.perf_counter(), inputs(trial)
    evidence = trial.folder.evidence
    authored = []
    if not is_construction(given.case.setting):
        authored = [{**view, **SIZE_PX} for view in read_json(given.withheld_folder / "cameras.json")["views"]]

    def cameras(snapshot: dict[str, Any]) -> list[dict[str, Any]]:
        """No picture of a scene that is invalid for its emptiness."""
        if content_actors(snapshot) < given.withheld.minimum_actors:
            return []
        return authored or overview_cameras(snapshot)

    try:
        export_and_look(
            engine=plan.engine,
            packs=given.packs,
            submission_content=attempt_folder / "submission",
            package=outcome.submission,
            out=evidence,
            cameras=cameras,
        )
    except BadInput as error:
        verdict = unloadable(error.line())
        verdict.write(trial.folder.verdict("integrity"))
        verdict.write(path)
        return False
    frozen = {reference.pack_id: reference.digest for reference in given.case.packs}
    scorer = {folder.name: Pack.read(folder / "pack.json").sha256() for folder in given.packs}
    verdict = verify_integrity(
        read_json(evidence / "snapshot.json"),
        read_json(evidence / "dependencies.json"),
        given.withheld.minimum_actors,
        ManifestDigests(frozen=frozen, scorer=scorer, submission=_submission_packs(attempt_folder)),
    )
    if verdict.status == "error":
        raise MachineryFault(verdict.reason, where=trial.name, todo="run the same command again")
    verdict = verdict.model_copy(update={"inputs": _digests(evidence, "snapshot.json", "dependencies.json")})
    verdict.write(trial.folder.verdict("integrity"))
    verdict.write(path)
    _timed(trial, f"integrity-{number}", started)
    return verdict.status == "valid"


def _submission_packs(attempt_folder: Path) -> dict[str, str]:
    """Pack digests that the engine of the attempt mounted, as the attempt recorded them."""
    found = read_json(attempt_folder / "manifest.json", what="attempt manifest")
    return {str(name): str(value) for name, value in found["packs"].items()}


def _digests(folder: Path, *names: str) -> dict[str, str]:
    return {name: digest_file(folder / name) for name in names if (folder / name).is_file()}


def retained(trial: Trial) -> int | None:
    """The first attempt with a valid submission, if any."""
    for number in range(1, ATTEMPTS + 1):
        path = trial.folder.attempt(number) / "integrity.json"
        if path.is_file() and Verdict.read(path).status == "valid":
            return number
    return None


def physics(trial: Trial, plan: Plan) -> Verdict:
    """Support and penetration of the retained submission."""
    from c4s.verify.physics.verdict import verify_physics

    def verify(given: TrialInputs, evidence: Path) -> Verdict:
        start = None
        if not is_construction(given.case.setting):
            start = read_json(given.withheld_folder / "input.snapshot.json")
        return verify_physics(given.case.setting, read_json(evidence / "snapshot.json"), start)

    return _verdict(trial, "physics", verify)


def repair(trial: Trial, plan: Plan) -> Verdict:
    """Repair F1 of the retained submission against the withheld truth."""
    from c4s.verify.repair import verify_repair

    def verify(given: TrialInputs, evidence: Path) -> Verdict:
        return verify_repair(
            given.withheld_folder / "input.snapshot.json",
            given.withheld_folder / "truth.snapshot.json",
            evidence / "snapshot.json",
        )

    return _verdict(trial, "repair", verify)


def semantic(trial: Trial, plan: Plan, verifier: str) -> Verdict:
    """Detailed or Overview Alignment of the retained submission by the plan's judge."""
    from c4s.verify.semantic.detailed import verify_detailed
    from c4s.verify.semantic.overview import verify_overview

    if plan.judge != "rule":
        raise MachineryFault(f"judge {plan.judge!r} is not available here", todo="use the offline judge `rule`")

    def verify(given: TrialInputs, evidence: Path) -> Verdict:
        path = given.withheld_folder / "requirements.bundle.json"
        bundle = read_json(path) if path.is_file() else None
        snapshot, facts = read_json(evidence / "snapshot.json"), catalog_facts(given.packs)
        captures = read_json(evidence / "captures" / "captures.json")
        if verifier == "overview":
            return verify_overview(bundle or given.case.prompt, snapshot, facts, captures)
        if bundle is None:
            return Verdict(
                verifier=verifier,
                status="not_evaluated",
                policy=plan.policy,
                reason="the case has no requirement bundle",
            )
        return verify_detailed(bundle, snapshot, facts, captures)

    return _verdict(trial, verifier, verify)


def catalog_facts(packs: list[Path]) -> dict[str, dict[str, Any]]:
    """What the judge may know of assets: path to name, category, tags, description and slot materials."""
    facts: dict[str, dict[str, Any]] = {}
    for folder in packs:
        pack = Pack.read(folder / "pack.json")
        materials = {material.path: material.plain() for material in pack.materials}
        for asset in pack.assets:
            facts[asset.path] = {
                "name": asset.name,
                "category": asset.category,
                "tags": asset.tags,
                "description": asset.description,
                "size_m": list(asset.size_m),
                "materials": [materials[slot.material] for slot in asset.slots if slot.material in materials],
            }
    return facts


def _verdict(trial: Trial, verifier: str, verify: Any) -> Verdict:
    path = trial.folder.verdict(verifier)
    if path.is_file():
        return Verdict.read(path)
    started = time.perf_counter()
    verdict: Verdict = verify(inputs(trial), trial.folder.evidence)
    verdict.write(path)
    _timed(trial, verifier, started)
    return verdict


def needed(trial: Trial) -> tuple[str, ...]:
    """Verifiers of the trial's setting beyond integrity."""
    return ("physics", *SEMANTIC) if is_construction(trial.case.setting) else ("physics", "repair")


def score(trial: Trial, plan: Plan) -> TrialScore:
    """The trial's score from its verdicts; zero with its reason where no attempt left a valid submission."""
    from c4s.score.case import case_score

    path = trial.folder.score
    if path.is_file():
        return TrialScore.read(path)
    started, kept = time.perf_counter(), retained(trial)
    verdicts = {"integrity": [Verdict.read(p) for p in sorted(trial.folder.root.glob("attempt-*/integrity.json"))][-1]}
    if kept is not None:
        verdicts |= {name: Verdict.read(trial.folder.verdict(name)) for name in needed(trial)}
    submitted = any(AttemptOutcome.read(p).submission for p in trial.folder.root.glob("attempt-*/outcome.json"))
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
    if made.status == "pending":
        raise MachineryFault(made.reason, where=trial.name, todo="run the same command again")
    made.write(path)
    _timed(trial, "score", started)
    return made
