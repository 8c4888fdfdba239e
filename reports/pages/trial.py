"""The page of a trial: pictures, worked scoring, evaluation trace, requirements, findings, what the agent did."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any, Final

from c4s.protocol.repair import PROFILES
from c4s.protocol.settings import is_construction
from c4s.verify.navigation.verifier import NAVIGATION
from c4s.verify.physics.verifier import PHYSICS
from c4s.verify.semantic.verifier import DETAILED
from reports.case import (
    FALLS,
    CaseRows,
    astray,
    attempts_of,
    case_rows,
    case_runs,
    renders_of,
    requirement_rows,
    trace_of,
    walk_of,
)
from reports.frame import Board, SiteContext, SitePage, SitePicture, links
from reports.frame.board import Row
from reports.working import worked_score

FINDINGS_SHOWN: Final = 60


def pages(site: SiteContext) -> Iterator[SitePage]:
    """A page a trial of each public case of each leaderboard."""
    for board in site.boards:
        for case in board.cases:
            made_of = site.stamp(board, case["case_id"])
            for name in board.order:
                for row in case["scores"].get(name, []):
                    yield SitePage(
                        links.trial(board, row), "trial.html.j2", partial(_values, site, board, case, row), made_of
                    )


def _values(site: SiteContext, board: Board, case: Row, trial: Row) -> dict[str, Any]:
    pictures, asked = site.pictures(board, case["case_id"]), case_rows(site, board, case["case_id"])
    trial_id = trial["trial_id"]
    own = {role: found for (of, role), found in pictures.items() if of == trial_id}
    documents = asked.documents.get(trial_id, {})
    runs = case_runs(board, case, asked.documents)
    (run,) = (run for run in runs if run.trial["trial_id"] == trial_id)
    attempts = attempts_of(site, board, trial, asked, own.get("screenshot", []))
    looked = {
        attempt.row["attempt"]: [picture for call in attempt.calls for picture in call.screenshots]
        for attempt in attempts
    }
    seen: list[SitePicture] = [*own.get("claim", []), *own.get("submission", [])]
    return {
        "board": board,
        "case": case,
        "trial": trial,
        "run": run,
        "others": runs,
        "plan": asked.plan,
        "documents": documents,
        "working": worked_score(trial, documents, asked.semantic.get(trial_id)),
        "renders": renders_of(pictures, [run], construction=is_construction(case["setting"])),
        "trace": trace_of(trial, asked, own, looked),
        "requirements": requirement_rows(documents.get(DETAILED.name, {}), asked.claims.get(trial_id, []), seen),
        "findings": _physical(asked, trial_id),
        "walk": walk_of(documents.get(NAVIGATION.name)),
        "falls": FALLS,
        "unreached": astray(asked.findings.get(trial_id, [])),
        "limit": FINDINGS_SHOWN,
        "profiles": list(PROFILES),
        "attempts": attempts,
    }


def _physical(asked: CaseRows, trial_id: str) -> list[Row]:
    return [row for row in asked.findings.get(trial_id, []) if row["verifier"] == PHYSICS.name]
