"""The cases of a suite as reviewers who did not write them are asked about them (paper, ``sec:benchmark-suite``).

A reviewer sees what an agent sees: the prompt, the reference views, the palette's names, the budget. Truth, recipe,
requirements and the readable name of a case are not shown. Each reviewer has an order of their own.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from typing import Any, Final, get_args

from c4s.errors import BadInput
from c4s.human.answer_log import AnswerLog
from c4s.human.desk import DeskProgress
from c4s.human.pictures import bare_png
from c4s.protocol.settings import SETTING_TITLES, is_construction
from c4s.records.asking import MOST_NOTE, CaseReview, ReviewAnswer, ReviewQuestion
from c4s.records.suite import AgentCase, SuiteFolder

NOTE: Final = "note"
QUESTIONS: Final[dict[ReviewQuestion, tuple[str, str]]] = {
    "clear": (
        "Is it clear what is asked for, with one meaning?",
        "Is it clear what is asked for, and which changes count?",
    ),
    "solvable": (
        "Can it be built from the assets listed here?",
        "Can every change be told from the reference views alone?",
    ),
    "consistent": (
        "Is the description free of contradictions and of things that cannot be?",
        "Do text and reference views agree with each other?",
    ),
}
"""What is asked of a case with a prompt, and of a repair."""


class ReviewDesk:
    """Asks reviewers about the cases of a suite."""

    kind = "review"

    def __init__(self, suite: SuiteFolder, reviewers: Sequence[str], log: AnswerLog, secret: str) -> None:
        """Answers about another build of the suite are kept and do not count. ``BadInput`` for a log of other rows."""
        self._suite, self._log = suite, log
        record = suite.suite()
        self._id, self._digest = record.suite_id, record.sha256()
        self.people: Sequence[str] = tuple(reviewers)
        self._order = {name: _drawn([case.alias for case in record.cases], f"{secret}/{name}") for name in reviewers}
        rows = [CaseReview.parse(row, where="reviews") for row in log.rows]
        self._given = {
            (row.reviewer, row.alias): row for row in rows if (row.suite, row.suite_digest) == (self._id, self._digest)
        }

    @property
    def title(self) -> str:
        """Of the organiser's page."""
        return f"Review of the suite {self._id}"

    def count(self, person: str) -> int:
        """Cases."""
        return len(self._order[person])

    def done(self, person: str) -> int:
        """How many cases are reviewed."""
        order = self._order[person]
        return next((at for at, alias in enumerate(order) if (person, alias) not in self._given), len(order))

    def question(self, person: str, number: int) -> dict[str, Any]:
        """What the page of a case shows."""
        case = self._case(person, number)
        builds = is_construction(case.setting)
        return {
            "setting": SETTING_TITLES[case.setting],
            "prompt": case.prompt,
            "views": range(1, len(case.reference_views) + 1),
            "assets": [path.rpartition("/")[2].partition(".")[0] for path in case.catalog],
            "budget": case.budget,
            "questions": {name: texts[0 if builds else 1] for name, texts in QUESTIONS.items()},
            "answers": get_args(ReviewAnswer),
            "most_note": MOST_NOTE,
        }

    def picture(self, person: str, number: int, name: str) -> bytes | None:
        """A reference view by its number."""
        case = self._case(person, number)
        if name not in [str(one) for one in range(1, len(case.reference_views) + 1)]:
            return None
        return bare_png((self._suite.agent(case.alias) / case.reference_views[int(name) - 1]).read_bytes())

    def answer(self, person: str, number: int, fields: Mapping[str, str]) -> None:
        """Keep a review: an answer to each question, and a note where one of them is no."""
        alias = self._order[person][number - 1]
        asked = {name: fields.get(name, "") for name in QUESTIONS}
        note = fields.get(NOTE, "").strip()
        if set(fields) - {*QUESTIONS, NOTE} or any(value not in get_args(ReviewAnswer) for value in asked.values()):
            raise BadInput("answer each question with yes, no or unsure")
        if "no" in asked.values() and not note:
            raise BadInput("say in the note what is wrong: one of the answers is no")
        review = CaseReview.parse(
            {
                "suite": self._id,
                "suite_digest": self._digest,
                "reviewer": person,
                "alias": alias,
                "answers": asked,
                "note": note,
            }
        )
        earlier = self._given.get((person, alias))
        if earlier == review:
            return
        if earlier is not None:
            raise BadInput("you have answered this one already, and answers are not changed")
        if number != self.done(person) + 1:
            raise BadInput("another one comes before this one")
        self._log.add(review.plain())
        self._given[person, alias] = review

    def progress(self) -> list[DeskProgress]:
        """A row a reviewer."""
        return [
            DeskProgress(name, "cases", sum((name, alias) in self._given for alias in order), len(order))
            for name, order in self._order.items()
        ]

    def told(self) -> list[dict[str, str]]:
        """Cases that a reviewer said no or unsure of, with their readable names and notes."""
        names = {case.alias: case.case_id for case in self._suite.suite().cases}
        return [
            {
                "case": names[row.alias],
                "who": row.reviewer,
                "what": ", ".join(f"{key}: {value}" for key, value in row.answers.items() if value != "yes"),
                "note": row.note,
            }
            for row in self._given.values()
            if row.note or set(row.answers.values()) != {"yes"}
        ]

    def _case(self, person: str, number: int) -> AgentCase:
        return self._suite.agent_case(self._order[person][number - 1])


def _drawn(aliases: list[str], secret: str) -> list[str]:
    """Cases in an order that a secret decides."""
    return sorted(aliases, key=lambda alias: hashlib.sha256(f"{secret}/{alias}".encode()).digest())
