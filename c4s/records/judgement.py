"""Judgements: what one judge said of every claim of a case's requirement bundle, and of the scene as a whole.

``judgements/<judge>.json`` of a trial. A verdict is made from this file alone, so it can be made again at any time
without a judge. A claim is a requirement of the bundle, by the id of its node.
"""

from __future__ import annotations

from collections import Counter
from typing import Any, ClassVar, Literal, Self

from pydantic import Field, model_validator

from c4s.records.base import Record, Sealed

Answer = Literal["MATCH", "MISMATCH", "UNKNOWN"]


class ClaimJudgement(Record):
    """What the judge said of one claim, and what it rests on."""

    claim: str
    answer: Answer
    score: float = Field(ge=0.0, le=1.0, allow_inf_nan=False)
    """Share of the claim that holds; 0 when unknown."""
    confidence: float | None = Field(default=None, ge=0.0, le=1.0, allow_inf_nan=False)
    reason: str = ""
    actors: list[str] = Field(default_factory=list)
    """Object names of the actors that it rests on."""
    seen_actors: int | None = None
    """How many of them are clearly visible in a view; null without actor masks."""
    measures: dict[str, Any] = Field(default_factory=dict)
    views: list[str] = Field(default_factory=list)
    """Names of the views that the judge was shown."""
    request_sha256: str | None = None
    """Digest of the request to a model; null where none was made."""
    answer_sha256: str | None = None

    @model_validator(mode="after")
    def _unknown_is_zero(self) -> Self:
        if self.answer == "UNKNOWN" and self.score:
            raise ValueError("an unknown answer has the score 0")
        return self


class OverviewPart(Record):
    """One part of an overview dimension: its value (0 when unknown) and what it rests on."""

    name: str
    value: float = Field(ge=0.0, le=1.0, allow_inf_nan=False)
    known: bool
    detail: dict[str, Any] = Field(default_factory=dict)


class OverviewDimension(Record):
    """One dimension of the overview: its score, and the parts where the judge tells them."""

    score: float = Field(ge=0.0, le=1.0, allow_inf_nan=False)
    parts: list[OverviewPart] = Field(default_factory=list)


class OverviewJudgement(Record):
    """The whole scene in the four overview views."""

    dimensions: dict[str, OverviewDimension]
    structural_integrity_score: float = Field(ge=0.0, le=1.0, allow_inf_nan=False)
    structural_parts: list[OverviewPart] = Field(default_factory=list)
    severe_structural_cap_eligible: bool = False
    """Whether the judge proved a severe structural defect (paper, Overview Alignment)."""
    views: list[str] = Field(default_factory=list)
    things: int | None = None
    """Things that the judge counted in the scene's state; null for one that only looks."""
    request_sha256: str | None = None
    answer_sha256: str | None = None


class Judgements(Sealed):
    """All that a judge said of one submission."""

    REMEDY: ClassVar[str] = "run the same `c4s run` again: it is set aside and made anew"
    schema_version: Literal["c4s.judgements.v1"] = "c4s.judgements.v1"
    judge: str
    """Name of the judge, as in the plan."""
    judge_version: str
    """Changes with anything that can change an answer: sources, word lists, prompts, model."""
    inputs: dict[str, str] = Field(default_factory=dict)
    """SHA-256 of each file that the judge read."""
    claims: list[ClaimJudgement]
    """In the bundle's order; empty for a case without a bundle."""
    overview: OverviewJudgement | None = None
    overview_reason: str = ""
    """Why there is no overview judgement."""

    @model_validator(mode="after")
    def _one_answer_a_claim(self) -> Self:
        twice = [claim for claim, times in Counter(made.claim for made in self.claims).items() if times > 1]
        if twice:
            raise ValueError(f"claim {twice[0]!r} is answered more than once")
        return self
