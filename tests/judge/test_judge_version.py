"""The rule judge's identity covers every source that it decides by."""

from __future__ import annotations

import ast
from pathlib import Path

import c4s
from c4s.judge.rule.judging import DECIDE, rule_version

ROOT = Path(c4s.__file__).parent
NO_RULE = {"errors", "records"}
"""How errors and records look is no rule of the judge."""


def test_every_rule_counts() -> None:
    seen = set()
    for folder in ("judge", "semantics"):
        for path in sorted((ROOT / folder).rglob("*.py")):
            for node in ast.walk(ast.parse(path.read_text())):
                if isinstance(node, ast.ImportFrom) and str(node.module).startswith("c4s."):
                    seen.add(str(node.module).split(".")[1])
    assert seen - NO_RULE == set(DECIDE)


def test_a_version_names_the_release_and_the_sources() -> None:
    release, _, sources = rule_version().partition("+")
    assert release and len(sources) == 12
