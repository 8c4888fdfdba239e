"""The leaderboard as a table in the terminal."""

from __future__ import annotations

from typing import Any

from c4s.cli.output import print_table, say
from c4s.home import suites_root, warehouse_root
from c4s.records.suite import SuiteFolder

COLUMNS = {
    "rank": "rank",
    "configuration": "agent",
    "model_score": "overall",
    "text_to_scene": "T2S",
    "image_to_scene": "I2S",
    "indoor": "indoor",
    "outdoor": "outdoor",
    "repair_f1": "F1",
    "trials": "trials",
}


def leaderboard(suite: str) -> list[dict[str, Any]]:
    """The leaderboard's rows of one suite, as it is built here."""
    from warehouse.database import rows

    digest = SuiteFolder(suites_root() / suite).suite().sha256()
    return [
        {**row, "trials": f"{row['resolved']}/{row['planned']}"}
        for row in rows(warehouse_root(), "SELECT * EXCLUDE (latest) FROM leaderboards")
        if (row["suite"], row["suite_digest"]) == (suite, digest)
    ]


def print_leaderboard(suite: str) -> None:
    """Print the leaderboard of a suite with what it may and may not be compared with."""
    found = leaderboard(suite)
    judges, engines = {row["judge"] for row in found}, {row["engine"] for row in found}
    several = len({(row["judge"], row["judge_version"]) for row in found}) > 1
    columns = COLUMNS | ({"judge": "judge", "judge_version": "its version"} if several else {})
    if len({row["visibility"] for row in found}) > 1:
        columns = {"visibility": "panel"} | columns
    print_table(
        list(columns.values()), [[row[name] for name in columns] for row in found], title=f"Leaderboard: suite {suite}"
    )
    say(
        "T2S: text to scene. I2S: image to scene, with its two domains and its Repair F1. "
        f"Judge: {', '.join(sorted(judges))} (results by different judges are not ranked together). "
        f"Engine: {', '.join(sorted(engines))} (not ranked with Unreal). "
        "An agent without a rank only validates the evaluator (oracle) or the suite (blind).",
        style="dim",
    )
