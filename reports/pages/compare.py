"""Comparisons on one leaderboard: two configurations case by case, repeats and runs, and other leaderboards of the
same cases: what another policy, judge or engine would change."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any, Final

from reports.frame import Board, SiteContext, SitePage, grid, links
from reports.frame.board import Row
from reports.pages.matrix import mean_of
from reports.policies import under_policies

PAIR: Final = ("cases_of", "cases", "sources", "score", "score_low", "score_high", "score_p", "calls", "calls_p")
"""What is told of a pair, for each part of the cases."""
MOST_CHANGED: Final = 12
MOST_TOLD: Final = 32
"""Configurations of which every two are compared, the first of the leaderboard: 496 pairs."""


def pages(site: SiteContext) -> Iterator[SitePage]:
    """A page a leaderboard; the first one's is in the navigation."""
    for place, board in enumerate(site.boards):
        title = "" if place else "Compare"
        yield SitePage(
            links.compare(board), "compare.html.j2", partial(_values, site, board), site.stamp(), navigation=title
        )


def _values(site: SiteContext, board: Board) -> dict[str, Any]:
    whole = [str(row["configuration"]) for row in site.answer(board, "main-results").rows("main")]
    told_of = [name for name in board.order if name in whole][:MOST_TOLD]
    pairs = site.studies.pairs(board, told_of)
    told = [
        {"a": one.agents[0], "b": one.agents[1], "id": one.identity, "parts": _parts(one.rows("paired"))}
        for one in pairs
    ]
    data = {
        "order": board.order,
        "cases": [
            {
                "id": case["case_id"],
                "setting": case["setting"],
                "link": links.case(board, case["case_id"]),
                "scores": [mean_of(case["scores"].get(name, [])) for name in board.order],
            }
            for case in board.cases
        ],
        "pairs": told,
        "whole": whole,
    }
    drift = site.answer(board, "drift")
    return {
        "board": board,
        "boards": site.boards,
        "data": site.put_data("compare", data),
        "pairs": told,
        "method": pairs[0] if pairs else None,
        "untold": len(whole) - len(told_of),
        "drift": drift,
        "nights": [
            grid(table, order=board.order)
            for table in drift.findings.tables
            if table.name in ("drift", "nights") and table.rows
        ],
        "runs": runs(board),
        "policies": under_policies(site, board),
        "others": [other(board, one) for one in site.boards if same_cases(board, one)],
    }


def _parts(rows: list[Row]) -> list[Row]:
    return [{name: row.get(name) for name in PAIR} for row in rows]


def runs(board: Board) -> list[Row]:
    """Each configuration that two runs did cases of: their means over the cases of both, and the difference."""
    found = []
    for name in board.order:
        trials = [trial for case in board.cases for trial in case["scores"].get(name, [])]
        by_run: dict[str, dict[str, list[Row]]] = {}
        for trial in trials:
            by_run.setdefault(trial["run_id"], {}).setdefault(trial["case_id"], []).append(trial)
        names = sorted(by_run)
        for place, first in enumerate(names):
            for second in names[place + 1 :]:
                means = [
                    (a, b)
                    for case in by_run[first].keys() & by_run[second].keys()
                    if (a := mean_of(by_run[first][case])) is not None
                    and (b := mean_of(by_run[second][case])) is not None
                ]
                if means:
                    found.append({"configuration": name, "first": first, "second": second, **_difference(means)})
    return found


def same_cases(board: Board, other: Board) -> bool:
    """Whether two leaderboards are of one build of a suite."""
    return board is not other and (board.suite, board.suite_digest) == (other.suite, other.suite_digest)


def other(board: Board, one: Board) -> dict[str, Any]:
    """What another leaderboard of the same cases says, by configuration and by case."""
    scores = {case["case_id"]: case["scores"] for case in one.cases}
    ranks = {row["configuration"]: row["rank"] for row in one.standings}
    rows, changed = [], []
    for standing in board.standings:
        name = standing["configuration"]
        both = []
        for case in board.cases:
            here, there = (mean_of(of.get(name, [])) for of in (case["scores"], scores.get(case["case_id"], {})))
            if here is not None and there is not None:
                both.append((here, there))
                changed.append({"configuration": name, "case_id": case["case_id"], "first": here, "second": there})
        if both:
            told = {"configuration": name, "rank": standing["rank"], "other_rank": ranks.get(name)}
            rows.append({**told, **_difference(both)})
    changed.sort(key=lambda row: -abs(float(row["second"]) - float(row["first"])))
    differs = {
        name: (getattr(board, name), getattr(one, name))
        for name in ("policy", "judge", "judge_version", "engine")
        if getattr(board, name) != getattr(one, name)
    }
    most = [row for row in changed[:MOST_CHANGED] if row["first"] != row["second"]]
    return {"board": one, "differs": differs, "rows": rows, "changed": most}


def _difference(means: list[tuple[float, float]]) -> Row:
    count = len(means)
    first, second = (sum(pair[place] for pair in means) / count for place in (0, 1))
    moved = sum(a != b for a, b in means)
    return {"cases": count, "moved": moved, "mean": first, "other_mean": second, "difference": second - first}
