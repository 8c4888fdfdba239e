"""What a folder says about its licence: files beside the meshes, in the folders above and below."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from c4s.errors import BadInput
from c4s.files import read_plain
from catalog.ingest.debian import packaged_licence
from catalog.ingest.licence_words import UNKNOWN, AiUse, ai_use, licences_in

FILES = re.compile(
    r"[^/]*(licen[cs]e|copying|copyright|notice|credits|attribution)[^/]*\.?(txt|md|html?|rst)?|source[^/]*(\.(txt|md))?",
    re.IGNORECASE,
)
TEXTS = ("", ".txt", ".md", ".rst", ".html", ".htm")
LAST = re.compile(r"readme[^/]*|package\.json|(package|model)\.(xml|config)", re.IGNORECASE)
"""Files that are asked when no other tells the licence."""
MOST_ABOVE = 3
"""How many folders above are asked."""
MOST_TEXT = 100_000


@dataclass(frozen=True)
class Licence:
    """What was found: SPDX id (several joined by ``AND``), the text of the files that tell it, and notes."""

    id: str
    text: str
    ai_use: AiUse
    ai_reason: str
    notes: tuple[str, ...] = ()


def licence(folder: Path, files: Sequence[Path] = (), stated: Sequence[str] = (), given: Path | None = None) -> Licence:
    """The licence of a folder.

    A file that is given decides alone. Else the folder's own files do; where they tell none, what tables and sidecar
    files state, then the folders of single meshes, then the Debian package that installed the files, then up to
    ``MOST_ABOVE`` folders above, as far as the one that holds a ``.git``.

    Args:
        folder: the folder.
        files: its mesh files; their own folders may name licences of single things.
        stated: what sidecar files say of single things.
        given: the file that tells the licence.

    Raises:
        BadInput: ``given`` is no file, or tells no licence that is known.
    """
    if given is not None:
        return _given(given)
    names, text, notes = _told(folder)
    below: dict[str, str] = {}
    for place in dict.fromkeys(path.parent for path in files):
        while place != folder and place.is_relative_to(folder):
            own, words, _ = _told(place)
            if own:
                below.setdefault(own[0], words)
                break
            place = place.parent
    for words in stated:
        for name in licences_in(words)[:1]:
            below.setdefault(name, words)
    if names:
        others = sorted(set(below) - set(names[:1]))
        if others:
            notes.append(f"some things have a licence of their own: {', '.join(others)}")
        names = [*names[:1], *others]
        text = "\n\n".join([text, *(below[name] for name in others)])
    elif below:
        names, text = sorted(below), "\n\n".join(below[name] for name in sorted(below))
    else:
        names, words, notes = _packaged(files) or _above(folder)
        text = "\n\n".join(one for one in (text, words) if one)
    name = " AND ".join(dict.fromkeys(names)) or UNKNOWN
    use, reason = ai_use(name, text)
    if name == UNKNOWN:
        notes.append("no file here tells the licence")
    return Licence(name, text[: 4 * MOST_TEXT], use, reason, tuple(notes))


def _given(file: Path) -> Licence:
    if not file.is_file():
        raise BadInput("no such file", where=f"--license-file {file}")
    text = read_plain(file)[:MOST_TEXT].decode("utf-8", errors="replace")
    names = licences_in(text)[:1]
    if not names:
        raise BadInput(
            "this file tells no licence that is known",
            where=f"--license-file {file}",
            todo="name it by its SPDX id: SPDX-License-Identifier: CC-BY-4.0",
        )
    use, reason = ai_use(names[0], text)
    return Licence(names[0], text, use, reason, ("the licence is told by the file that was given",))


def _packaged(files: Sequence[Path]) -> tuple[list[str], str, list[str]] | None:
    """What the Debian package of some files says; None where there is none or it names no licence that is known."""
    found = packaged_licence([Path(os.path.realpath(path)) for path in files])
    if found is None:
        return None
    package, texts = found
    names = [name for text in texts for name in licences_in(text)[:1]]
    return (names, "\n\n".join(texts), [f"the licence is told by the Debian package {package}"]) if names else None


def _above(folder: Path) -> tuple[list[str], str, list[str]]:
    place = Path(os.path.realpath(folder))
    for _ in range(MOST_ABOVE):
        if (place / ".git").exists() or place.parent == place:
            break
        place = place.parent
        names, text, _ = _told(place)
        if names:
            return names[:1], text, [f"the licence is told by the folder {place.name!r} above"]
    return [], "", []


def _told(folder: Path) -> tuple[list[str], str, list[str]]:
    """The licence that a folder's own files name first, their text, and a note of others that they name."""
    try:
        here = sorted(path for path in folder.iterdir() if path.suffix.lower() in (*TEXTS, ".json", ".xml", ".config"))
    except OSError:
        return [], "", []
    files = [
        path for path in here if FILES.fullmatch(path.name) and path.suffix.lower() in TEXTS and _is_own(path, folder)
    ]
    files.sort(key=lambda path: (path.name.lower().startswith(("source", "credits")), "licen" not in path.name.lower()))
    texts = [read_plain(path)[:MOST_TEXT].decode("utf-8", errors="replace") for path in files]
    named = [name for text in texts for name in licences_in(text)[:1]]
    if named:
        return named[:1], "\n\n".join(texts), []
    for path in here:
        if LAST.fullmatch(path.name) and _is_own(path, folder):
            text = read_plain(path)[:MOST_TEXT].decode("utf-8", errors="replace")
            said = re.search(r"(?is)licen[cs]e.{0,400}", text)
            names = licences_in(said.group()) if said else []
            if names:
                return names[:1], "\n\n".join([*texts, said.group() if said else ""]), []
    return [], "\n\n".join(texts), []


def _is_own(path: Path, folder: Path) -> bool:
    """Whether it is a plain file of the folder, and no link out of it."""
    return path.is_file() and Path(os.path.realpath(path)).is_relative_to(Path(os.path.realpath(folder)))
