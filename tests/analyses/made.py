"""Asking a study of a made warehouse, and rows that the made warehouse does not write."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from pathlib import Path

from bench.made_warehouse import SUITE, MadeWarehouse
from c4s.records.analysis import StudyResult
from warehouse.analyses import StudyOptions, WantedScope, answer, study_named
from warehouse.database import rebuild
from warehouse.parquet import write_part
from warehouse.records import FindingRow, ToolUseRow, TrialKey, VerdictRow


def ask(root: Path, study: str, place: Path, **options: object) -> StudyResult:
    """A study's answer."""
    return answer(root, study_named(study), WantedScope(), StudyOptions.parse(options), place)


def keys(made: MadeWarehouse) -> Iterable[tuple[str, TrialKey]]:
    """Every trial's key, with its judge."""
    for judge in made.judges:
        for name in made.names():
            for case in made.cases():
                for repeat in range(1, made.repeats + 1):
                    yield (
                        judge,
                        TrialKey(
                            trial_id=made.key(name, judge, case, repeat)["trial_id"],
                            run_id=SUITE,
                            suite=SUITE,
                            suite_digest="d" * 64,
                            configuration=name,
                            configuration_digest=f"{name:0<64}",
                            case_id=case["case_id"],
                            repeat=repeat,
                        ),
                    )


def add_tools(made: MadeWarehouse, calls: Callable[[TrialKey], dict[str, int]]) -> None:
    """How often each trial called each tool."""
    rows = [
        ToolUseRow(**key.plain(), attempt=1, recorded=True, tool=tool, calls=count)
        for _, key in keys(made)
        for tool, count in calls(key).items()
    ]
    _store(made, "tool_use", rows)


def add_evidence(made: MadeWarehouse, evidence: Callable[[str, TrialKey], str]) -> None:
    """A verdict of each trial that names its evidence."""
    rows = [
        VerdictRow(
            **key.plain(),
            verifier="integrity",
            status="valid",
            score=None,
            reason="",
            policy="made-policy",
            document=json.dumps({"inputs": {"evidence_listing": evidence(judge, key)}}),
            verdict_sha256="0" * 64,
        )
        for judge, key in keys(made)
    ]
    _store(made, "verdicts", rows)


def add_decisions(made: MadeWarehouse, outcomes: Callable[[str, TrialKey], list[str]]) -> None:
    """What was decided of each trial's requirements; two of one text are two."""
    rows = [
        FindingRow(**key.plain(), verifier="detailed", subject="a red chair", outcome=outcome, detail="")
        for judge, key in keys(made)
        for outcome in outcomes(judge, key)
    ]
    _store(made, "findings", rows)


def _store(made: MadeWarehouse, table: str, rows: list[TrialKey]) -> None:
    for name in made.names():
        own = [row for row in rows if row.configuration == name]
        write_part(made.root, table, own, suite=SUITE, configuration=name, key="made")
    rebuild(made.root)
