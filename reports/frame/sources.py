"""What pages are made by."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import Final

from c4s.files import digest, digest_file

_SOURCES: Final = ("reports", "warehouse", "c4s")
_DECIDES: Final = {".py", ".j2", ".css", ".js", ".sql", ".yaml", ".txt", ".json"}
_ROOT: Final = Path(__file__).parents[2]


@functools.cache
def code_digest() -> str:
    """Digest of every source that can change a page."""
    files = sorted(
        path for name in _SOURCES for path in (_ROOT / name).rglob("*") if path.suffix in _DECIDES and path.is_file()
    )
    return digest([[path.relative_to(_ROOT).as_posix(), digest_file(path)] for path in files])
