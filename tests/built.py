"""Folders that take long to build and are for reading: built once a test run, by whichever process needs one first."""

from __future__ import annotations

import fcntl
from collections.abc import Callable
from pathlib import Path

import pytest

from catalog.build import ensure_pack


def built_once(factory: pytest.TempPathFactory, name: str, build: Callable[[Path], object]) -> Path:
    """The folder of this name, which all processes of the test run share; ``build`` fills it where it is not there."""
    shared = factory.getbasetemp()
    shared = shared.parent if "popen" in shared.name else shared
    root, built = shared / name, shared / f"{name}.built"
    with (shared / f"{name}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not built.exists():
            build(root)
            built.touch()
    return root


def built_packs(factory: pytest.TempPathFactory, pack_id: str) -> Path:
    """A folder of packs with this one of the starter packs."""
    return built_once(factory, f"pack-{pack_id}", lambda root: ensure_pack(pack_id, root))
