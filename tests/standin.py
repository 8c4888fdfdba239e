"""The stand-in editor for tests: installed once, and named by the environment for as long as a block runs."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from c4s.engine.unreal.standin.install import behave, install

WARM_S = "0.05"


@contextmanager
def stand_in(root: Path) -> Iterator[Path]:
    """The installation, in a new folder ``root``; every editor that c4s finds meanwhile is this one."""
    with pytest.MonkeyPatch.context() as patch:
        for name, value in install(root).items():
            patch.setenv(name, value)
        patch.setenv("C4S_UNREAL_WARM_S", WARM_S)
        patch.setenv("C4S_UNREAL_START_S", "100")
        yield root


@contextmanager
def behaving(root: Path, **how: object) -> Iterator[None]:
    """Editors that start in the block behave so."""
    behave(root, **how)
    try:
        yield
    finally:
        behave(root)
