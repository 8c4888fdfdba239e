"""``c4s demo``: the shipped suite with the six baseline agents, from nothing to the leaderboard page."""

from __future__ import annotations

import time

from c4s.cli.board import print_leaderboard
from c4s.cli.output import say
from c4s.cli.shipped import build_starter_visibly
from c4s.cli.suite import Replace
from c4s.protocol.baselines import BASELINES


def demo(replace: Replace = False) -> None:
    """Build the starter suite, run the six baselines on it, print the leaderboard and the page's address."""
    from c4s.cli.evaluation import evaluate_here

    started = time.perf_counter()
    build_starter_visibly(replace=replace)
    made = evaluate_here("starter", BASELINES)
    print_leaderboard("starter")
    say(f"{made.line()}, {time.perf_counter() - started:.0f} s in all")
    say(f"Leaderboard: {made.page}")
