"""What verdicts say of single actors, by object name."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Final

from c4s.verify.registry import VERIFIERS
from c4s.verify.repair.verifier import REPAIR

PHYSICAL: Final = ("floating", "penetrating")
"""Outcomes of physics that mark an actor."""
_OF_TRUTH: Final = ("TP", "FN")
"""Outcomes of targets, which are named as they are called in the truth."""

Row = Mapping[str, Any]


@dataclass
class Said:
    """What is said of the actors of one submission: by name, [verifier, outcome, text]."""

    submission: dict[str, list[list[str]]] = field(default_factory=lambda: defaultdict(list))
    truth: dict[str, list[list[str]]] = field(default_factory=lambda: defaultdict(list))
    pairs: dict[str, str] = field(default_factory=dict)
    """Names in the truth to the names in the submission that the repair verdict took for them."""


def said_of_actors(findings: Iterable[Row], verdicts: Iterable[Row]) -> Said:
    """What a trial's findings and verdicts (rows of these tables, documents parsed) say of its actors.

    A finding is said of its actor, a requirement of the actors that decided it.
    """
    said, requirements = Said(), set()
    for verdict in verdicts:
        measured, title = verdict["document"]["measurements"], VERIFIERS[verdict["verifier"]].title
        for row in measured.get("targets", []) if verdict["verifier"] == REPAIR.name else []:
            if row.get("candidate"):
                said.pairs[row["actor"]] = row["candidate"]
        if "decisions" in measured:
            requirements.add(verdict["verifier"])
        for row in measured.get("decisions", []):
            for actor in row.get("actors") or []:
                outcome = str(row.get("evaluation_status", row.get("status", "")))
                said.submission[actor].append([title, outcome, f"{row.get('text', '')}: {row.get('reason', '')}"])
    for row in findings:
        if row["verifier"] in requirements:
            continue
        told = [VERIFIERS[row["verifier"]].title, row["outcome"], row["detail"]]
        if row["outcome"] in _OF_TRUTH:
            said.truth[row["subject"]].append(told)
            if row["subject"] in said.pairs:
                said.submission[said.pairs[row["subject"]]].append(told)
        else:
            said.submission[row["subject"]].append(told)
    return said
