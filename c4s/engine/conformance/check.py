"""A check: a name, a sentence, and a function that raises ``Failed`` when the engine does otherwise."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from c4s.engine.conformance.ground import Ground

NEAR = 1e-3
"""How far two numbers may be apart: cm, degrees, factors."""


class Failed(Exception):
    """The engine does not do what the check says; the text tells what it did."""


@dataclass(frozen=True)
class Check:
    """One thing that an engine does."""

    name: str
    group: str
    says: str
    """What holds when the check passes, as a sentence."""
    run: Callable[[Ground], str | None]
    """What is to be put on record of a question; None of a check that passed."""


class Group:
    """Collects the checks of a module."""

    def __init__(self, name: str) -> None:
        self.name, self.checks = name, list[Check]()

    def __call__(self, says: str) -> Callable[[Callable[[Ground], None]], Callable[[Ground], None]]:
        """Add a function as a check; its name with hyphens is the check's."""

        def add(function: Callable[[Ground], None]) -> Callable[[Ground], None]:
            self.checks.append(Check(function.__name__.replace("_", "-"), self.name, says, function))
            return function

        return add


def need(truth: bool, otherwise: str) -> None:
    """``Failed`` unless it is so."""
    if not truth:
        raise Failed(otherwise)


def need_facts(found: Mapping[str, Any], expected: Mapping[str, Any]) -> None:
    """``Failed`` unless every expected fact was found, numbers within ``NEAR``."""
    wrong = [
        f"{name} is {found.get(name)!r}, not {value!r}"
        for name, value in expected.items()
        if name not in found or not same(found[name], value)
    ]
    need(not wrong, "; ".join(wrong))


def same(found: Any, expected: Any) -> bool:
    """Whether two values agree, numbers within ``NEAR``."""
    if isinstance(expected, bool) or expected is None or isinstance(expected, str):
        return bool(found == expected and type(found) is type(expected))
    if isinstance(expected, int | float):
        number = isinstance(found, int | float) and not isinstance(found, bool)
        return number and math.isclose(found, expected, rel_tol=0, abs_tol=NEAR)
    if isinstance(expected, list):
        return isinstance(found, list) and len(found) == len(expected) and all(map(same, found, expected))
    if not isinstance(found, dict) or found.keys() != expected.keys():
        return False
    return all(same(found[name], value) for name, value in expected.items())
