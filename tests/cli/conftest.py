"""A home that is built once for all processes of a test run, a process that is warm, and files that are garbage."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.built import built_once
from tests.cli.garbage import write_garbage
from tests.cli.warm import Warm, warm_process
from tests.cli.world import build_world


@pytest.fixture(scope="session")
def warm() -> Warm:
    """A process that forks for each call of ``c4s``."""
    return warm_process()


@pytest.fixture(scope="session")
def world(tmp_path_factory: pytest.TempPathFactory, warm: Warm) -> Path:
    """Folder with ``home`` and ``bundle`` (``tests/cli/world.py``)."""
    return built_once(tmp_path_factory, "cli-world", lambda root: build_world(root, warm))


@pytest.fixture(scope="session")
def garbage(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder of wrong files (``tests/cli/garbage.py``)."""
    return write_garbage(tmp_path_factory.mktemp("garbage"))
