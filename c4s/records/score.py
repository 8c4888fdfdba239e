"""A trial's score with its parts."""

from __future__ import annotations

from typing import ClassVar, Literal, Self

from pydantic import Field, model_validator

from c4s.protocol.settings import Setting
from c4s.records.base import Sealed

CaseStatus = Literal[
    "measured",
    "measured_with_missing_zero",
    "zero_invalid_candidate",
    "zero_missing_submission",
    "zero_missing_result",
    "pending",
]


class TrialScore(Sealed):
    """A trial's case score with its parts. ``status`` keeps the reasons for a zero apart."""

    REMEDY: ClassVar[str] = "run the same `c4s run` again: it is set aside and made anew"
    schema_version: Literal["c4s.score.v1"] = "c4s.score.v1"
    case_id: str
    setting: Setting
    configuration: str
    repeat: int
    status: CaseStatus
    score: float | None = Field(ge=0.0, le=1.0, allow_inf_nan=False, strict=True)
    reason: str = ""
    components: dict[str, float | None] = Field(default_factory=dict)
    """What the score is made of: the numbers that the setting's verifiers add (``c4s.verify.registry``), by name."""
    policy: str
    judge: str
    engine: str
    retained_attempt: int | None = None
    verdicts: dict[str, str] = Field(default_factory=dict)
    """SHA-256 of each verdict's file that it was made from, by verifier."""

    @model_validator(mode="after")
    def _whole(self) -> Self:
        if (self.score is None) != (self.status == "pending"):
            raise ValueError(f"a trial that is {self.status} {'has no' if self.score is None else 'has a'} score")
        if self.status.startswith("zero_") and self.score != 0.0:
            raise ValueError(f"a trial that is {self.status} has the score 0, not {self.score}")
        return self
