"""How agents without a model fare on a leaderboard's cases: cheats, those that build by rule, who knows the truth."""

from __future__ import annotations

import inspect
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from c4s.agents.cheats.layouts import LAYOUTS
from c4s.protocol.baselines import BLIND, CHEATS, ORACLE
from reports.frame.board import PUBLIC, Board, Row
from warehouse.database import rows

WHAT: Final[dict[str, str]] = {
    ORACLE: "Saves the authors' own scene.",
    "planner": "Builds by plan from the prompt, without a model; leaves repairs alone.",
    "random": "Places and changes things at random.",
    "noop": "Does nothing.",
    "vandal": "Deletes everything.",
    BLIND: "Repairs by every trick we know that needs no picture.",
    **{name: inspect.cleandoc(layout.__doc__ or "") for name, layout in LAYOUTS.items()},
}
"""What each of them does."""


@dataclass(frozen=True)
class CheatRow:
    """One agent on one leaderboard."""

    client: str
    configuration: str
    nonsense: bool
    """Whether it is one of the cheats, or of those that only validate."""
    what: str
    construction: float | None
    """Mean score of cases with a prompt; None where it did none."""
    repair: float | None
    repair_f1: float | None
    cases: int


@dataclass(frozen=True)
class CheatTable:
    """The agents of a leaderboard, the best first."""

    board: Board
    rows: list[CheatRow]
    missing: list[str]
    """Cheats that were not run on it."""


def cheat_tables(warehouse: Path, boards: list[Board]) -> list[CheatTable]:
    """A table a leaderboard on which one of these agents stands. Public cases only."""
    every = rows(warehouse, f"{_ASKED} GROUP BY ALL ORDER BY coalesce(built, mended) DESC NULLS LAST, client")
    found = []
    for board in boards:
        told = [_told(row) for row in every if row["client"] in WHAT and all(row[k] == getattr(board, k) for k in _OF)]
        if told:
            there = {row.client for row in told}
            found.append(CheatTable(board, told, [name for name in (*CHEATS, BLIND) if name not in there]))
    return found


def _told(row: Row) -> CheatRow:
    return CheatRow(
        client=row["client"],
        configuration=row["configuration"],
        nonsense=row["client"] in (*CHEATS, BLIND),
        what=WHAT[row["client"]],
        construction=row["built"],
        repair=row["mended"],
        repair_f1=row["repair_f1"],
        cases=row["cases"],
    )


_OF: Final = ("suite", "suite_digest", "policy", "judge", "judge_version", "engine")
_ASKED: Final = f"""
SELECT {", ".join(_OF)}, client, configuration, count(DISTINCT case_id) AS cases,
    avg(score) FILTER (WHERE construction) AS built, avg(score) FILTER (WHERE NOT construction) AS mended,
    avg(repair_f1) FILTER (WHERE NOT construction) AS repair_f1
FROM case_scores JOIN settings USING (setting) WHERE latest AND {PUBLIC}"""
