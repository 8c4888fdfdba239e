"""Folders that take long to build and are for reading: built once a test run, by whichever process needs one first."""

from __future__ import annotations

import fcntl
import os
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Final

import pytest

from c4s.files import is_unfinished
from catalog.build import ensure_pack
from tests.house.tree import ROOT

DEMO: Final = Path(os.environ.get("C4S_HOME") or ROOT / ".c4s").absolute()
"""The home that ``make demo`` fills."""
KEPT: Final = ("kernels", "meanings", "pictures", "previews", "truths")
"""What the product keeps of its own work, each by a digest of all that it depends on."""


def built_once(factory: pytest.TempPathFactory, name: str, build: Callable[[Path], object]) -> Path:
    """The folder of this name, which all processes of the test run share; ``build`` fills it where it is not there."""
    shared = factory.getbasetemp()
    shared = shared.parent if "popen" in shared.name else shared
    root, built = shared / name, shared / f"{name}.built"
    with (shared / f"{name}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not built.exists():
            shutil.rmtree(root, ignore_errors=True)
            build(root)
            built.touch()
    return root


def built_packs(factory: pytest.TempPathFactory, pack_id: str) -> Path:
    """A folder of packs with this one of the starter packs."""
    return built_once(factory, f"pack-{pack_id}", lambda root: take_pack(pack_id, root))


def take_pack(pack_id: str, root: Path) -> None:
    """A starter pack below ``root``: that of the demo's home where these sources built it, else one built now."""
    if (DEMO / "packs" / pack_id).is_dir():
        shutil.copytree(DEMO / "packs" / pack_id, root / pack_id)
    ensure_pack(pack_id, root, replace=True)


def take_kept(home: Path) -> None:
    """Give a new home a copy of what the demo's home keeps: pictures, meanings and machine code are not made again."""
    for name in KEPT:
        if (DEMO / "cache" / name).is_dir():
            shutil.copytree(DEMO / "cache" / name, home / "cache" / name, ignore=_unfinished)


def _unfinished(folder: str, names: list[str]) -> list[str]:
    return [name for name in names if is_unfinished(name)]
