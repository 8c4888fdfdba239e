"""A home in which every command has something to work on, and what a call changed in it."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from c4s.files import digest, json_text
from cases.veil import Veil
from tests.cli.garbage import KINDS
from tests.cli.warm import Warm
from warehouse.database import rebuild

TASK = """id: yard
kind: scene_generation
inputs:
  prompt: "A yard.\\n\\n=== ASSET PALETTE ===\\n\\n- box | Box | props | 1x1x1 m | /Game/P/SM_Box.SM_Box\\n"
  init_map: /Game/Blank
  size_m: 200
  budget:
    tool_calls: 10
    wall_minutes: 5
"""
ALIAS = Veil(digest(["yard"])).alias("yard")
"""What the suite calls its case where an agent can see it."""
DERIVED = "cache"
LEASE = "lease"
"""Who held a run last: taken before its plan is looked at."""
BUILD_S = 240


def build_world(root: Path, warm: Warm) -> None:
    """``root/home``: suite and run ``yard`` with its warehouse and pages; ``root/bundle``: its trial as a bundle."""
    (root / "tasks" / "yard").mkdir(parents=True)
    (root / "tasks" / "yard" / "task.yaml").write_text(TASK)
    for arguments in (
        ["suite", "import", "code4scene", str(root / "tasks/yard"), "--id", "yard"],
        ["run", "yard", "-a", "noop"],
        ["bundle", "pack", "yard", "noop", "yard", str(root / "bundle")],
    ):
        done = warm.call(arguments, cwd=root, environment={"C4S_HOME": str(root / "home")}, limit_s=BUILD_S)
        assert done.code == 0, done.err


def listing(root: Path) -> dict[str, tuple[int, int]]:
    """Size and time of every file by its relative name; a folder by its name alone. Derived data is left out."""
    found = {}
    for folder, folders, files in os.walk(root):
        place = os.path.relpath(folder, root)
        folders[:] = [name for name in folders if name != (DERIVED if place == "." else LEASE)]
        found[f"{place}/"] = (0, 0)
        for name in files:
            record = Path(folder, name).lstat()
            found[f"{place}/{name}"] = (record.st_size, record.st_mtime_ns)
    return found


def damaged(home: Path, copy: Path, damage: Mapping[str, Any]) -> Path:
    """A copy of a home with files changed: to a kind of garbage, to a text, gone (null), or with fields set."""
    shutil.copytree(home, copy, symlinks=True)
    if any(pattern.startswith("warehouse/") for pattern in damage):
        rebuild(copy / "warehouse")
    for pattern, change in damage.items():
        places = sorted(copy.glob(pattern)) or [copy / pattern]
        for place in places:
            _damage(place, change)
    return copy


def _damage(place: Path, change: Any) -> None:
    if change is None:
        shutil.rmtree(place) if place.is_dir() else place.unlink()
    elif change == "a folder":
        if place.is_file():
            place.unlink()
        place.mkdir(parents=True)
    elif change == "half":
        _put(place, place.read_bytes()[: place.stat().st_size // 2])
    elif isinstance(change, dict):
        _set(place, change)
    else:
        place.parent.mkdir(parents=True, exist_ok=True)
        _put(place, KINDS[change] if change in KINDS else str(change).encode())


def _put(place: Path, content: bytes) -> None:
    """Put a file in the place of another, as every writer does: the folder tells that something changed."""
    place.unlink(missing_ok=True)
    place.write_bytes(content)


def _set(place: Path, fields: Mapping[str, Any]) -> None:
    """Set fields, by their dotted names, in a JSON document; what held a digest of itself holds it again."""
    document = json.loads(place.read_text())
    sealed = document.pop("sha256", None) if isinstance(document, dict) else None
    for name, value in fields.items():
        *way, last = (int(part) if part.isdigit() else part for part in name.split("."))
        inner = document
        for part in way:
            inner = inner[part]
        if value == "<gone>":
            del inner[last]
        else:
            inner[last] = value
    if sealed is not None:
        document["sha256"] = digest(document)
    place.write_text(json.dumps(document) if sealed is None else json_text(document))
