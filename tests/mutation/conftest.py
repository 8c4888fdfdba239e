"""The shipped cases that are mutated, read once a process, and what their base submissions are worth."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.mutation.scenes import Scene
from tests.mutation.subjects import ROUNDING, RepairSubject, TextSubject, Worth, repair_subject, text_subject
from tests.starter import starter_home

Mutate = Callable[[Scene], Scene]
Outcome = dict[str, tuple[Worth, Worth]]
"""By base submission: what it is worth, and what its mutant is worth."""
Check = Callable[[Mutate], Outcome]


@pytest.fixture(scope="session")
def repair(tmp_path_factory: pytest.TempPathFactory) -> RepairSubject:
    """The shipped repair."""
    return repair_subject(starter_home(tmp_path_factory))


@pytest.fixture(scope="session")
def text(tmp_path_factory: pytest.TempPathFactory) -> TextSubject:
    """The shipped text."""
    return text_subject(starter_home(tmp_path_factory))


@pytest.fixture(scope="session")
def repair_worths(repair: RepairSubject) -> dict[str, Worth]:
    """What the base submissions of the repair are worth."""
    return {name: repair.worth(base) for name, base in repair.bases.items()}


@pytest.fixture(scope="session")
def text_worths(text: TextSubject) -> dict[str, Worth]:
    """What the base submissions of the text are worth."""
    return {name: text.worth(base) for name, base in text.bases.items()}


def _outcome(subject: RepairSubject | TextSubject, worths: dict[str, Worth], mutate: Mutate) -> Outcome:
    return {name: (worths[name], subject.worth(mutate(base))) for name, base in subject.bases.items()}


@pytest.fixture
def repair_mutants(repair: RepairSubject, repair_worths: dict[str, Worth]) -> Check:
    """Mutates every base submission of the repair."""
    return lambda mutate: _outcome(repair, repair_worths, mutate)


@pytest.fixture
def text_mutants(text: TextSubject, text_worths: dict[str, Worth]) -> Check:
    """Mutates every base submission of the text."""
    return lambda mutate: _outcome(text, text_worths, mutate)


def rewarded(found: Outcome) -> dict[str, frozenset[str]]:
    """The bases whose mutant scores more, each with the advisories that only the mutant's verdicts have."""
    return {
        name: mutant.advisories - base.advisories
        for name, (base, mutant) in found.items()
        if mutant.score > base.score + ROUNDING
    }
