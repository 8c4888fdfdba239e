"""The map in docs/design.md names every package folder of the checkout, and no folder that is not there.

A folder is named by a row that begins with its path, or, below the folder of the row, by its own name and a slash.
"""

from __future__ import annotations

import re
from pathlib import Path

from tests.house.tree import ROOT, packages

PAGE = ROOT / "docs" / "design.md"
ROW = re.compile(r"^\| (`[^|]+`) \| (.+) \|$", re.MULTILINE)
QUOTED = re.compile(r"`([\w/]+?)/?`")
BELOW = re.compile(r"`([\w/]+)/`")


def named(page: str) -> set[str]:
    """The folders on the map of a page, as paths."""
    found = set()
    for first, about in ROW.findall(page):
        folders = QUOTED.findall(first)
        found |= {*folders, *(f"{folders[0]}/{name}" for name in BELOW.findall(about))}
    return found


def folders() -> set[str]:
    """The top packages, and the packages one and two levels below c4s."""
    below: list[Path] = [*ROOT.glob("c4s/*/__init__.py"), *ROOT.glob("c4s/*/*/__init__.py")]
    return {*packages(), *(str(file.parent.relative_to(ROOT)) for file in below)}


def test_every_package_is_on_the_map() -> None:
    assert folders() - named(PAGE.read_text()) == set()


def test_every_folder_on_the_map_is_there() -> None:
    assert [folder for folder in sorted(named(PAGE.read_text())) if not (ROOT / folder).is_dir()] == []


def test_a_map_is_read() -> None:
    page = "| Folder | What |\n|---|---|\n| `a/b` | one, with `c/` and `d` |\n| `tasks`, `flows` | two |\n"
    assert named(page) == {"a/b", "a/b/c", "tasks", "flows"}
