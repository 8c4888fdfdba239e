"""From a run folder to rows. The warehouse is derived: ingesting again gives the same files."""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from PIL import Image

from c4s.files import canonical_json, digest_file, json_lines, read_json
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan
from c4s.records.score import TrialScore
from c4s.records.suite import SuiteFolder, WithheldFolder
from c4s.records.verdict import Verdict
from c4s.run.check import check_evidence
from c4s.run.configurations import is_ranked
from c4s.run.plan import Trial, trial_id, trials
from c4s.verify.registry import verifier_named
from warehouse.behaviour import attempt_rows, submission_rows, tool_use_rows
from warehouse.components import component_rows
from warehouse.parquet import part_path, write_part
from warehouse.records import HEADLINES, AttemptRow, FindingRow, OutcomeRow, PictureRow, ScheduleRow, VerdictRow

PICTURE_WIDTH = 960
CASE_PARTITION = "_case"
"""Partition of pictures that belong to a case, not to a configuration."""


def ingest_schedule(run: Path, suite: Path, plan: Plan, warehouse: Path) -> None:
    """Write one row a planned trial, and the pictures of each case."""
    folder = SuiteFolder(suite)
    for case in plan.cases:
        agent, withheld = folder.agent_case(case.case_id), folder.withheld_case(case.case_id)
        for trial in trials(run, suite, plan.model_copy(update={"cases": [case]})):
            chosen = trial.configuration
            row = ScheduleRow(
                trial_id=trial_id(plan, trial),
                run_id=plan.run_id,
                suite=plan.suite_id,
                suite_digest=plan.suite_digest,
                configuration=chosen.name,
                client=chosen.client,
                model=chosen.model,
                case_id=case.case_id,
                title=agent.title,
                prompt=agent.prompt,
                setting=case.setting,
                scene_id=case.scene_id,
                repeat=trial.repeat,
                operations=" ".join(withheld.operations),
                operation_group=withheld.operation_group,
                difficulty=withheld.difficulty,
                proxy_assets=withheld.proxy_assets,
                policy=plan.policy,
                judge=plan.judge,
                engine=plan.engine,
                ranked=is_ranked(chosen),
            )
            if not part_path(warehouse, "schedule", plan.suite_id, chosen.name, row.trial_id).is_file():
                write_part(
                    warehouse, "schedule", [row], suite=plan.suite_id, configuration=chosen.name, key=row.trial_id
                )
        key = f"{case.case_id}-{case.withheld_digest[:12]}"
        if not part_path(warehouse, "pictures", plan.suite_id, CASE_PARTITION, key).is_file():
            write_part(
                warehouse,
                "pictures",
                list(_case_pictures(folder, plan, case.case_id)),
                suite=plan.suite_id,
                configuration=CASE_PARTITION,
                key=key,
            )


def _case_pictures(folder: SuiteFolder, plan: Plan, case_id: str) -> Iterator[PictureRow]:
    for role in ("start", "truth"):
        for path in sorted(WithheldFolder(folder.withheld(case_id)).views(role).glob("*.png")):
            width, height, jpeg = _jpeg(path)
            yield PictureRow(
                trial_id="",
                run_id=plan.run_id,
                suite=plan.suite_id,
                configuration=CASE_PARTITION,
                case_id=case_id,
                repeat=0,
                role=role,
                view=path.stem,
                width=width,
                height=height,
                jpeg=jpeg,
            )


def _jpeg(path: Path) -> tuple[int, int, bytes]:
    """A picture as JPEG, at most ``PICTURE_WIDTH`` pixels wide."""
    with Image.open(path) as image:
        picture = image.convert("RGB")
        if picture.width > PICTURE_WIDTH:
            picture = picture.resize((PICTURE_WIDTH, round(picture.height * PICTURE_WIDTH / picture.width)))
        buffer = io.BytesIO()
        picture.save(buffer, "JPEG", quality=85)
        return picture.width, picture.height, buffer.getvalue()


def is_stored(trial: Trial, plan: Plan, warehouse: Path) -> bool:
    """Whether the trial's outcome row is there."""
    return part_path(warehouse, "outcomes", plan.suite_id, trial.configuration.name, trial_id(plan, trial)).is_file()


