"""The licence of files that a Debian package installed: its ``copyright`` file (DEP-5, copyright format 1.0).

Patterns of that file speak of the package's source tree; an installed file is held to be the one whose end they fit.
"""

from __future__ import annotations

import fnmatch
import os
import re
from collections.abc import Sequence
from functools import cache
from pathlib import Path, PurePosixPath
from typing import Final

from c4s.files import read_plain

ROOT: Final = Path("/")
_LISTS, _DOCS = "var/lib/dpkg/info", "usr/share/doc"
_MACHINE_READABLE = re.compile(r"\A(?:\s*#.*\n)*\s*Format:", re.IGNORECASE)
_FIELD = re.compile(r"^([A-Za-z][A-Za-z-]*):[ \t]*(.*(?:\n[ \t].*)*)", re.MULTILINE)
_PACKAGING: Final = "debian/*"


def packaged_licence(files: Sequence[Path], root: Path = ROOT) -> tuple[str, list[str]] | None:
    """The package that installed the first of some files, and what its copyright file says of them all.

    Each licence once, as its short name and its text; of a file that is not machine-readable, its whole text. None
    where no package installed the file, or its copyright file is not here.

    Args:
        files: real paths.
        root: of the system; Debian's own files lie below it.
    """
    if not files:
        return None
    package = _owner(files[0], root)
    told = root / _DOCS / (package or "-") / "copyright"
    if package is None or not told.is_file():
        return None
    text = read_plain(told).decode("utf-8", errors="replace")
    if not _MACHINE_READABLE.search(text):
        return package, [text]
    paragraphs = [{name.lower(): value for name, value in _FIELD.findall(one)} for one in re.split(r"\n[ \t]*\n", text)]
    texts = {_short(one["license"]): one["license"] for one in paragraphs if "license" in one and "files" not in one}
    rules = [(one["files"].split(), one["license"]) for one in paragraphs if one.keys() >= {"files", "license"}]
    said = [rule for path in files if (rule := _of(PurePosixPath("/", path.relative_to(root)), rules)) is not None]
    names = dict.fromkeys(said)
    return package, [f"{name}\n{texts[_short(name)]}" if _short(name) in texts else name for name in names]


def _short(licence: str) -> str:
    return licence.partition("\n")[0].strip()


def _of(path: PurePosixPath, rules: Sequence[tuple[list[str], str]]) -> str | None:
    """What the last paragraph that fits a file says; the packaging's own files are never installed."""
    ends = ["/".join(path.parts[place:]) for place in range(1, len(path.parts))]
    fitting = [
        licence
        for patterns, licence in rules
        if any(
            pattern != _PACKAGING and any(fnmatch.fnmatchcase(end, pattern.removeprefix("./")) for end in ends)
            for pattern in patterns
        )
    ]
    return fitting[-1] if fitting else None


def _owner(path: Path, root: Path) -> str | None:
    """The package that installed a file."""
    if not path.is_relative_to(root / "usr"):
        return None
    wanted = os.fsencode(PurePosixPath("/", path.relative_to(root)))
    return next((name for name, files in _installed(root).items() if wanted in files), None)


@cache
def _installed(root: Path) -> dict[str, frozenset[bytes]]:
    """Paths by package."""
    lists = sorted((root / _LISTS).glob("*.list"))
    return {one.name.removesuffix(".list").partition(":")[0]: frozenset(read_plain(one).splitlines()) for one in lists}
