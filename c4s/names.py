"""The one door for names and paths that come from outside: what a person, a pack, a task or an agent calls something.

A name becomes a folder, a file, a row or a line on a page, so it is letters, digits and ``. _ -``, a letter or digit
first. A path in a document names a file below the document's own root, whatever it says. Each rule is a function that
says what is wrong, a function that raises ``BadInput``, and a type for records.
"""

from __future__ import annotations

import os
import re
import unicodedata
from pathlib import Path
from typing import Annotated

from pydantic import AfterValidator, Field

from c4s.errors import BadInput

MOST_NAME = 120
"""Characters of a name: a folder of this name and a few letters more fits every file system."""
MOST_PATH = 400
"""Characters of a path in a document."""
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")
_ID = re.compile(r"[a-z0-9][a-z0-9._-]{0,62}")
_DRIVE = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*:")


def name_fault(text: str) -> str:
    """What keeps a text from being a name; empty for a name."""
    if len(text) > MOST_NAME:
        return f"a name has at most {MOST_NAME} characters, this has {len(text)}"
    return "" if _NAME.fullmatch(text) else f"{text!a} is no name: letters, digits and . _ -, a letter or digit first"


def path_fault(text: str) -> str:
    """What keeps a text from naming a file below a root; empty for a relative path that stays there as it is spelt."""
    if len(text) > MOST_PATH:
        return f"a path has at most {MOST_PATH} characters, this has {len(text)}"
    if not text.strip() or not text.isprintable():
        return f"{text!a} is no path"
    if text.startswith(("/", "~")) or "\\" in text or _DRIVE.match(text) or ".." in text.split("/"):
        return f"{text!a} leads out of its folder"
    return ""


def package_fault(text: str) -> str:
    """What keeps a text from being a path of an engine's content (``/Game/Pack/SM_A.SM_A``); empty for one."""
    if not text.startswith("/") or path_fault(text[1:]):
        return f"{text[:MOST_PATH]!a} is no path of engine content"
    return ""


def shown(text: str, keep: str = "") -> str:
    """A text as people are shown it, on a terminal or a page: what is no visible character is written as its escape.

    Escape sequences, controls, direction overrides, line ends and lone surrogates are; characters of ``keep`` are not.
    """
    if text.isprintable():
        return text
    return "".join(
        one
        if one.isprintable() or one in keep or unicodedata.category(one) == "Zs"
        else one.encode("unicode_escape").decode()
        for one in text
    )


def checked_id(text: str, what: str) -> str:
    """The id of a new pack or suite, which is also the name of its folder; ``BadInput`` for any other text."""
    if not _ID.fullmatch(text):
        raise BadInput(f"a {what} id is lower-case letters, digits and . _ -, a letter or digit first", where=text)
    return text


def checked_name(text: str, what: str) -> str:
    """A name; ``BadInput`` that says of ``what`` for any other text."""
    if fault := name_fault(text):
        raise BadInput(f"{what}: {fault}")
    return text


def check_written(path: Path) -> None:
    """``BadInput`` for a path whose last part cannot be written down: a title or a note names it."""
    if not path.name.isprintable():
        raise BadInput("the name of this file or folder is no text", where=shown(str(path)), todo="rename it")


def place_in(root: Path, name: str, what: str) -> Path:
    """The folder of a ``what`` called ``name``, directly below ``root``.

    ``BadInput`` for a text that is no name, and where a link lies: what is written there would land elsewhere.
    """
    place = root / checked_name(name, what)
    if place.is_symlink():
        raise BadInput(f"a {what} is a folder, this is a link", where=str(place), todo="move it away")
    return place


def file_in(root: Path, path: str) -> Path:
    """The file that a document of ``root`` names, there or not; ``BadInput`` for a path or a link that leads out."""
    if fault := path_fault(path):
        raise BadInput(fault, where=str(root))
    if not Path(os.path.realpath(root / path)).is_relative_to(os.path.realpath(root)):
        raise BadInput("this is a link out of its folder", where=str(root / path))
    return root / path


def _name(text: str) -> str:
    if fault := name_fault(text):
        raise ValueError(fault)
    return text


def _inner(text: str) -> str:
    if fault := path_fault(text):
        raise ValueError(fault)
    return text


def _package(text: str) -> str:
    if fault := package_fault(text):
        raise ValueError(fault)
    return text


Name = Annotated[
    str, AfterValidator(_name), Field(max_length=MOST_NAME, json_schema_extra={"pattern": f"^{_NAME.pattern}$"})
]
"""A name that becomes a folder or a file."""
InnerPath = Annotated[str, AfterValidator(_inner), Field(max_length=MOST_PATH)]
"""A file below the folder of the document that names it."""
PackagePath = Annotated[str, AfterValidator(_package)]
"""A path of an engine's content."""
