"""From a run folder to rows. The warehouse is derived: ingesting again gives the same files."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from c4s.errors import BadInput
from c4s.files import canonical_json, digest, digest_file, read_json_lines
from c4s.protocol.rules import NO_SUBMISSION
from c4s.records.base import Record
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan, PlannedCase
from c4s.records.score import TrialScore
from c4s.records.suite import AgentCase, SuiteFolder, WithheldCase, WithheldFolder
from c4s.records.verdict import Verdict
from c4s.run.configurations import is_ranked
from c4s.run.plan import Trial, trial_id, trials
from c4s.run.torn import check_scored
from c4s.verify.registry import verifier_named
from warehouse.behaviour import attempt_rows, submission_rows, tool_use_rows
from warehouse.calls import call_rows, screenshot_rows
from warehouse.claims import claim_rows
from warehouse.components import component_rows
from warehouse.parquet import is_whole, part_path, write_part
from warehouse.pictures import CASE_PARTITION, case_pictures, submission_pictures
from warehouse.records import HEADLINES, TABLES, AttemptRow, FindingRow, OutcomeRow, SceneRow, ScheduleRow, VerdictRow
from warehouse.scenes import case_scenes, trial_scene

TRIAL_TABLES = tuple(table for table in TABLES if table not in ("schedule", "shapes"))
ZERO_CODES = {"zero_missing_submission": NO_SUBMISSION, "zero_missing_result": "missing_result"}
"""Reason codes of zeros that no verdict gave, by status."""


def ingest_schedule(run: Path, suite: Path, plan: Plan, warehouse: Path) -> None:
    """Write one row a planned trial, in one part a configuration, and the pictures of each case.

    A trial that several runs planned has a row of each; the database shows the one that was planned first.
    """
    folder = SuiteFolder(suite)
    planned_at = datetime.fromtimestamp(RunFolder(run).plan.stat().st_mtime, UTC).isoformat(timespec="milliseconds")
    facts = {
        case.case_id: _case_facts(folder.agent_case(case.alias), folder.withheld_case(case.case_id))
        for case in plan.cases
    }
    for chosen in plan.configurations:
        rows = [
            ScheduleRow(
                **_key(trial, plan),
                **facts[trial.case.case_id],
                planned_at=planned_at,
                client=trial.working.client,
                model=trial.working.model,
                setting=trial.case.setting,
                scene_id=trial.case.scene_id,
                policy=plan.policy,
                judge=plan.judge,
                judge_version=plan.judge_version,
                engine=plan.engine,
                ranked=is_ranked(chosen),
            )
            for trial in trials(run, suite, plan.model_copy(update={"configurations": [chosen]}))
        ]
        same = [plan.suite_digest, chosen.plain(), plan.policy, plan.judge, plan.judge_version, plan.engine]
        kept = digest(same)[:12]
        write_part(
            warehouse, "schedule", rows, suite=plan.suite_id, configuration=chosen.name, key=f"{plan.run_id}-{kept}"
        )
    for case in plan.cases:
        _ingest_case(folder, plan, case, warehouse)


def _ingest_case(folder: SuiteFolder, plan: Plan, case: PlannedCase, warehouse: Path) -> None:
    """Write the pictures and scenes of a case, once."""
    part = f"{case.case_id}-{digest([plan.suite_digest, case.withheld_digest])[:12]}"
    key = {
        "trial_id": "",
        "run_id": plan.run_id,
        "suite": plan.suite_id,
        "suite_digest": plan.suite_digest,
        "configuration": CASE_PARTITION,
        "configuration_digest": "",
        "case_id": case.case_id,
        "repeat": 0,
    }
    withheld = WithheldFolder(folder.withheld(case.case_id))

    def scenes() -> Iterator[Record]:
        agent, record = folder.agent_case(case.alias), folder.withheld_case(case.case_id)
        return case_scenes(agent, record, withheld, key, warehouse)

    made: dict[str, Callable[[], Iterator[Record]]] = {
        "pictures": lambda: case_pictures(withheld, key),
        "scenes": scenes,
    }
    for table, rows in made.items():
        if not is_whole(part_path(warehouse, table, plan.suite_id, CASE_PARTITION, part)):
            write_part(warehouse, table, list(rows()), suite=plan.suite_id, configuration=CASE_PARTITION, key=part)


def _case_facts(agent: AgentCase, withheld: WithheldCase) -> dict[str, Any]:
    """What a schedule tells of a case."""
    return {
        "title": withheld.title,
        "prompt": agent.prompt,
        "operations": " ".join(withheld.operations),
        "operation_group": withheld.operation_group,
        "difficulty": withheld.difficulty,
        "visibility": withheld.visibility,
        "proxy_assets": withheld.proxy_assets,
        "call_budget": agent.budget.tool_calls,
        "wall_budget_s": 60 * agent.budget.wall_minutes,
    }


def ingest_trial(trial: Trial, plan: Plan, warehouse: Path) -> None:
    """Write all rows of a scored trial, or none; the outcome row comes last, so that it stands for the whole.

    Calls, claims and the pictures that verdicts rest on are kept of public cases only.
    """
    key = _key(trial, plan)
    place: dict[str, str] = {"suite": plan.suite_id, "configuration": trial.configuration.name, "key": key["trial_id"]}
    verdicts = trial.folder.verdicts
    score = TrialScore.read(trial.folder.score)
    attempts = list(attempt_rows(trial, score, key))
    read = [Verdict.read(path) for path in verdicts.values()]
    done = [row for row, _ in attempts]
    public = SuiteFolder(trial.suite).withheld_case(trial.case.case_id).visibility == "public"
    parts: dict[str, Sequence[Record]] = {
        "attempts": done,
        "tool_use": tool_use_rows(attempts, key),
        "python_submissions": submission_rows(attempts, key),
        "calls": call_rows(trial, done, key) if public else [],
        "claims": list(claim_rows(trial, plan, key)) if public else [],
        "verdicts": [_verdict_row(path, key) for path in verdicts.values()],
        "components": list(component_rows(read, score, key)),
        "findings": [
            FindingRow(**key, verifier=name, subject=found.subject, outcome=found.outcome, detail=found.detail)
            for name, verdict in zip(verdicts, read, strict=True)
            for found in verifier_named(name).findings(verdict)
        ],
        "pictures": [
            *submission_pictures(trial, key, evidence=public),
            *(screenshot_rows(trial, done, key) if public else ()),
        ],
        "scenes": list(_submission_scene(trial, key, warehouse)),
        "outcomes": [_outcome(trial, plan, score, done, key)],
    }
    for table, rows in parts.items():
        write_part(warehouse, table, rows, **place)


def _key(trial: Trial, plan: Plan) -> dict[str, Any]:
    return {
        "trial_id": trial_id(plan, trial),
        "run_id": plan.run_id,
        "suite": plan.suite_id,
        "suite_digest": plan.suite_digest,
        "configuration": trial.configuration.name,
        "configuration_digest": trial.configuration.sha256(),
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


def _submission_scene(trial: Trial, key: dict[str, Any], warehouse: Path) -> Iterator[SceneRow]:
    suite = SuiteFolder(trial.suite)
    agent, withheld = suite.agent_case(trial.case.alias), suite.withheld_case(trial.case.case_id)
    return trial_scene(agent, withheld, trial.folder.evidence, key, warehouse)


def _outcome(
    trial: Trial, plan: Plan, score: TrialScore, attempts: Sequence[AttemptRow], key: dict[str, Any]
) -> OutcomeRow:
    recorded = next((row for row in attempts if row.recorded), None)
    times = trial.folder.stages
    stages = read_json_lines(times, what="list of stages") if times.is_file() else []
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
        reason_code=_reason_code(trial, score),
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
        judge_version=plan.judge_version,
        engine=plan.engine,
        sandbox=recorded.sandbox if recorded else None,
        score_sha256=digest_file(trial.folder.score),
    )


def _reason_code(trial: Trial, score: TrialScore) -> str:
    """Why a trial is worth zero without being measured, as a code; empty where it was measured or is pending."""
    if score.status == "zero_invalid_candidate":
        judged = [folder.integrity for folder in trial.folder.attempts() if folder.integrity.is_file()]
        return str(Verdict.read(judged[-1]).measurements.get("reason_code", "")) if judged else ""
    return ZERO_CODES.get(score.status, "")


def rebuild_from_run(
    run: Path, suite: Path, warehouse: Path, *, wanted: Callable[[Trial, Plan], bool] = lambda trial, plan: True
) -> list[BadInput]:
    """Ingest the scored trials of a run again, or those that are wanted; why others were left out.

    A trial is left out whose score or verdicts are not as they were written, and all of them where the suite is not
    the one of the plan.
    """
    plan = Plan.read(RunFolder(run).plan)
    scored = [trial for trial in trials(run, suite, plan) if trial.folder.score.exists() and wanted(trial, plan)]
    if not scored:
        return []
    try:
        if SuiteFolder(suite).suite().sha256() != plan.suite_digest:
            raise BadInput("this is not the suite of the run", where=str(suite), todo="build the suite that it was")
        ingest_schedule(run, suite, plan, warehouse)
    except BadInput as error:
        return [BadInput(f"{len(scored)} trials of run {plan.run_id!r} are left out: {error.line()}")]
    left_out = []
    for trial in scored:
        try:
            check_scored(trial.folder)
            ingest_trial(trial, plan, warehouse)
        except BadInput as error:
            left_out.append(BadInput(f"{trial.name} of run {plan.run_id!r} is left out: {error.line()}"))
    return left_out
