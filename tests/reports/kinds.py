"""Every kind of page, each with one page of the shared sites."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from c4s.records.progress import Running, Slot, Snapshot, Standing, Trouble
from reports.frame import links
from reports.status import write_status
from tests.reports.played import REPAIR, TEXT

MADE: Final = {
    "leaderboard": links.LEADERBOARD,
    "configuration": "agents/*agent-02*",
    "cases": "boards/*--cases--*",
    "compare": "boards/*--compare--*",
    "diagnostics": "boards/*--diagnostics--*",
    "about": links.ABOUT,
    "limits": links.LIMITS,
    "related": links.RELATED,
    "cheats": links.CHEATS,
    "methods": links.METHODS,
    "data": links.DATA,
    "release": links.RELEASE,
}
"""On the site of made results."""
PLAYED: Final = {
    "case-text": f"cases/*--{TEXT}--*",
    "case-repair": f"cases/*--{REPAIR}--*",
    "trial-text": f"trials/*--{TEXT}--planner--*",
    "trial-repair": f"trials/*--{REPAIR}--random--*",
    "trial-zero": f"trials/*--{TEXT}--vandal--*",
}
"""On the site of trials that were played."""
STATUS: Final = "status"
KINDS: Final = (*MADE, *PLAYED, STATUS)
STATEMENTS: Final = tuple(MADE)[5:]


def page_of_kind(kind: str, made: Path, played: Path) -> Path:
    """The page, of the homes of both sites."""
    if kind == STATUS:
        return made / "status" / "status.html"
    home, pattern = (made, MADE[kind]) if kind in MADE else (played, PLAYED[kind])
    return min((home / "site").glob(pattern))


def make_status(home: Path) -> None:
    """The status page of a run that was stopped with everything on it, below ``home``."""
    (home / "status").mkdir()
    stages = [("planner", "attempt", 31, 120), ("random", "verify", None, None)]
    now = Snapshot(
        run_id="night",
        suite_id="made",
        state="stopped",
        why="the spending limit is reached",
        time=1_800_000_000.0,
        holder="a-machine, process 7",
        planned=40,
        done=25,
        reused=3,
        pending=2,
        waiting=11,
        running=[
            Running(
                configuration=name,
                case="indoor-flat-01-mirrored-bath",
                repeat=1,
                stage=stage,
                attempt=2 if calls else None,
                seconds=200.0,
                host="a-machine",
                calls=calls,
                calls_budget=budget,
                wall_budget_s=2700.0,
            )
            for name, stage, calls, budget in stages
        ],
        slots=[Slot(kind="engine", count=4, busy=1), Slot(kind="processor", count=2, busy=1)],
        standings=[
            Standing(configuration=name, planned=20, done=done, pending=1, scored=done, mean_score=mean, cost_usd=cost)
            for name, done, mean, cost in (("planner", 13, 0.61, 4.2), ("random", 12, 0.24, None))
        ],
        troubles=[Trouble(error="EngineDied", trials=2, line="the engine ended during start", faults="faults.jsonl")],
        spent_usd=4.2,
        spend_limit_usd=5.0,
        left_s=5400.0,
    )
    write_status(now, home / "status" / "status.html", home / "site" / links.LEADERBOARD)
