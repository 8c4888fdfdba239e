"""A home where baselines played: real trials with calls, judgements, scenes, zeros and second attempts."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from tests.run.conftest import apart
from tests.run.handed_on import hand_on

REPAIR: Final = "indoor-flat-01-mirrored-bath"
TEXT: Final = "text-flat-family"
AGENTS: Final = ("planner", "random", "vandal", "oracle")
RUN: Final = "seen"


def play(home: Path, baselines: Path) -> None:
    """The agents on a text and a repair of the suite ``small``, in a home apart from that where they ran."""
    hand_on(baselines, apart(home, baselines), AGENTS, (REPAIR, TEXT), RUN)


def page_of(home: Path, case_id: str) -> Path:
    """The page of a case."""
    (page,) = (home / "site" / "cases").glob(f"*--{case_id}--*.html")
    return page
