"""A home that is built once for all processes of a test run, a process that is warm, and files that are garbage."""

from __future__ import annotations

import fcntl
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.cli.garbage import write_garbage
from tests.cli.warm import Warm
from tests.cli.world import build_world


@pytest.fixture(scope="session")
def warm() -> Iterator[Warm]:
    """A process that forks for each call of ``c4s``."""
    with Warm() as process:
        yield process


@pytest.fixture(scope="session")
def world(tmp_path_factory: pytest.TempPathFactory, warm: Warm) -> Path:
    """Folder with ``home`` and ``bundle`` (``tests/cli/world.py``)."""
    shared = tmp_path_factory.getbasetemp()
    shared = shared.parent if "popen" in shared.name else shared
    root, built = shared / "cli-world", shared / "cli-world.built"
    with (shared / "cli-world.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not built.exists():
            build_world(root, warm)
            built.touch()
    return root


@pytest.fixture(scope="session")
def garbage(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder of wrong files (``tests/cli/garbage.py``)."""
    return write_garbage(tmp_path_factory.mktemp("garbage"))
