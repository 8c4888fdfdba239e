"""What a verifier is: one row of the table in ``c4s.verify.registry``."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any

from c4s.protocol.settings import Setting
from c4s.records.evidence import Evidence, EvidenceName
from c4s.records.policy import ScorePolicy
from c4s.records.verdict import Verdict

Components = dict[str, float | None]


@dataclass(frozen=True)
class Finding:
    """One decision of a verdict: about which actor or requirement, what, and the measurements behind it."""

    subject: str
    outcome: str
    detail: str


def no_findings(verdict: Verdict) -> list[Finding]:
    """For a verifier that decides about the scene as a whole only."""
    return []


def score_as(name: str) -> Callable[[Verdict], Components]:
    """The verdict's score as its one component, worth zero where there is none."""
    return lambda verdict: {name: verdict.score if verdict.status == "measured" else 0.0}


@dataclass(frozen=True)
class Verifier:
    """One verifier: what it is called, where it applies, what it reads, and what is made of its verdict."""

    name: str
    title: str
    """As pages show it."""
    settings: tuple[Setting, ...]
    needs: frozenset[EvidenceName]
    """Evidence that must be there before it can run."""
    verify: Callable[[Evidence], Verdict]
    gate: bool = False
    """Whether its verdict decides that the others are made at all."""
    weighed_as: str = ""
    """Name of its score among a policy's weights; empty for one that is reported and not weighed."""
    component_names: tuple[str, ...] = ()
    """The numbers that it adds to a trial's score; all zero for an invalid scene."""
    components: Callable[[Verdict], Components] = lambda verdict: {}
    """These numbers of a verdict, whatever its status is."""
    score_under: Callable[[Verdict, ScorePolicy, Setting], tuple[float | None, dict[str, Any]]] | None = None
    """Its score under another policy from the verdict's own measurements, and which of them change."""
    findings: Callable[[Verdict], Iterable[Finding]] = field(default=no_findings)
