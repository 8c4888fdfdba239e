"""A small suite that baselines played: real trials with calls, judgements, zeros and second attempts."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from cases.model import SuiteDefinition
from cases.starter import indoor_cases
from cases.suite import build_suite
from catalog.build import ensure_pack

AGENTS = ("planner", "vandal", "oracle")


def play(home: Path) -> None:
    """Build the suite ``small``, a text and a repair of the flat, and run the agents on it."""
    scene = indoor_cases.scenes()[1]
    texts = [case for case in indoor_cases.INDOOR_TEXT_CASES if case.case_id == "text-flat-family"]
    ensure_pack("c4s-home", home / "packs")
    build_suite(
        SuiteDefinition(
            "small", "Small", "The flat", ("c4s-home",), (scene,), (*texts, *indoor_cases.flat_cases(scene)[:1])
        ),
        home / "suites" / "small",
        home / "packs",
        lambda line: None,
    )
    chosen = [word for agent in AGENTS for word in ("-a", agent)]
    subprocess.run(
        [sys.executable, "-m", "c4s.cli", "run", "small", *chosen, "--json"],
        env={**os.environ, "C4S_HOME": str(home), "COLUMNS": "140"},
        check=True,
        timeout=280,
        capture_output=True,
    )
