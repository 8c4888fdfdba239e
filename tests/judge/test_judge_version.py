"""The rule judge's identity: another word list or threshold is another version, and no rule is outside it."""

from __future__ import annotations

import ast
import importlib
import shutil
from pathlib import Path
from types import ModuleType

import pytest

from c4s import errors
from c4s.geometry import transform
from c4s.judge.version import RULES, judge_version, version_of
from c4s.protocol import numbers
from c4s.semantics import measures, words
from c4s.verify.semantic.detailed import verify_detailed
from c4s.verify.semantic.overview import verify_overview

PLAIN = {errors, transform, numbers}
"""Arithmetic and errors: what these do is no rule of the judge."""
EMPTY = {"graph": {"prompt": "", "nodes": [], "edges": []}, "requirements": []}


@pytest.mark.parametrize(
    ("module", "line", "other"),
    [(words, '"people": "person"', '"people": "human"'), (measures, "NEAR_CM = 300.0", "NEAR_CM = 301.0")],
)
def test_another_word_or_threshold_is_another_judge(tmp_path: Path, module: ModuleType, line: str, other: str) -> None:
    for each in RULES:
        shutil.copy(str(each.__file__), tmp_path)
    assert version_of(tmp_path.iterdir()) == judge_version()
    changed = tmp_path / Path(str(module.__file__)).name
    assert line in changed.read_text()
    changed.write_text(changed.read_text().replace(line, other))
    assert version_of(tmp_path.iterdir()) != judge_version()


def test_every_rule_counts() -> None:
    for module in RULES:
        tree = ast.parse(Path(str(module.__file__)).read_text())
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and str(node.module).startswith("c4s."):
                assert importlib.import_module(str(node.module)) in PLAIN | set(RULES), (module, node.module)


def test_verdicts_name_the_version() -> None:
    assert judge_version().startswith("rule-") and len(judge_version()) == 17
    views = {"views": [{"visible": {}}] * 4}
    for verdict in (
        verify_detailed(EMPTY, {"actors": []}, {}),
        verify_overview(EMPTY, {"actors": []}, {}, views),
        verify_overview(EMPTY, {"actors": []}, {}, None),
    ):
        assert verdict.measurements["judge_version"] == judge_version()
