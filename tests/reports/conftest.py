"""Sites that tests of pages share, each built once a test run: one of made results, one of trials that were played."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.built import built_once
from tests.reports.made_site import make_site
from tests.reports.played import play


@pytest.fixture(scope="session")
def made_home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """``warehouse`` and ``site`` of made results (``made_site``)."""
    return built_once(tmp_path_factory, "made-site", make_site)


@pytest.fixture(scope="session")
def played_home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A home where baselines played (``played``): ``suites``, ``runs``, ``warehouse``, ``site``."""
    return built_once(tmp_path_factory, "played-home", play)
