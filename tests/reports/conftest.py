"""One browser for all tests of pages, and a site of known results."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.built import built_once
from tests.reports.made_site import make_site

if TYPE_CHECKING:
    pass


@pytest.fixture(scope="session")
def made_home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """``warehouse`` and ``site`` of made results (``made_site``)."""
    return built_once(tmp_path_factory, "made-site", make_site)
