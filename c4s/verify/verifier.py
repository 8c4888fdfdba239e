"""What a verifier is: one row of the table in ``c4s.verify.registry``."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from c4s.protocol.numbers import unit_number
from c4s.protocol.settings import Setting
from c4s.records.evidence import Evidence, EvidenceName
from c4s.records.evidence_digests import MEASURED, Maker
from c4s.records.policy import ScorePolicy
from c4s.records.verdict import Verdict

Components = dict[str, float]
"""Numbers by name; parts of a number have dotted names. What was not measured is left out."""


@dataclass(frozen=True)
class Finding:
    """One decision of a verdict: about which actor or requirement, what, and the measurements behind it."""

    subject: str
    outcome: str
    detail: str


def no_findings(verdict: Verdict) -> list[Finding]:
    """For a verifier that decides about the scene as a whole only."""
    return []


def no_components(verdict: Verdict) -> Components:
    """For a verifier whose score is its only number."""
    return {}


def shares(source: Mapping[str, Any], names: Iterable[str]) -> Components:
    """Those of the named values that are numbers in [0, 1]."""
    return {name: value for name in names if (value := unit_number(source.get(name))) is not None}


def dotted(prefix: str, made: Components) -> Components:
    """The same numbers as parts of ``prefix``."""
    return {f"{prefix}.{name}": value for name, value in made.items()}


@dataclass(frozen=True)
class Verifier:
    """One verifier: what it is called, where it applies, what it reads, and what is made of its verdict."""

    name: str
    title: str
    """As pages show it."""
    settings: tuple[Setting, ...]
    needs: frozenset[EvidenceName]
    """The evidence that it is given, and nothing else; of these, what other stages make must be there first."""
    verify: Callable[[Evidence], Verdict]
    measure: Callable[[Evidence], dict[EvidenceName, Mapping[str, Any]]] | None = None
    """Makes those of the files that it needs which are measured in the scene and are not there yet."""
    maker: Maker = MEASURED
    """Under which name the digests of what it measures are kept."""
    gate: bool = False
    """Whether its verdict decides that the others are made at all."""
    weighed_as: str = ""
    """Name of its score among a policy's weights; empty for one that is reported and not weighed."""
    parts: Callable[[Verdict], Components] = no_components
    """The numbers that its score is made of."""
    headlines: Mapping[str, str] = field(default_factory=dict)
    """What a trial's score and the leaderboard show of it: the name there, and which component it is."""
    score_under: Callable[[Verdict, ScorePolicy, Setting], tuple[float | None, dict[str, Any]]] | None = None
    """Its score under another policy from the verdict's own measurements, and which of them change."""
    findings: Callable[[Verdict], Iterable[Finding]] = field(default=no_findings)

    def components(self, verdict: Verdict) -> Components:
        """All its numbers, its score among them as ``score``."""
        return shares({"score": verdict.score}, ["score"]) | self.parts(verdict)

    def shown(self, verdict: Verdict) -> dict[str, float | None]:
        """Its headlines: zero where nothing was measured, null where this one number is not known."""
        made = self.components(verdict)
        measured = verdict.status == "measured"
        return {name: made.get(part) if measured else 0.0 for name, part in self.headlines.items()}
