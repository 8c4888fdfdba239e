"""The runs of a case in the one order of the leaderboard, with their ranks in this case."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from statistics import fmean
from typing import Any

from c4s.protocol.rules import GATE
from reports.frame.board import Board, Row


@dataclass(frozen=True)
class CaseRun:
    """A trial of the case."""

    configuration: str
    trial: Row
    ranked: bool
    rank: int | None
    """In this case, by the mean of its repeats; null where a repeat is pending, and for one that only validates."""
    tied: bool
    of: int
    """Configurations that have a rank."""
    actors: int | None
    """Of the submission."""

    @property
    def place(self) -> str:
        """Its rank in words; empty where it has none."""
        if self.rank is None:
            return "" if self.ranked else "not ranked"
        return f"{'tied ' if self.tied else ''}rank {self.rank} of {self.of}"


def case_runs(board: Board, case: Row, documents: Mapping[str, Mapping[str, Any]]) -> list[CaseRun]:
    """Every trial of the case, configurations as they stand on the leaderboard."""
    standings = {row["configuration"]: bool(row["ranked"]) for row in board.standings}
    means = {
        name: None if any(trial["score"] is None for trial in trials) else fmean(trial["score"] for trial in trials)
        for name in board.order
        if (trials := case["scores"].get(name))
    }
    field = [mean for name, mean in means.items() if standings[name] and mean is not None]
    runs = []
    for name, mean in means.items():
        placed = mean if standings[name] else None
        for trial in case["scores"][name]:
            integrity = documents.get(trial["trial_id"], {}).get(GATE, {})
            runs.append(
                CaseRun(
                    name,
                    trial,
                    standings[name],
                    None if placed is None else 1 + sum(other > placed for other in field),
                    placed is not None and field.count(placed) > 1,
                    len(field),
                    integrity.get("population", {}).get("actors"),
                )
            )
    return runs


def higher_and_lower(runs: Sequence[CaseRun], pictured: frozenset[str]) -> tuple[CaseRun, CaseRun] | None:
    """A higher-scoring and a lower-scoring run: the best and the worst that were measured and have pictures.

    Of ranked configurations where two of them differ, else of all; None where no two differ.
    """
    measured = [run for run in runs if run.trial["status"].startswith("measured") and run.trial["trial_id"] in pictured]
    for field in ([run for run in measured if run.ranked], measured):
        if field:
            high = max(field, key=lambda run: run.trial["score"])
            low = min(field, key=lambda run: run.trial["score"])
            if high.trial["score"] > low.trial["score"]:
                return high, low
    return None
