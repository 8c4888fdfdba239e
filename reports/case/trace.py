"""The evaluation trace of a trial: from construction through the gate and its evidence to the score."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from c4s.protocol.rules import GATE
from c4s.verify.registry import VERIFIERS
from c4s.verify.repair.verifier import REPAIR
from c4s.verify.semantic.verifier import DETAILED, OVERVIEW
from reports.case.asked import CaseRows
from reports.frame import SitePicture
from reports.frame.board import Row
from reports.text import moment, number

MOST_PICTURES: Final = 4


@dataclass(frozen=True)
class TraceStep:
    """One step: what was done, what it came to, what it rests on."""

    title: str
    told: str
    state: str = ""
    """``good``, ``bad`` or nothing."""
    facts: tuple[tuple[str, str], ...] = ()
    pictures: Sequence[tuple[SitePicture, str]] = ()
    """Some of its evidence, with what it is."""
    anchor: str = ""
    """Of what works its number out, on the same page."""


def trace_of(
    trial: Row,
    asked: CaseRows,
    evidence: Mapping[str, Sequence[SitePicture]],
    screenshots: Mapping[int, Sequence[SitePicture]],
) -> list[TraceStep]:
    """All steps, in their order; those after a gate that refused are left out.

    Args:
        trial: its row.
        asked: rows of the case.
        evidence: the trial's pictures by role.
        screenshots: what the agent looked at, by attempt.
    """
    trial_id = trial["trial_id"]
    documents = asked.documents.get(trial_id, {})
    retained = asked.retained.get(trial_id)
    steps = [
        _construction(row, row["attempt"] == retained, screenshots.get(row["attempt"], ()))
        for row in asked.attempts.get(trial_id, [])
    ]
    gate = documents.get(GATE)
    if gate is not None:
        told = f"{gate['status']}{': ' + gate['reason'] if gate['reason'] else ''}"
        steps.append(
            TraceStep("Integrity", told, "good" if gate["status"] == "valid" else "bad", _facts(gate, "Counted"))
        )
    if trial["status"].startswith("measured"):
        claims = asked.claims.get(trial_id, [])
        if claims:
            steps.append(_judge(claims, trial))
        for name, row in VERIFIERS.items():
            if name != GATE and name in documents:
                document = documents[name]
                score = document.get("score")
                told = str(document.get("status", "")) if score is None else number(score)
                weight = "" if row.weighed_as else ", reported and not weighed"
                seen, anchor = (
                    _evidence(name, evidence),
                    f"score-{name}" if row.weighed_as and score is not None else "",
                )
                steps.append(TraceStep(row.title, f"{told}{weight}", "", _facts(document, "Counted"), seen, anchor))
    told = number(trial["score"]) if trial["score"] is not None else "pending"
    reason = f" ({trial['reason']})" if trial["reason"] else ""
    anchor = "score-case" if trial["status"].startswith("measured") else ""
    steps.append(TraceStep("Case score", f"{told}{reason}", "", (("Policy", trial["policy"]),), (), anchor))
    return steps


def _evidence(name: str, pictures: Mapping[str, Sequence[SitePicture]]) -> list[tuple[SitePicture, str]]:
    """Some of what a verifier went by, or what shows the same."""
    if name == DETAILED.name:
        return [(one, one.view) for one in pictures.get("claim", ())[:MOST_PICTURES]]
    if name == OVERVIEW.name:
        return [(one, one.view) for one in pictures.get("submission", ())[:MOST_PICTURES]]
    if name == REPAIR.name:
        truth = {one.view: one for one in pictures.get("target_truth", ())}
        return [
            pair
            for one in pictures.get("target", ())[: MOST_PICTURES // 2]
            for pair in ((one, f"{one.view}, submission"), (truth.get(one.view, one), f"{one.view}, truth"))
        ]
    return []


def _construction(row: Row, retained: bool, screenshots: Sequence[SitePicture]) -> TraceStep:
    ended = row["ended_by"].replace("_", " ")
    told = f"{row['tool_calls']} calls in {moment(row['wall_s'])}, ended: {ended}"
    facts = [("Client", row["client_version"] or row["client"]), ("Engine", row["engine_version"])]
    facts += [("Model", row["model"])] if row["model"] else []
    facts += [("Saved", row["submission"] or "nothing")]
    facts += [("Said", row["message"])] if row["message"] else []
    state = "good" if retained else ("bad" if row["valid"] is False or row["submission"] is None else "")
    kept = "; its submission counts" if retained else ""
    seen = [(one, "what the agent saw") for one in screenshots[-MOST_PICTURES:]]
    told_facts = tuple((name, str(fact)) for name, fact in facts)
    return TraceStep(f"Attempt {row['attempt']}", told + kept, state, told_facts, seen, f"attempt-{row['attempt']}")


def _judge(claims: list[Row], trial: Row) -> TraceStep:
    scored = [row for row in claims if row["scored"]]
    answers = Counter(row["answer"] for row in scored)
    stages = Counter(row["stage"] for row in scored)
    told = ", ".join(f"{count} {answer.replace('_', ' ').lower()}" for answer, count in sorted(answers.items()))
    how = ", ".join(f"{count} by {stage}" for stage, count in stages.most_common())
    return TraceStep(f"Judge {trial['judge']}", told, "", (("Settled", how), ("Version", trial["judge_version"])))


def _facts(document: Mapping[str, Any], counted: str) -> tuple[tuple[str, str], ...]:
    population = ", ".join(
        f"{name.replace('_', ' ')} {count}" for name, count in document.get("population", {}).items()
    )
    inputs = ", ".join(
        f"{name} {sha256[:12]}" for name, sha256 in sorted(document.get("inputs", {}).items()) if "/" not in name
    )
    found = (
        (counted, population),
        ("Rule", document.get("policy", "")),
        ("Code", document.get("made_by", "")),
        ("Read", inputs),
    )
    return tuple((name, told) for name, told in found if told)
