"""What a local server of questions keeps: who may sit at it, and what reviewers said of a suite's cases.

::

    <reviews>/<suite>/access.json      Access: the keys of the links; for nobody but the organiser
    <reviews>/<suite>/reviews.jsonl    CaseReview, a line an answer, only ever added to

A study of people has the same files in its own folder (``c4s.records.human``).
"""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from pydantic import Field

from c4s.names import Name
from c4s.records.base import Record

ORGANISER = "organiser"
"""Who sees how far everybody is, and nothing else."""
MOST_NOTE = 2_000
"""Characters of a reviewer's note."""
ReviewAnswer = Literal["yes", "no", "unsure"]
ReviewQuestion = Literal["clear", "solvable", "consistent"]


class Access(Record):
    """The links of a server: whoever knows a key is who it belongs to."""

    schema_version: Literal["c4s.access.v1"] = "c4s.access.v1"
    port: int
    """The port on loopback, the same each time, so that a link outlives a restart."""
    secret: str
    """What places on the screen are drawn from: nobody who knows the design can tell them."""
    keys: dict[Name, str]
    """By who sits there; ``organiser`` is one of them."""


class CaseReview(Record):
    """What one reviewer says of one case."""

    schema_version: Literal["c4s.case-review.v1"] = "c4s.case-review.v1"
    suite: Name
    suite_digest: str
    reviewer: Name
    alias: Name
    """The case as an agent knows it; its readable name is not shown to a reviewer."""
    answers: dict[ReviewQuestion, ReviewAnswer]
    note: str = Field(default="", max_length=MOST_NOTE)


class ReviewFolder:
    """The files of a suite's reviews."""

    def __init__(self, root: Path) -> None:
        self.root = root

    @property
    def access(self) -> Path:
        """Keys of the links."""
        return self.root / "access.json"

    @property
    def reviews(self) -> Path:
        """What came back."""
        return self.root / "reviews.jsonl"
