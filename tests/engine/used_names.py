"""What others use of Unreal's Python API: a table of names, each with who uses it, and whether both modules have it.

``python tests/engine/used_names.py`` prints it.
"""

from __future__ import annotations

import re
import sys
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
FACTS = ROOT.parent / "shared" / "facts" / "unreal.md"
SOURCES = (
    "c4s/editor",
    "c4s/engine/unreal/boot",
    "c4s/toolbox",
    "c4s/agents",
    "c4s/planner",
    "cases",
    "tests/engine/scripts",
    "tests/toolbox",
    "tests/agents",
    "tests/agent_clients",
)
NAME = re.compile(r"\bunreal\.([A-Za-z]\w*)(?:\.([A-Za-z]\w*))?")
TICKED = re.compile(r"`([^`]+)`")
OWNERS = {
    "AssetRegistryHelpers.get_asset_registry": "AssetRegistry",
    "AssetToolsHelpers.get_asset_tools": "AssetTools",
    "light setters": "PointLightComponent",
}
"""Where a row of the facts names functions of what its first name gives."""


@dataclass(frozen=True)
class Row:
    """A name, who uses it, and where it exists."""

    name: str
    users: tuple[str, ...]
    in_unreal: bool
    here: bool


def in_text(text: str) -> Iterator[str]:
    """``X`` and ``X.y`` for every ``unreal.X.y``."""
    for owner, member in NAME.findall(text):
        yield owner
        if member:
            yield f"{owner}.{member}"


def in_facts(text: str) -> Iterator[str]:
    """Names of the table and of the list of methods in section 5 of the facts; methods begin with a dot."""
    owner = ""
    for line in text.split("### 5.1")[1].split("### 5.2")[0].splitlines():
        cells = line.split("|")
        if len(cells) < 4 or not cells[1].strip() or not cells[1].strip()[0].isdigit():
            continue
        first = [re.split(r"[ (]", tick)[0].removesuffix("()") for tick in TICKED.findall(cells[2])]
        for tick in first:
            if tick.startswith("."):
                yield f"{owner}{tick}"
            elif tick[0].isupper():
                yield tick
                owner = tick.split(".")[0]
            elif "/" not in tick:
                yield f"{owner}.{tick}" if owner else tick
        giver = OWNERS.get(first[0] if first else cells[2].strip(), owner)
        for tick in TICKED.findall(cells[3]):
            found = re.fullmatch(r"\.?([a-z]\w*)\(.*\)", tick)
            if found and giver:
                yield f"{giver}.{found[1]}"
    for tick in TICKED.findall(text.split("### 5.2")[1].split("### 5.3")[0]):
        yield f".{re.split(r'[ (]', tick)[0]}"


def used() -> dict[str, set[str]]:
    """Names by their users."""
    found: dict[str, set[str]] = defaultdict(set)
    for folder in SOURCES:
        for file in sorted((ROOT / folder).rglob("*.py")):
            for name in in_text(file.read_text(encoding="utf-8")):
                found[name].add(folder)
    if FACTS.is_file():
        text = FACTS.read_text(encoding="utf-8")
        for name in [*in_text(text), *in_facts(text)]:
            found[name].add("facts")
    return found


def _known(name: str, top: Iterable[str], has: Any, owners: Iterable[str]) -> bool:
    owner, _, member = name.partition(".")
    if not owner:
        return any(has(each, member) for each in owners)
    return owner in top and (not member or has(owner, member))


def table(stub: Any, ours: dict[str, Any]) -> list[Row]:
    """All names in order. A method without an owner counts where any class has it."""
    classes = {name: cls for name, cls in ours.items() if isinstance(cls, type)}
    rows = []
    for name, users in sorted(used().items()):
        rows.append(
            Row(
                name,
                tuple(sorted(users)),
                _known(
                    name,
                    stub.classes() | stub.functions(),
                    lambda o, m: o in stub.classes() and stub.has(o, m),
                    (
                        "Actor",
                        "SceneComponent",
                        "StaticMeshComponent",
                        "_ObjectBase",
                        "StaticMesh",
                        "MeshComponent",
                        "PrimitiveComponent",
                    ),
                ),
                _known(
                    name,
                    ours,
                    lambda o, m: (
                        o in classes
                        and (
                            hasattr(classes[o], m)
                            or m in getattr(classes[o], "_properties", {})
                            or m in getattr(classes[o], "_fields", {})
                        )
                    ),
                    classes,
                ),
            )
        )
    return rows


def main() -> None:
    """Print the table."""
    from stub_index import StubIndex

    from c4s.engine.headless.unreal import build

    ours = {name: value for name, value in vars(build()).items() if not name.startswith("__")}
    rows = table(StubIndex.installed(), ours)
    for row in rows:
        print(
            f"{row.name:60} unreal {'yes' if row.in_unreal else 'no ':3}  here {'yes' if row.here else 'no ':3}  "
            f"{', '.join(row.users)}"
        )
    print(
        f"{len(rows)} names, {sum(r.in_unreal for r in rows)} of Unreal 5.6, "
        f"{sum(r.in_unreal and r.here for r in rows)} of these here"
    )


if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parent))
    main()
