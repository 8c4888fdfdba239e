"""Who may sit at a local server of questions: a key each, made once, kept where the organiser alone can read it."""

from __future__ import annotations

import os
import secrets
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from c4s.files import json_text
from c4s.folders import beside
from c4s.records.asking import ORGANISER, Access

KEY_BYTES: Final = 24
PORTS: Final = range(20_000, 30_000)
"""Where a port is drawn from: below those that systems give to outgoing connections."""


def access_for(path: Path, people: Sequence[str], port: int = 0) -> Access:
    """The links of some people: those made before, and new ones for who has none.

    Args:
        path: where they are kept (``keep_access``).
        people: who sits there beside the organiser.
        port: the port to keep; 0 for the one kept, at first one that is drawn.
    """
    kept = Access.read(path) if path.is_file() else None
    made = Access(
        port=port or (kept.port if kept else secrets.choice(PORTS)),
        secret=kept.secret if kept else secrets.token_hex(KEY_BYTES),
        keys={
            **{name: secrets.token_urlsafe(KEY_BYTES) for name in [ORGANISER, *people]},
            **(kept.keys if kept else {}),
        },
    )
    return made


def keep_access(path: Path, access: Access) -> None:
    """Write links down, for nobody else on the machine to read."""
    if path.is_file() and Access.read(path) == access:
        return
    with beside(path) as scratch:
        fresh = scratch / path.name
        with os.fdopen(os.open(fresh, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w", encoding="utf-8") as out:
            out.write(json_text(access.plain()))
            out.flush()
            os.fsync(out.fileno())
        fresh.replace(path)
