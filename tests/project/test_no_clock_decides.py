"""No test compares what a clock says: how long something takes depends on the machine and on who else works on it.

What must not grow is counted (``tests/work.py``); what takes long is measured in ``bench/``.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

TESTS = Path(__file__).resolve().parents[1]
CLOCKS = {"time", "perf_counter", "monotonic", "process_time", "thread_time", "default_timer", "now", "utcnow"}
CLOCKS |= {f"{name}_ns" for name in CLOCKS}
TIMERS = {"wall_s", "duration_s", "evaluation_s", "orchestration_s", "attempt_wall_s"}
"""Fields of records that say how long something took."""


RECKONING = {"abs", "float", "int", "len", "max", "min", "round", "sorted", "sum"}


def _is_clock(node: ast.AST) -> bool:
    if isinstance(node, ast.Attribute) and node.attr in TIMERS:
        return True
    if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant) and node.slice.value in TIMERS:
        return True
    if not isinstance(node, ast.Call):
        return False
    called = node.func
    return (isinstance(called, ast.Attribute) and called.attr in CLOCKS) or (
        isinstance(called, ast.Name) and called.id in CLOCKS
    )


def _told(node: ast.AST, known: set[str]) -> bool:
    """Whether a value is made from a clock: by a call, or through a name that holds such a value.

    What a function makes of a clock that it is given is its own affair, but for those that only reckon.
    """
    if _is_clock(node) or (isinstance(node, ast.Name) and node.id in known):
        return True
    if isinstance(node, ast.Call):
        reckons = isinstance(node.func, ast.Name) and node.func.id in RECKONING
        return _told(node.func, known) or (reckons and any(_told(one, known) for one in node.args))
    return any(_told(inner, known) for inner in ast.iter_child_nodes(node))


def _names(target: ast.AST) -> Iterator[str]:
    return (inner.id for inner in ast.walk(target) if isinstance(inner, ast.Name))


def _holders(function: ast.AST) -> set[str]:
    """Names in a function that hold what a clock said: assigned, collected or returned."""
    known: set[str] = set()
    inner = {
        node.name: set(ast.walk(node))
        for node in ast.walk(function)
        if isinstance(node, ast.FunctionDef) and node is not function
    }
    while True:
        before = len(known)
        for node in ast.walk(function):
            if isinstance(node, ast.Assign) and _told(node.value, known):
                known.update(name for target in node.targets for name in _names(target))
            elif isinstance(node, ast.AnnAssign | ast.AugAssign | ast.NamedExpr):
                if node.value is not None and _told(node.value, known):
                    known.update(_names(node.target))
            elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
                if node.func.attr in ("append", "extend", "add") and any(_told(one, known) for one in node.args):
                    known.update(_names(node.func.value))
            elif isinstance(node, ast.Return) and node.value is not None and _told(node.value, known):
                known.update(name for name, inside in inner.items() if node in inside)
        if len(known) == before:
            return known


def timed(source: str) -> list[int]:
    """Lines of a program on which what a clock says is held against a limit."""
    found = set()
    for function in ast.walk(ast.parse(source)):
        if isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef):
            known = _holders(function)
            found |= {
                node.lineno
                for node in ast.walk(function)
                if isinstance(node, ast.Compare) and _limits(node) and _told(node, known)
            }
    return sorted(found)


def _limits(node: ast.Compare) -> bool:
    """Whether values are put in order, and not only against zero: that time went by holds on every machine."""
    ordered = any(isinstance(one, ast.Lt | ast.LtE | ast.Gt | ast.GtE) for one in node.ops)
    return ordered and not all(isinstance(one, ast.Constant) and one.value == 0 for one in node.comparators)


@pytest.mark.parametrize(
    "body",
    [
        "began = time.perf_counter()\n work()\n assert time.perf_counter() - began < 5",
        "began = monotonic()\n work()\n spent = monotonic() - began\n assert spent < limit",
        "spent = []\n for _ in range(9):\n  a = time.process_time_ns()\n  spent.append(time.process_time_ns() - a)\n"
        " assert sorted(spent)[4] < 3",
        "def median(n):\n  a = time.time()\n  return time.time() - a\n few, many = median(1), median(9)\n"
        " assert many < 5 * few",
        "while datetime.now() < end: work()",
        "assert outcome.wall_s < 10",
    ],
)
def test_a_clock_that_decides_is_found(body: str) -> None:
    assert timed(f"def test():\n {body}\n")


@pytest.mark.parametrize(
    "body",
    [
        "assert line['duration_s'] >= 0",
        "read(deadline=time.monotonic() + 10)\n assert 1 < 2",
        "assert row['wall_s'] == other.wall_s",
    ],
)
def test_what_does_not_decide_is_left(body: str) -> None:
    assert timed(f"def test():\n {body}\n") == []


def test_no_test_compares_what_a_clock_says() -> None:
    files = sorted(TESTS.rglob("*.py"))
    assert len(files) > 100
    found = [f"{path.relative_to(TESTS)}:{line}" for path in files for line in timed(path.read_text())]
    assert found == []
