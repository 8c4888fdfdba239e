"""What a local server asks of people, whatever it asks: each has a row of questions, answered one after the other."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol


@dataclass(frozen=True)
class DeskProgress:
    """How far one person is with one kind of question."""

    person: str
    question: str
    done: int
    of: int


class QuestionDesk(Protocol):
    """Questions of some people and where their answers go. Questions of a person count from 1."""

    @property
    def kind(self) -> str:
        """Which pages show it."""

    @property
    def title(self) -> str:
        """What the organiser calls it."""

    @property
    def people(self) -> Sequence[str]:
        """Who is asked."""

    def count(self, person: str) -> int:
        """How many questions a person is asked."""

    def done(self, person: str) -> int:
        """How many are answered: always the first ones."""

    def question(self, person: str, number: int) -> dict[str, Any]:
        """All that the page of a question may show."""

    def picture(self, person: str, number: int, name: str) -> bytes | None:
        """A PNG of a question, pixels alone; None where it has none of this name."""

    def answer(self, person: str, number: int, fields: Mapping[str, str]) -> None:
        """Keep an answer. The same again changes nothing.

        Raises:
            BadInput: it is no answer to this question, another one was given already, or it is not this one's turn.
        """

    def progress(self) -> list[DeskProgress]:
        """How far everybody is."""

    def told(self) -> list[dict[str, str]]:
        """What people said in words, for the organiser."""
