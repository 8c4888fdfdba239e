"""The triplets of a study as its annotators are asked them: letters for candidates, places on the screen drawn anew.

What is shown names nothing of the design: a question is a number, a candidate a letter, a picture a letter and a
number. The three annotators of a triplet see its candidates in the three turns of one order, so over a study every
candidate is as often first, second and third on a screen. The order is drawn from the server's own secret: the seed of
a design may be public.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from typing import Any

from c4s.errors import BadInput
from c4s.human.answer_log import AnswerLog
from c4s.human.desk import DeskProgress
from c4s.human.pictures import bare_png
from c4s.human.study import OpenStudy
from c4s.protocol.criteria import CRITERIA
from c4s.records.human import PICTURES, AnnotatorSheet, HumanRanking, SheetTask

LETTERS = "ABC"
RANKS = ("best", "middle", "worst")
Place = tuple[str, str]
"""Task and criterion."""


class RankingDesk:
    """Asks a study's annotators."""

    kind = "ranking"

    def __init__(self, opened: OpenStudy, log: AnswerLog, secret: str) -> None:
        """``BadInput`` where the holdout is open, or the log holds what this study did not ask."""
        self._opened, self._log, self._secret = opened, log, secret
        self._check_closed()
        self._sheets = {name: AnnotatorSheet.read(opened.folder.sheet(name)).tasks for name in self.people}
        self._turns = {
            (task.task, name): turn for task in opened.study.tasks for turn, name in enumerate(task.annotators)
        }
        self._given: dict[str, dict[Place, list[str]]] = {name: {} for name in self.people}
        for row in log.rows:
            kept = HumanRanking.parse(row, where=str(opened.folder.answers))
            if kept.study != opened.study.study or kept.annotator not in self._given:
                raise BadInput("this file holds answers of another study", where=str(opened.folder.answers))
            self._given[kept.annotator][kept.task, kept.criterion] = kept.order

    @property
    def title(self) -> str:
        """Of the organiser's page."""
        return f"Study {self._opened.study.study}"

    @property
    def people(self) -> Sequence[str]:
        """The annotators."""
        return self._opened.study.annotators

    def count(self, person: str) -> int:
        """Questions of an annotator, the primary ones first."""
        return len(self._sheets[person])

    def done(self, person: str) -> int:
        """How many are answered."""
        given = self._given[person]
        return next(
            (at for at, task in enumerate(self._sheets[person]) if (task.task, task.criterion) not in given),
            self.count(person),
        )

    def question(self, person: str, number: int) -> dict[str, Any]:
        """What is asked: texts and letters, and no name of the design."""
        task = self._task(person, number)
        own = self._sheets[person]
        alike = [at for at, one in enumerate(own, start=1) if one.criterion == task.criterion]
        return {
            "title": task.title,
            "question": task.question,
            "prompt": task.prompt,
            "letters": LETTERS,
            "ranks": RANKS,
            "views": range(1, PICTURES + 1),
            "block": number - alike[0] + 1,
            "of_block": len(alike),
            "first_of_block": number == alike[0],
        }

    def picture(self, person: str, number: int, name: str) -> bytes | None:
        """The picture ``A-1``: a letter and the number of a view."""
        letter, _, view = name.partition("-")
        if letter not in tuple(LETTERS) or view not in [str(one) for one in range(1, PICTURES + 1)]:
            return None
        task = self._task(person, number)
        candidate = self._shown(person, task)[LETTERS.index(letter)]
        return bare_png(self._opened.folder.picture(candidate, int(view)).read_bytes())

    def answer(self, person: str, number: int, fields: Mapping[str, str]) -> None:
        """Keep a ranking: a letter for each of ``best``, ``middle`` and ``worst``."""
        letters = [fields.get(rank, "") for rank in RANKS]
        if set(fields) != set(RANKS) or sorted(letters) != list(LETTERS):
            raise BadInput("give each scene a place of its own: no ties, and none left out")
        task = self._task(person, number)
        shown = self._shown(person, task)
        order = [shown[LETTERS.index(letter)] for letter in letters]
        earlier = self._given[person].get((task.task, task.criterion))
        if earlier == order:
            return
        if earlier is not None:
            raise BadInput("you have answered this one already, and answers are not changed")
        if number != self.done(person) + 1:
            raise BadInput("another one comes before this one")
        self._check_closed()
        ranking = HumanRanking(
            study=self._opened.study.study, annotator=person, task=task.task, criterion=task.criterion, order=order
        )
        self._log.add(ranking.plain())
        self._given[person][task.task, task.criterion] = order

    def progress(self) -> list[DeskProgress]:
        """A row an annotator and criterion."""
        rows = []
        for person in self.people:
            for criterion in self._opened.study.criteria:
                own = [task for task in self._sheets[person] if task.criterion == criterion]
                done = sum((task.task, criterion) in self._given[person] for task in own)
                rows.append(DeskProgress(person, CRITERIA[criterion].title, done, len(own)))
        return rows

    def told(self) -> list[dict[str, str]]:
        """Nothing: a ranking has no words."""
        return []

    def _check_closed(self) -> None:
        if self._opened.is_opened():
            raise BadInput(
                "the holdout of this study is open: no ranking is taken any more", where=self._opened.study.study
            )

    def _task(self, person: str, number: int) -> SheetTask:
        return self._sheets[person][number - 1]

    def _shown(self, person: str, task: SheetTask) -> list[str]:
        """The candidates of a task, left to right on this annotator's screen."""

        def drawn(name: str) -> bytes:
            return hashlib.sha256(f"{self._secret}/{task.task}/{name}".encode()).digest()

        base = sorted((one.candidate for one in task.candidates), key=drawn)
        criterion = list(CRITERIA).index(task.criterion)
        turn = (self._turns[task.task, person] + drawn("")[0] + criterion) % len(base)
        return base[turn:] + base[:turn]
