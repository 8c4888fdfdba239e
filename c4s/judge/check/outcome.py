"""What a judge said of one claim whose truth is known."""

from __future__ import annotations

from typing import Literal, TypeAlias

from c4s.records.base import Record
from c4s.records.judgement import DECIDED, Answer, Rung

Key: TypeAlias = tuple[str, str, str]


class Outcome(Record):
    """One claim on one variant of a scene."""

    scene: str
    variant: str
    claim: str
    kind: str
    text: str
    pair: str
    """The same for two outcomes of one scene, of which one holds and one does not."""
    holds: bool
    """The truth, from how the scene was made."""
    answer: Answer
    confidence: float | None = None
    stage: Rung = "state"

    @property
    def decided(self) -> bool:
        """Whether the judge said yes or no."""
        return self.answer in DECIDED

    @property
    def right(self) -> bool:
        """Whether it said what is so; what it left open is not right."""
        return self.answer == ("MATCH" if self.holds else "MISMATCH")

    @property
    def error(self) -> Literal["false accept", "false reject", ""]:
        """The kind of a wrong decision; empty for a right one and where nothing was decided."""
        if self.right or not self.decided:
            return ""
        return "false reject" if self.holds else "false accept"

    @property
    def key(self) -> Key:
        """What was asked."""
        return self.scene, self.variant, self.claim
