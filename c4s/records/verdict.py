"""A verdict: one verifier's report on one submission. Pure data; every verifier returns one."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, ClassVar, Literal, Self

from pydantic import Field, model_validator

from c4s.records.base import Sealed

Status = Literal["measured", "not_applicable", "not_evaluated", "error", "valid", "invalid"]


class Verdict(Sealed):
    """One verifier's report.

    ``status`` follows the paper (evaluation protocol): a ``measured`` score is a finite number in [0, 1] and is no
    pass mark; every other status carries no number. A verdict that says otherwise cannot be made (``ValueError``).
    Integrity is ``valid`` or ``invalid``.
    """

    REMEDY: ClassVar[str] = "run the same `c4s run` again: it is set aside and made anew"
    schema_version: Literal["c4s.verdict.v1"] = "c4s.verdict.v1"
    verifier: str
    """Name of the verifier, as in ``c4s.verify.registry``."""
    status: Status
    score: float | None = Field(default=None, strict=True)
    policy: str
    """Id of the policy under which it was made."""
    measurements: dict[str, Any] = Field(default_factory=dict)
    population: dict[str, int] = Field(default_factory=dict)
    """How many actors, targets or requirements were eligible, evaluated, unresolved."""
    advisories: list[dict[str, Any]] = Field(default_factory=list)
    """Known oddities of the protocol in this case: ``{"code", "text", "actors"}``. They never change the score."""
    inputs: dict[str, str] = Field(default_factory=dict)
    """SHA-256 of each file that was read."""
    made_by: str = ""
    """Version of the code that made it: release and digest of the sources that decide."""
    reason: str = ""
    """Why there is no number, or why it is invalid."""

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """A copy with other fields, as whole as the verdict."""
        made = super().model_copy(update=update, deep=deep)
        made._check()
        return made

    @model_validator(mode="after")
    def _whole(self) -> Self:
        self._check()
        return self

    def _check(self) -> None:
        if self.status != "measured":
            if self.score is not None:
                raise ValueError(f"a verdict that is {self.status} has no score")
        elif self.score is None or not math.isfinite(self.score) or not 0.0 <= self.score <= 1.0:
            raise ValueError(f"a measured score is a finite number in [0, 1], not {self.score}")
