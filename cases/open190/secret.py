"""The seed of the private half: only the operator has it, and the same seed makes the same bytes on every machine."""

from __future__ import annotations

import os
import stat
from pathlib import Path
from typing import Final

from c4s.errors import BadInput
from c4s.home import home

VARIABLE: Final = "C4S_PRIVATE_SEED"
FILE: Final = "private-seed"
LEAST_LENGTH: Final = 16
ADVICE: Final = f"write at least {LEAST_LENGTH} random characters, such as `openssl rand -hex 32` prints"


def private_seed() -> str | None:
    """The operator's seed: of the variable ``C4S_PRIVATE_SEED``, else of the file ``private-seed`` in ``C4S_HOME``.

    None where neither is there. ``BadInput`` for one that is too short to be a secret, or a file that others may read.
    """
    given = os.environ.get(VARIABLE)
    if given is not None:
        return _checked(given, VARIABLE)
    place = home() / FILE
    return _checked(_read(place), str(place)) if os.path.lexists(place) else None


def _read(place: Path) -> str:
    told = place.lstat()
    if not stat.S_ISREG(told.st_mode):
        raise BadInput("the seed of the private half is no plain file", where=str(place))
    if told.st_mode & 0o077:
        raise BadInput("others may read the seed of the private half", where=str(place), todo=f"chmod 600 {place}")
    try:
        return place.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise BadInput(f"the seed of the private half cannot be read: {error}", where=str(place)) from error


def _checked(text: str, where: str) -> str:
    seed = text.strip()
    if len(seed) < LEAST_LENGTH or len(set(seed)) < LEAST_LENGTH // 2:
        raise BadInput("the seed of the private half can be guessed", where=where, todo=ADVICE)
    return seed
