"""The page of a configuration: how it does on everything, beside the field."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any, Final

from c4s.records.analysis import Table, Value
from reports.frame import Answer, Board, Grid, SiteContext, SitePage, grid, links
from reports.frame.asked import made_with
from reports.frame.board import Row
from reports.pages.leaderboard import SCORES, STUDIED
from reports.pages.matrix import mean_of

MOST_ENDS: Final = 5
"""Strong and weak cases that are shown."""
MOST_ERRORS: Final = 8
ALL: Final = "all"


@dataclass(frozen=True)
class Place:
    """A number of a configuration among those of the field."""

    title: str
    own: float
    low: float | None
    high: float | None
    others: list[float]
    place: int
    """1 where nobody has more."""


@dataclass(frozen=True)
class Against:
    """A case: the configuration's mean beside that of the other ranked ones."""

    trial: Row
    own: float
    field: float

    @property
    def difference(self) -> float:
        """Of the two."""
        return self.own - self.field


def pages(site: SiteContext) -> Iterator[SitePage]:
    """A page a configuration of each leaderboard."""
    for board in site.boards:
        for standing in board.standings:
            path = links.configuration(board, standing["configuration"])
            yield SitePage(path, "configuration.html.j2", partial(_values, site, board, standing), site.stamp(board))


def _values(site: SiteContext, board: Board, standing: Row) -> dict[str, Any]:
    name = standing["configuration"]
    answers = {study: site.answer(board, study) for study in STUDIES}
    main = {str(row["configuration"]): row for row in answers["main-results"].rows("main")}
    against, trials = _against(board, name), _trials(site, board, name)
    return {
        "board": board,
        "standing": standing,
        "ends": main.get(name, {}),
        "answers": answers,
        "profile": _profile(board, standing, main.get(name, {})),
        "categories": _category_profile(answers["profiles"], name),
        "tables": {study: _own(answers[study], name) for study in STUDIES},
        "cost": next((row for row in answers["costs"].rows("costs_public") if row["configuration"] == name), None),
        "errors": [
            row
            for row in answers["execution-errors"].rows("errors")
            if row["configuration"] == name and row["setting"] == ALL
        ][:MOST_ERRORS],
        "strong": against[: min(MOST_ENDS, (len(against) + 1) // 2)],
        "weak": against[::-1][: min(MOST_ENDS, len(against) // 2)],
        "zeros": [row for row in board.zeros if row["configuration"] == name],
        "trials": trials,
        "made_with": made_with(site.warehouse, board, name),
        "content": sorted({row["trial"]["configuration_digest"] for row in trials}),
        "sandboxes": sorted({row["trial"]["sandbox"] for row in trials if row["trial"]["sandbox"]}),
        "runs": sorted({row["trial"]["run_id"] for row in trials}),
        "pictured": any(row["picture"] for row in trials),
    }


STUDIES: Final = {
    "main-results": (),
    "profiles": (),
    "costs": (),
    "tool-usage": ("calls",),
    "python-operations": ("submissions", "shares"),
    "execution-errors": (),
    "repair-rates": ("rates_public",),
    "selective-repair": ("configurations",),
    "repeats": ("spread", "complete_recovery"),
    "reliability": ("reliability",),
}
"""Studies of which the page tells, with the tables whose rows of the configuration it shows."""


def _against(board: Board, name: str) -> list[Against]:
    """The cases that the field did too, the strongest first."""
    ranked = {row["configuration"] for row in board.standings if row["ranked"]} - {name}
    found = []
    for case in board.cases:
        trials = case["scores"].get(name, [])
        own = mean_of(trials)
        field = [mean for one in ranked if (mean := mean_of(case["scores"].get(one, []))) is not None]
        if own is not None and field:
            found.append(Against(trials[0], own, sum(field) / len(field)))
    return sorted(found, key=lambda one: (-one.difference, one.trial["case_id"]))


def _own(answer: Answer, name: str) -> list[Grid]:
    """The configuration's rows of a study's tables, without the column that names it."""

    def own(row: Row) -> bool:
        return bool(row["configuration"] == name)

    made = [_narrow(table, own) for table in answer.findings.tables if table.name in STUDIES[answer.study]]
    return [one for one in made if one.rows]


def _narrow(table: Table, where: Callable[[Row], bool]) -> Grid:
    known = {column.name for column in table.columns}
    empty = {column.name for column in table.columns if not any(_is_told(row, column.name) for row in table.rows)}
    ends = {f"{name}_{end}" for name in known for end in ("low", "high")}
    kept = [column.name for column in table.columns if column.name not in {"configuration", "set"} | ends | empty]
    return grid(table, columns=kept, heat=table.name == "shares", where=where)


def _is_told(row: dict[str, Value], name: str) -> bool:
    return row.get(name) is not None


def _profile(board: Board, standing: Row, ends: Row) -> list[Place]:
    """Where each score stands among those of the ranked configurations."""
    found = []
    for name, title in SCORES.items():
        if standing[name] is None:
            continue
        studied = STUDIED.get(name, name)
        others = [
            float(row[name])
            for row in board.standings
            if row["ranked"] and row[name] is not None and row["configuration"] != standing["configuration"]
        ]
        low, high = (ends.get(f"{studied}_{end}") for end in ("low", "high"))
        found.append(_place(title, float(standing[name]), low, high, others))
    return found


def _category_profile(answer: Answer, name: str) -> list[Place]:
    """The same of operation categories and requirement families."""
    found = []
    for table in answer.findings.tables:
        own = next((row for row in table.rows if row["configuration"] == name), None)
        if own is None:
            continue
        for column in table.columns:
            value = own.get(column.name)
            if column.unit == "score" and isinstance(value, float):
                others = [
                    one
                    for row in table.rows
                    if row.get("ranked")
                    and row["configuration"] != name
                    and isinstance(one := row.get(column.name), float)
                ]
                found.append(_place(column.title, value, None, None, others))
    return found


def _place(title: str, own: float, low: float | None, high: float | None, others: list[float]) -> Place:
    return Place(title, own, low, high, sorted(others), 1 + sum(one > own for one in others))


def _trials(site: SiteContext, board: Board, name: str) -> list[Row]:
    return [
        {"case": case, "trial": trial, "picture": site.thumbnail(board, case["case_id"], trial["trial_id"])}
        for case in board.cases
        for trial in case["scores"].get(name, [])
    ]
