"""Sites that tests of pages share, each built once a test run: one of made results, one of trials that were played.

That of made results lies where a reader might put it: its path holds blanks, letters beyond ASCII, and what addresses
have a meaning for.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.built import built_once
from tests.reports.hostile import make_hostile
from tests.reports.kinds import page_of_kind
from tests.reports.made_site import make_site
from tests.reports.played import play
from tests.run.handed_on import baselines_home

UNUSUAL = "Käthes Ergebnisse #1 – 100% дом"


@pytest.fixture(scope="session")
def made_home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """``warehouse`` and ``site`` of made results (``made_site``)."""
    return built_once(tmp_path_factory, "made-site", lambda root: make_site(root / UNUSUAL)) / UNUSUAL


@pytest.fixture(scope="session")
def played_home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A home where baselines played (``played``): ``suites``, ``runs``, ``warehouse``, ``site``."""
    baselines = baselines_home(tmp_path_factory)
    return built_once(tmp_path_factory, "played-home", lambda root: play(root, baselines))


@pytest.fixture(scope="session")
def hostile_home(tmp_path_factory: pytest.TempPathFactory, played_home: Path) -> Path:
    """``warehouse`` and ``site`` of what was played, with texts that would break pages (``hostile``)."""
    return built_once(tmp_path_factory, "hostile-site", lambda root: make_hostile(played_home, root))


@pytest.fixture
def page_of(made_home: Path, request: pytest.FixtureRequest) -> Callable[[str], Path]:
    """The page of a kind; what was played is played only where a kind needs it."""

    def found(kind: str) -> Path:
        played = request.getfixturevalue("played_home") if kind.startswith(("case-", "trial-")) else made_home
        return page_of_kind(kind, made_home, played)

    return found
