"""The leaderboards: which results are compared with each other, and in which order."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from c4s.files import digest
from reports.text import slug
from warehouse.analyses import StudyScope
from warehouse.database import rows
from warehouse.release import PrivateStanding, private_standings

Row = dict[str, Any]
"""A row of a table or question of the warehouse, by column."""
Field = tuple[str, str, str, str, str, str]
"""What results must share to be compared: suite, the digest of its build, policy, judge, its version, engine."""

PUBLIC: Final = "visibility = 'public'"


@dataclass(frozen=True)
class Board:
    """One leaderboard: results on public cases that share the build of a suite, policy, judge, its version and engine.

    Of private cases nothing but ``private`` is read.
    """

    suite: str
    suite_digest: str
    policy: str
    judge: str
    judge_version: str
    engine: str
    standings: list[Row]
    cases: list[Row]
    """One row a case: its fields and ``scores``, configuration to trial row."""
    zeros: list[Row]
    private: list[PrivateStanding]
    """What is told of the suite's private cases."""

    @property
    def order(self) -> list[str]:
        """Configurations in the one order that they have on every page: as they stand on the leaderboard."""
        return [row["configuration"] for row in self.standings]

    @property
    def scope(self) -> StudyScope:
        """The public results of the board, as studies are asked of them."""
        return StudyScope(
            suite=self.suite,
            suite_digest=self.suite_digest,
            policy=self.policy,
            judge=self.judge,
            judge_version=self.judge_version,
            engine=self.engine,
            visibility="public",
        )

    @property
    def title(self) -> str:
        """What tells it from the others."""
        return f"{self.suite} · {self.judge} · {self.engine} · {self.policy}"

    @property
    def anchor(self) -> str:
        """Its place on a page of several."""
        return f"board-{self._told()}"

    def page(self, name: str) -> str:
        """The file name of the board's page of a case or an agent: no two boards of a suite share one."""
        return f"{slug(self.suite)}--{slug(name)}--{self._told()}.html"

    def _told(self) -> str:
        return digest([self.policy, self.judge, self.judge_version, self.engine])[:8]


def boards(warehouse: Path) -> list[Board]:
    """The leaderboards of the latest build of each suite, those of most results first."""
    standings: dict[Field, list[Row]] = defaultdict(list)
    for row in rows(warehouse, f"SELECT * FROM leaderboard WHERE {PUBLIC}"):
        standings[_field(row)].append(row)
    trials: dict[Field, list[Row]] = defaultdict(list)
    scored = f"SELECT * FROM case_scores WHERE latest AND {PUBLIC} ORDER BY setting, case_id, repeat"
    for row in rows(warehouse, scored):
        trials[_field(row)].append(row)
    private: dict[Field, list[PrivateStanding]] = defaultdict(list)
    for told in private_standings(warehouse):
        private[_field(told.plain())].append(told)
        standings[_field(told.plain())]
    zeros = rows(warehouse, f"SELECT * FROM zero_reasons WHERE {PUBLIC}")
    made = [
        Board(
            *field,
            standings=found,
            cases=_by_case(trials[field]),
            zeros=[row for row in zeros if _is_of(row, field)],
            private=private[field],
        )
        for field, found in standings.items()
    ]
    return sorted(made, key=lambda board: -len(board.cases) * len(board.standings))


def _field(row: Row) -> Field:
    return row["suite"], row["suite_digest"], row["policy"], row["judge"], row["judge_version"], row["engine"]


def _is_of(row: Row, field: Field) -> bool:
    """Whether a row that names its build by the start of its digest belongs to a board."""
    suite, digest, *others = field
    told = (row["suite"], row["build"], row["policy"], row["judge"], row["judge_version"], row["engine"])
    return told == (suite, digest[: len(row["build"])], *others)


def _by_case(trials: list[Row]) -> list[Row]:
    cases: dict[str, Row] = {}
    for trial in trials:
        case = cases.setdefault(trial["case_id"], {**trial, "scores": defaultdict(list)})
        case["scores"][trial["configuration"]].append(trial)
    return list(cases.values())
