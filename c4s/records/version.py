"""Which code made a record: the release, and a digest of the sources that decide what it says."""

from __future__ import annotations

import functools
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import c4s
from c4s.files import digest, digest_file

_ROOT = Path(c4s.__file__).parent
_DECIDES = {".py", ".yaml", ".txt", ".json"}


@functools.cache
def code_version(*folders: str) -> str:
    """``<release>+<12 hex>``: changes with any source or word list under these folders of ``c4s``."""
    files = sorted(
        path for folder in folders for path in (_ROOT / folder).rglob("*") if path.suffix in _DECIDES and path.is_file()
    )
    listed = [[path.relative_to(_ROOT).as_posix(), digest_file(path)] for path in files]
    return f"{release()}+{digest(listed)[:12]}"


def release() -> str:
    """Version of the installed distribution; ``source`` in a checkout that is not installed."""
    try:
        return version("c4s")
    except PackageNotFoundError:
        return "source"
