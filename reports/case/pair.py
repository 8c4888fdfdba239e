"""A higher and a lower run beside each other: how each score comes about, and what tells the two apart."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from c4s.verify.physics.verifier import PHYSICS
from c4s.verify.repair.verifier import REPAIR
from c4s.verify.semantic.verifier import DETAILED
from reports.case.asked import CaseRows
from reports.case.requirements import requirement_rows
from reports.case.runs import CaseRun
from reports.frame import SitePicture
from reports.frame.board import Row
from reports.text import number
from reports.working import Working, worked_score

MOST_APART: Final = 4
MOST_OFFENDERS: Final = 2
MOST_PICTURES: Final = 2
_ERRORS: Final = (("position_cm", "{} cm off"), ("rotation_deg", "{}° turned"), ("scale_pct", "{} % scaled"))


@dataclass(frozen=True)
class PairRun:
    """One of the two."""

    run: CaseRun
    working: Working
    facts: Sequence[tuple[str, str]]
    """What physics counted, whom it found, what else was changed."""


@dataclass(frozen=True)
class Side:
    """What one run has of a requirement or target."""

    outcome: str
    told: str
    pictures: Sequence[SitePicture] = ()


@dataclass(frozen=True)
class Apart:
    """A requirement or target that the two decide otherwise."""

    text: str
    note: str
    sides: tuple[Side, Side]


@dataclass(frozen=True)
class RunPair:
    """The higher run first."""

    runs: tuple[PairRun, PairRun]
    apart: Sequence[Apart]
    more: int
    """Differences that are not shown."""


def pair_of(
    high: CaseRun, low: CaseRun, asked: CaseRows, pictures: Mapping[tuple[str, str], Sequence[SitePicture]]
) -> RunPair:
    """Both runs with their workings.

    Args:
        high: the higher run.
        low: the lower run.
        asked: rows of the case.
        pictures: of the case, by trial and role.
    """
    first, second = ({**_claims(run, asked, pictures), **_targets(run, asked)} for run in (high, low))
    apart = [
        Apart(text, note, (side, second[name][2]))
        for name, (text, note, side) in first.items()
        if name in second and second[name][2].outcome != side.outcome
    ]
    apart.sort(key=lambda one: one.sides[0].outcome not in ("MATCH", "TP"))
    return RunPair((_run(high, asked), _run(low, asked)), apart[:MOST_APART], max(0, len(apart) - MOST_APART))


def _run(run: CaseRun, asked: CaseRows) -> PairRun:
    trial_id = run.trial["trial_id"]
    documents = asked.documents.get(trial_id, {})
    working = worked_score(run.trial, documents, asked.semantic.get(trial_id))
    return PairRun(run, working, [*_physical(documents, asked.findings.get(trial_id, [])), *_spoilt(documents)])


def _physical(documents: Mapping[str, Any], findings: Sequence[Row]) -> list[tuple[str, str]]:
    leaves = documents.get(PHYSICS.name, {}).get("measurements", {}).get("leaf_results", [])
    told = [
        (
            str(leaf["leaf_id"]).replace("_", " ").capitalize(),
            f"{leaf['failed']} of {leaf['evaluated']} eligible actors fail"
            if leaf["evaluated"]
            else "no actor is eligible",
        )
        for leaf in leaves
        if leaf.get("evaluated") is not None and leaf.get("failed") is not None
    ]
    offenders = [row for row in findings if row["verifier"] == PHYSICS.name][:MOST_OFFENDERS]
    return told + [
        (row["outcome"].replace("_", " ").capitalize(), f"{row['subject']}: {row['detail']}") for row in offenders
    ]


def _spoilt(documents: Mapping[str, Any]) -> list[tuple[str, str]]:
    wrong = documents.get(REPAIR.name, {}).get("measurements", {}).get("false_positives", [])
    named = ", ".join(f"{row.get('actor', '')} ({row['kind'].replace('_', ' ')})" for row in wrong[:MOST_OFFENDERS])
    more = f" and {len(wrong) - MOST_OFFENDERS} more" if len(wrong) > MOST_OFFENDERS else ""
    return [("False positives", f"{named}{more}")] if wrong else []


def _claims(
    run: CaseRun, asked: CaseRows, pictures: Mapping[tuple[str, str], Sequence[SitePicture]]
) -> dict[str, tuple[str, str, Side]]:
    trial_id = run.trial["trial_id"]
    seen = [picture for role in ("claim", "submission") for picture in pictures.get((trial_id, role), ())]
    document = asked.documents.get(trial_id, {}).get(DETAILED.name, {})
    return {
        one.claim: (
            one.text,
            one.kind,
            Side(one.answer, one.reason, [picture for picture, _ in one.pictures[:MOST_PICTURES]]),
        )
        for one in requirement_rows(document, asked.claims.get(trial_id, []), seen)
        if one.scored
    }


def _targets(run: CaseRun, asked: CaseRows) -> dict[str, tuple[str, str, Side]]:
    document = asked.documents.get(run.trial["trial_id"], {}).get(REPAIR.name, {})
    found = {}
    for row in document.get("measurements", {}).get("targets", []):
        errors = row.get("errors") or {}
        off = [told.format(number(errors[name], 1)) for name, told in _ERRORS if errors.get(name)]
        side = Side(row["outcome"], ", ".join([str(row["reason"]), *off]))
        note = f"{row['operation']}: {', '.join(row.get('fields', []))}"
        found[str(row.get("identity") or row["actor"])] = (str(row["actor"]), note, side)
    return found
