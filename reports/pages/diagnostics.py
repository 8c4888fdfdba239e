"""What stands behind the scores of a leaderboard: spatial errors, repairs by category and by what they spoil, how
agents work, and how firm the order is (paper: fig:analysis-diagnostics, fig:joint-trajectory-2, fig:eus-summary)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, Final

from c4s.records.analysis import Table
from reports.frame import Answer, Board, Grid, SiteContext, SitePage, grid, links
from reports.frame.board import Row
from reports.text import number

MOST_BARS: Final = 4
"""Configurations that a category has bars of: the highest ranked ones, as in the paper's figure."""
STUDIES: Final = (
    "conditional-spatial",
    "profiles",
    "selective-repair",
    "tool-usage",
    "python-operations",
    "stability",
    "weight-sensitivity",
    "embodied-utility",
)
UTILITY_MORE: Final = ("rooms", "difference", "alignment", "reasons")
"""Tables of the Embodied Utility Score beside panels and changes."""


@dataclass(frozen=True)
class FigurePart:
    """A part of a bar: its kind, which has a colour, where it starts and how long it is, in per cent of the widest."""

    kind: str
    start: float
    length: float


@dataclass(frozen=True)
class FigureBar:
    """A bar with its name and its numbers in words."""

    label: str
    parts: Sequence[FigurePart]
    told: str
    low: float | None = None
    high: float | None = None
    """Ends of its interval, in per cent of the widest."""
    best: bool = False
    configuration: bool = False
    """Whether the label is one."""


@dataclass(frozen=True)
class FigureBars:
    """FigureBars under a title."""

    title: str
    rows: Sequence[FigureBar]


@dataclass(frozen=True)
class Utility:
    """What is shown of the Embodied Utility Score."""

    panels: Sequence[Grid]
    changes: Sequence[tuple[FigureBars, Grid]]
    """Against the matched input, as a plot and as a table."""
    more: Sequence[Grid]


def pages(site: SiteContext) -> Iterator[SitePage]:
    """A page a leaderboard; the first one's is in the navigation."""
    for place, board in enumerate(site.boards):
        yield SitePage(
            links.diagnostics(board),
            "diagnostics.html.j2",
            partial(_values, site, board),
            site.stamp(board),
            navigation="" if place else "Diagnostics",
        )


def _values(site: SiteContext, board: Board) -> dict[str, Any]:
    answers = {name: site.answer(board, name) for name in STUDIES}
    return {
        "board": board,
        "boards": site.boards,
        "answers": answers,
        "spatial": [_shares(table) for name in ("kinds", "configurations") if (table := _table(answers, name))],
        "categories": _categories(board, answers["profiles"]),
        "recovery": _recovery(board, answers["selective-repair"]),
        "kinds": _shares_of(answers["selective-repair"].rows("kinds")),
        "calls": _calls(board, answers["tool-usage"]),
        "operations": _operations(board, answers["python-operations"]),
        "firm": [_grid(board, answers["stability"], "stability"), _grid(board, answers["stability"], "without_source")],
        "weights": _grid(board, answers["weight-sensitivity"], "sensitivity_public"),
        "utility": _utility(board, answers["embodied-utility"]),
    }


def _table(answers: dict[str, Answer], name: str) -> Table | None:
    return answers["conditional-spatial"].table(name)


def _shares(table: Table) -> FigureBars:
    """Shares of mismatches with their intervals."""
    rows = [
        FigureBar(
            str(row["of_what"]) if table.name == "configurations" else str(row["of_what"]).capitalize(),
            [FigurePart("mismatched", 0.0, 100 * share)],
            _of_all(row["count"], row["of"]),
            _hundredfold(row.get("share_low")),
            _hundredfold(row.get("share_high")),
            configuration=table.name == "configurations",
        )
        for row in table.rows
        if isinstance(share := row["share"], float)
    ]
    return FigureBars(table.title, rows)


def _shares_of(rows: Sequence[Row]) -> FigureBars | None:
    """Kinds of unintended changes, of the complete recoveries."""
    told = [
        FigureBar(
            str(row["kind"]),
            [FigurePart("spoilt", 0.0, 100 * row["submissions"] / row["of"])],
            _of_all(row["submissions"], row["of"]),
        )
        for row in rows
        if row["of"]
    ]
    return FigureBars("Kinds of unintended changes in complete recoveries; they overlap", told) if told else None


def _of_all(count: Any, of: Any) -> str:
    return f"{count} of {of} · {100 * count / of:.1f} %"


