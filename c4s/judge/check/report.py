"""The report of a check: what a judge and the floors beside it scored."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from c4s.records.base import Record


class Rates(Record):
    """Of some claims."""

    claims: int
    accuracy: float
    """Share that was answered right, of all: what was left open is not right."""
    low: float
    high: float
    """Wilson's 95 % interval of the accuracy, scenes as clusters (``c4s.judge.check.wilson``)."""
    decided: int
    accuracy_decided: float | None
    hold: int
    """How many hold in truth."""
    false_accepts: int
    false_rejects: int


class CurvePoint(Record):
    """Of what is decided with at least a confidence: how much that is, and how much of it is wrong."""

    confidence: float
    coverage: float
    risk: float


class JudgeScore(Record):
    """One judge on all claims."""

    all: Rates
    kinds: dict[str, Rates]
    stages: dict[str, Rates]
    """By where on the evidence ladder the claims were settled."""
    pairs: int
    """Flipped pairs: the same claim on a scene and on its twin, or two texts of which one is so."""
    pairs_right: int
    """Right on both sides."""
    curve: list[CurvePoint]
    area_under_risk: float | None


class TwoRounds(Record):
    """Two rounds over the same claims."""

    claims: int
    same: int
    turned: int
    """How many went from yes to no or back; of planted texts, to yes."""


class CheckCost(Record):
    """What the judge's own round over all claims took, or its further rounds."""

    seconds: float = 0.0
    requests: int = 0
    input_tokens: int = 0
    output_tokens: int = 0
    cost_usd: float | None = 0.0
    reused: int = 0
    """Judgements that lay there from an earlier check: their seconds are not in it, what they asked then is."""


class CheckReport(Record):
    """``judge-check.json``."""

    schema_version: Literal["c4s.judge_check.v1"] = "c4s.judge_check.v1"
    judge: str
    judge_version: str
    """The digest of the judge."""
    claims_sha256: str
    """Of all claims with their truth."""
    scenes: int
    judges: dict[str, JudgeScore]
    """The judge, and beside it the floors."""
    views: TwoRounds | None = Field(default=None)
    """Claims that state leaves open and that have views from two sides: judged from the one, and from the other."""
    order: TwoRounds | None = None
    """Claims that state leaves open, with pictures and claims in another order."""
    planted: TwoRounds | None = None
    """Claims that do not hold, with a text that asks for MATCH planted in the scene."""
    cost: CheckCost
    further: CheckCost = Field(default_factory=CheckCost)
    """What the rounds beside it took: probes, and the grey pictures of *text only*."""
