"""What is told of private cases: sums over all of them, by an allow-list of columns."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from c4s.records.base import Record
from warehouse.database import rows
from warehouse.release.secrets import PRIVATE

LEAST_CASES: Final = 5
"""A mean over fewer private cases of a setting is close to telling each of them: none of its panel is told then."""


class PrivateStanding(Record):
    """All that is told of a configuration on the private panel: each number is a mean over cases, or a count of trials.

    Table ``private_panel`` of the download and of the leaderboard page; scores in [0, 1]. The fields are the
    allow-list: a column of ``leaderboard`` that is not among them is never read.
    """

    suite: str
    suite_digest: str
    policy: str
    judge: str
    judge_version: str
    engine: str
    configuration: str
    configuration_digest: str
    ranked: bool
    rank: int | None
    """Among complete configurations of the panel; None with a pending trial, and where the panel is too small."""
    model_score: float | None
    text_to_scene: float | None
    image_to_scene: float | None
    indoor: float | None
    outdoor: float | None
    detailed: float | None
    overview: float | None
    text_physics: float | None
    repair_f1: float | None
    image_physics: float | None
    planned: int
    """Trials."""
    resolved: int
    """Trials with an outcome."""


def private_standings(warehouse: Path) -> list[PrivateStanding]:
    """The private panel of the latest build of each suite; numbers are None where a setting has too few cases."""
    fields = PrivateStanding.model_fields
    told = ", ".join(f"l.{name}" for name in fields)
    small = f"""
        SELECT suite, suite_digest FROM setting_means WHERE visibility = '{PRIVATE}'
        GROUP BY ALL HAVING min(of_cases) < {LEAST_CASES}"""
    found = rows(
        warehouse,
        f"SELECT {told}, (l.suite, l.suite_digest) IN ({small}) AS small FROM leaderboard AS l "
        f"WHERE l.visibility = '{PRIVATE}' ORDER BY ALL",
    )
    scores = [name for name, field in fields.items() if "None" in str(field.annotation)]
    standings = []
    for row in found:
        if row.pop("small"):
            row |= dict.fromkeys(scores)
        standings.append(PrivateStanding.parse(row))
    return sorted(standings, key=lambda row: (*_field(row), -(row.model_score or -1.0), row.configuration))


def _field(row: PrivateStanding) -> tuple[str, ...]:
    return row.suite, row.suite_digest, row.policy, row.judge, row.judge_version, row.engine
