"""What every call that c4s refuses must look like, as a list of what is wrong with one."""

from __future__ import annotations

import re
from pathlib import Path

from tests.cli.warm import HUNG, Done

ROOT = str(Path(__file__).parents[2])
MOST_CHARACTERS = 2_000
MUST_NOT_SAY = {
    "a traceback": re.compile(r"Traceback|File \".*\", line"),
    "a class of Python or a library": re.compile(
        r"\b[A-Za-z]+(?:Error|Exception|Warning)\b|<class |pydantic|msgspec|_duckdb"
    ),
    "an error number": re.compile(r"\[Errno"),
    "where c4s is installed": re.compile(rf"site-packages|{re.escape(ROOT)}/"),
    "a fault of c4s": re.compile("a fault of c4s"),
}


def faults_of_line(done: Done, *, lists: bool = False) -> list[str]:
    """What is wrong with what a refused call wrote; ``lists``: standard output may hold what was found."""
    lines = done.err.split("\n")
    found = []
    if done.code == HUNG:
        found.append("it did not end")
    if done.out and not lists:
        found.append("it wrote to standard output")
    if len(lines) != 2 or lines[1] or not re.match(r"c4s: \S", lines[0]):
        found.append("standard error is not one line that begins with c4s:")
    if any(not character.isprintable() for character in lines[0]):
        found.append("the line holds what cannot be printed")
    if len(done.err) > MOST_CHARACTERS:
        found.append(f"the line has {len(done.err)} characters")
    return found + [f"it names {what}" for what, pattern in MUST_NOT_SAY.items() if pattern.search(done.err)]
