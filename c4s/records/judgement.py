"""Judgements: what one judge said of every claim of a case's requirement bundle, and of the scene as a whole.

``judgements/<judge>.json`` of a trial. A verdict is made from this file alone, so it can be made again at any time
without a judge. A claim is a requirement of the bundle, by the id of its node. What was asked of a model, and what it
answered, lies beside it by digest (``TrialFolder.exchanges``).
"""

from __future__ import annotations

from collections import Counter
from typing import Any, ClassVar, Final, Literal, Self

from pydantic import Field, model_validator

from c4s.records.base import Record, Sealed
from c4s.records.judge import JudgeKind

Answer = Literal["MATCH", "MISMATCH", "UNKNOWN", "NOT_EVALUATED", "ERROR"]
"""Decided (the first two), looked at and left open, without what it takes to look (targets, pictures), or lost to a
fault that the run was told to accept. What is not decided is worth 0 and stays in the denominator."""
DECIDED: Final = frozenset({"MATCH", "MISMATCH"})
Rung = Literal["state", "sight", "alternate", "arbitration", "combined"]
"""Where on the evidence ladder a claim was settled: by state, by its views, by other views, by the final choice between
yes and no, or from the claims that it is made of."""
Purpose = Literal["sight", "alternate", "arbitration", "prompt_aware", "prompt_free", "paired"]
OF_CLAIMS: Final[frozenset[Purpose]] = frozenset({"sight", "alternate", "arbitration"})
"""Purposes of the requests that Detailed Alignment rests on."""


class ClaimJudgement(Record):
    """What the judge said of one claim, and what it rests on."""

    claim: str
    answer: Answer
    score: float = Field(ge=0.0, le=1.0, allow_inf_nan=False)
    """Share of the claim that holds; 0 where it is not decided."""
    confidence: float | None = Field(default=None, ge=0.0, le=1.0, allow_inf_nan=False)
    reason: str = ""
    stage: Rung = "state"
    fallback: bool = False
    """Whether it is unknown because a model broke the contract of its answer twice."""
    actors: list[str] = Field(default_factory=list)
    """Object names of the actors that it rests on."""
    seen_actors: int | None = None
    """How many of them are clearly visible in a view; null without actor masks."""
    measures: dict[str, Any] = Field(default_factory=dict)
    views: list[str] = Field(default_factory=list)
    """Names of the views that the judge was shown."""
    cited: list[str] = Field(default_factory=list)
    """Those of them that it says it saw it in."""
    request_sha256: str | None = None
    """Digest of the last request to a model; null where none was made."""
    answer_sha256: str | None = None

    @model_validator(mode="after")
    def _undecided_is_zero(self) -> Self:
        if self.answer not in DECIDED and self.score:
            raise ValueError("an answer that decides nothing has the score 0")
        if self.fallback and self.answer != "UNKNOWN":
            raise ValueError("a fallback is unknown")
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
    reason: str = ""
    """In the words of a model."""


class SevereDefect(Record):
    """A severe structural defect that a model reports; whether it caps the score is the protocol's rule."""

    confidence: float = Field(ge=0.0, le=1.0, allow_inf_nan=False)
    views: list[str]
    categories: list[str]
    issues: list[str]


class OverviewJudgement(Record):
    """The whole scene in the four overview views."""

    dimensions: dict[str, OverviewDimension]
    structural_integrity_score: float = Field(ge=0.0, le=1.0, allow_inf_nan=False)
    structural_parts: list[OverviewPart] = Field(default_factory=list)
    severe_structural_cap_eligible: bool = False
    """Whether the judge proved a severe structural defect (paper, Overview Alignment)."""
    severe: SevereDefect | None = None
    structural_reason: str = ""
    summary: str = ""
    """What a model sees, to explain its scores; no score is made of it."""
    views: list[str] = Field(default_factory=list)
    things: int | None = None
    """Things that the judge counted in the scene's state; null for one that only looks."""


class PairedView(Record):
    """The submission of a repair beside its truth, from one held-out camera."""

    pair: str
    target: str
    """Name of the view of the submission."""
    truth: str
    measures: dict[str, float] = Field(default_factory=dict)
    """Of the pictures, in [0, 1]; those that the evidence allows."""
    said: dict[str, float] = Field(default_factory=dict)
    """A model's scores in [0, 1], by dimension."""
    dimensions: dict[str, float] = Field(default_factory=dict)
    """Both blended; a dimension that neither tells anything of is absent."""
    reason: str = ""