def ingest_trial(trial: Trial, plan: Plan, warehouse: Path) -> None:
    """Write all rows of a scored trial; the outcome row comes last, so that it stands for the whole."""
    key = _key(trial, plan)
    place: dict[str, str] = {"suite": plan.suite_id, "configuration": trial.configuration.name, "key": key["trial_id"]}
    verdicts = trial.folder.verdicts
    score = TrialScore.read(trial.folder.score)
    attempts = list(attempt_rows(trial, score, key))
    write_part(warehouse, "attempts", [row for row, _ in attempts], **place)
    write_part(warehouse, "tool_use", tool_use_rows(attempts, key), **place)
    write_part(warehouse, "python_submissions", submission_rows(attempts, key), **place)
    write_part(warehouse, "verdicts", [_verdict_row(path, key) for path in verdicts.values()], **place)
    write_part(warehouse, "components", list(component_rows(map(Verdict.read, verdicts.values()), score, key)), **place)
    write_part(
        warehouse,
        "findings",
        [
            FindingRow(**key, verifier=name, subject=found.subject, outcome=found.outcome, detail=found.detail)
            for name, path in verdicts.items()
            for found in verifier_named(name).findings(Verdict.read(path))
        ],
        **place,
    )
    write_part(warehouse, "pictures", list(_submission_pictures(trial, key)), **place)
    write_part(warehouse, "outcomes", [_outcome(trial, plan, score, [row for row, _ in attempts], key)], **place)


def _key(trial: Trial, plan: Plan) -> dict[str, Any]:
    return {
        "trial_id": trial_id(plan, trial),
        "run_id": plan.run_id,
        "suite": plan.suite_id,
        "configuration": trial.configuration.name,
        "case_id": trial.case.case_id,
        "repeat": trial.repeat,
    }


def _verdict_row(path: Path, key: dict[str, Any]) -> VerdictRow:
    verdict = Verdict.read(path)
    return VerdictRow(
        **key,
        verifier=verdict.verifier,
        status=verdict.status,
        score=verdict.score,
        reason=verdict.reason,
        policy=verdict.policy,
        document=canonical_json(verdict.plain()),
        verdict_sha256=digest_file(path),
    )


def _submission_pictures(trial: Trial, key: dict[str, Any]) -> Iterator[PictureRow]:
    index = trial.folder.evidence.captures_index
    if index.is_file():
        check_evidence(trial.folder)
        for capture in read_json(index)["views"]:
            width, height, jpeg = _jpeg(index.parent / capture["file"])
            yield PictureRow(**key, role="submission", view=capture["name"], width=width, height=height, jpeg=jpeg)


def _outcome(
    trial: Trial, plan: Plan, score: TrialScore, attempts: Sequence[AttemptRow], key: dict[str, Any]
) -> OutcomeRow:
    recorded = next((row for row in attempts if row.recorded), None)
    stages = list(json_lines(trial.folder.stages.read_text().splitlines()))
    overhead = sum(stage["seconds"] for stage in stages if stage["stage"] == "orchestration")
    evaluation = sum(
        stage["seconds"]
        for stage in stages
        if stage["stage"] != "orchestration" and not stage["stage"].startswith("attempt")
    )
    return OutcomeRow(
        **key,
        **{name: score.components.get(name) for name in HEADLINES},
        setting=trial.case.setting,
        scene_id=trial.case.scene_id,
        status=score.status,
        score=score.score,
        reason=score.reason,
        attempts=len(attempts),
        retained_attempt=score.retained_attempt,
        tool_calls=recorded.tool_calls if recorded else None,
        attempt_wall_s=recorded.wall_s if recorded else None,
        evaluation_s=evaluation,
        orchestration_s=overhead,
        input_tokens=recorded.input_tokens if recorded else None,
        output_tokens=recorded.output_tokens if recorded else None,
        cost_usd=recorded.cost_usd if recorded else None,
        ranked=is_ranked(trial.configuration),
        policy=plan.policy,
        judge=plan.judge,
        engine=plan.engine,
        suite_digest=plan.suite_digest,
        score_sha256=digest_file(trial.folder.score),
    )


def rebuild_from_run(run: Path, suite: Path, warehouse: Path) -> int:
    """Ingest every scored trial of a run again; returns how many."""
    plan = Plan.read(RunFolder(run).plan)
    ingest_schedule(run, suite, plan, warehouse)
    scored = [trial for trial in trials(run, suite, plan) if trial.folder.score.is_file()]
    for trial in scored:
        ingest_trial(trial, plan, warehouse)
    return len(scored)