def _categories(board: Board, answer: Answer) -> list[FigureBars]:
    """Each operation category with the highest ranked configurations, the best of them marked."""
    table = answer.table("categories")
    if table is None:
        return []
    rows = {str(row["configuration"]): row for row in table.rows if row["ranked"]}
    chosen = [name for name in board.order if name in rows][:MOST_BARS]
    found = []
    for column in table.columns:
        if column.unit != "score":
            continue
        scores = {name: float(value) for name in chosen if isinstance(value := rows[name].get(column.name), float)}
        most = max(scores.values(), default=0.0)
        bars = [
            FigureBar(
                name, [FigurePart("score", 0.0, 100 * score)], number(score), best=score == most > 0, configuration=True
            )
            for name, score in scores.items()
        ]
        found.append(FigureBars(column.title, bars))
    return found


def _recovery(board: Board, answer: Answer) -> list[FigureBars]:
    """Repairs by domain: complete and nothing else changed, complete with more changed, the rest."""
    rows = _ordered(board, answer.rows("configurations"))
    domains = dict.fromkeys(str(row["domain"]) for row in rows)
    made = [
        FigureBars(
            domain,
            [
                FigureBar(
                    row["configuration"],
                    _stacked([(kind, row[kind]) for kind in ("clean", "spoilt", "incomplete")], row["cases"]),
                    f"{row['clean']} + {row['spoilt']} of {row['cases']}",
                    configuration=True,
                )
                for row in rows
                if row["domain"] == domain and row["cases"]
            ],
        )
        for domain in domains
    ]
    return [one for one in made if one.rows]


def _calls(board: Board, answer: Answer) -> list[FigureBars]:
    """Mean calls of a run by setting, Python apart from other tools."""
    rows = [row for row in _ordered(board, answer.rows("calls")) if row["set"] == "public"]
    most = max((float(row["calls"]) for row in rows), default=0.0)
    settings = dict.fromkeys(str(row["setting"]) for row in rows)
    return [
        FigureBars(
            setting,
            [
                FigureBar(
                    row["configuration"],
                    _stacked([("python", row["python"]), ("other", row["other"])], most),
                    f"{number(row['python'], 1)} + {number(row['other'], 1)}",
                    configuration=True,
                )
                for row in rows
                if row["setting"] == setting
            ],
        )
        for setting in settings
    ]


def _operations(board: Board, answer: Answer) -> list[tuple[str, Grid]]:
    """Operation families in Python scripts by setting, as heat maps."""
    table = answer.table("shares")
    if table is None:
        return []
    public = table.model_copy(update={"rows": [row for row in table.rows if row["set"] == "public"]})
    kept = [column.name for column in table.columns if column.name not in ("setting", "set")]
    return [
        (setting, grid(public, columns=kept, heat=True, order=board.order, where=partial(_is_of, setting)))
        for setting in dict.fromkeys(str(row["setting"]) for row in public.rows)
    ]


def _is_of(setting: str, row: Row) -> bool:
    return bool(row["setting"] == setting)


def _grid(board: Board, answer: Answer, name: str) -> Grid | None:
    table = answer.table(name)
    return None if table is None else grid(table, order=board.order)


def _utility(board: Board, answer: Answer) -> Utility | None:
    """The study's panels and changes; None where no trial of the leaderboard has a navigation verdict."""
    tables = [table for table in answer.findings.tables if table.rows]
    panels = [table for table in tables if table.name.startswith("panel_")]
    if not any(row["records"] for table in panels for row in table.rows):
        return None
    changes = [table for table in tables if table.name.startswith("change_")]
    return Utility(
        panels=[grid(table) for table in panels],
        changes=[(_changes(board, table), grid(table, order=board.order)) for table in changes],
        more=[grid(table) for table in tables if table.name in UTILITY_MORE],
    )


def _changes(board: Board, table: Table) -> FigureBars:
    """Changes to both sides of a middle that is no change; the widest fills its side."""
    known = [row for row in _ordered(board, table.rows) if isinstance(row["change"], float)]
    most = max((abs(float(row["change"])) for row in known), default=0.0) or 1.0
    rows = []
    for row in known:
        change = round(float(row["change"]), 3) or 0.0
        length = 50 * abs(change) / most
        part = FigurePart("score" if change >= 0 else "mismatched", 50.0 - length * (change < 0), length)
        error = "" if row["se"] is None else f" ± {number(row['se'])}"
        rows.append(FigureBar(row["configuration"], [part], f"{change:+.3f}{error}", configuration=True))
    return FigureBars(f"{table.title} (the middle is no change)", rows)


def _stacked(values: Sequence[tuple[str, float]], most: float) -> list[FigurePart]:
    parts, start = [], 0.0
    for kind, value in values:
        length = 100 * value / most if most else 0.0
        parts.append(FigurePart(kind, start, length))
        start += length
    return parts


def _ordered(board: Board, rows: Sequence[Row]) -> list[Row]:
    return sorted(rows, key=lambda row: board.order.index(row["configuration"]))


def _hundredfold(value: Any) -> float | None:
    return 100 * value if isinstance(value, float) else None