class PairedJudgement(Record):
    """All pairs of views of a repair. Reported, never scored."""

    views: list[PairedView]
    dimensions: dict[str, float]
    """Means over the views."""
    score: float = Field(ge=0.0, le=1.0, allow_inf_nan=False)


class Asked(Record):
    """One logical request to a model; tries of one request count once."""

    purpose: Purpose
    request_sha256: str
    answer_sha256: str | None
    """Null where no answer came."""
    claims: list[str] = Field(default_factory=list)
    views: list[str] = Field(default_factory=list)
    """In the order in which they were shown."""
    again: bool = False
    """Whether it asks anew for what the answer before it broke."""
    broken: dict[str, str] = Field(default_factory=dict)
    """How the answer broke its contract: by claim, or under ``""`` as a whole."""
    fault: str = ""
    """Why no answer came, where the run accepts that."""
    cached: bool = False
    """Whether the answer is an earlier one to the very same request."""


class JudgeUsage(Record):
    """What the requests of one submission took. Answers from the cache cost nothing."""

    requests: int = 0
    """Logical requests, answers from the cache included."""
    cached: int = 0
    failures: int = 0
    """Tries that brought no answer."""
    input_tokens: int = 0
    output_tokens: int = 0
    unknown: int = 0
    """Answers that do not tell their tokens."""
    cost_usd: float | None = 0.0
    """Null where the price of a request is not known."""


class Serving(Record):
    """Who answered a judge's requests. Where that is stands in no record."""

    replicas: int
    """Addresses that the requests were spread over."""
    parallel: int
    """Requests at once, at most."""
    models: list[str] = Field(default_factory=list)
    """Models that the answers name; more than one tells that the addresses do not serve the same."""
    fingerprints: list[str] = Field(default_factory=list)
    """Builds of the server that the answers name, where they do."""


class Judgements(Sealed):
    """All that a judge said of one submission."""

    REMEDY: ClassVar[str] = "run the same `c4s run` again: it is set aside and made anew"
    schema_version: Literal["c4s.judgements.v1"] = "c4s.judgements.v1"
    judge: str
    """Name of the judge, as in the plan."""
    kind: JudgeKind = "rule"
    judge_version: str
    """Changes with anything that can change an answer: sources, word lists, prompts, model."""
    inputs: dict[str, str] = Field(default_factory=dict)
    """SHA-256 of each file that the judge read."""
    claims: list[ClaimJudgement]
    """In the bundle's order; empty for a case without a bundle."""
    beneath: list[ClaimJudgement] = Field(default_factory=list)
    """Claims that are not scored themselves and that scored ones are made of."""
    overview: OverviewJudgement | None = None
    overview_reason: str = ""
    """Why there is no overview judgement."""
    paired: PairedJudgement | None = None
    paired_reason: str = ""
    """Why no pair of views was compared."""
    schedule: list[Asked] = Field(default_factory=list)
    """All requests to a model, in their order: what repeats ask again."""
    pictures: dict[str, str] = Field(default_factory=dict)
    """SHA-256 of the pictures that a model was shown, by the name of the view."""
    usage: JudgeUsage | None = None
    """Null for a judge that asks no model."""
    served: Serving | None = None
    """Null for a judge that asks no model."""
    accepted_faults: list[str] = Field(default_factory=list)
    """What failed and was accepted at the run's word (``--accept-faults``)."""

    def claim_schedule(self) -> list[Asked]:
        """The requests that repeats of Detailed Alignment make, in their order: those of the claims, without what was
        asked only because an answer broke its contract."""
        return [asked for asked in self.schedule if asked.purpose in OF_CLAIMS and not asked.again]

    @model_validator(mode="after")
    def _one_answer_a_claim(self) -> Self:
        twice = [
            claim for claim, times in Counter(made.claim for made in (*self.claims, *self.beneath)).items() if times > 1
        ]
        if twice:
            raise ValueError(f"claim {twice[0]!r} is answered more than once")
        return self
