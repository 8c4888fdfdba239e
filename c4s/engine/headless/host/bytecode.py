"""Python's own compiled files of the package, written by the host: engines mount the package read-only.

Without them every engine compiles all that it loads, since no trusted process imports those modules. An install by pip
has them; a checkout gets them here, and again when its sources change.
"""

from __future__ import annotations

import compileall
import functools
import sys
from pathlib import Path

import c4s
from c4s.files import digest, write_text
from c4s.home import cache_root

_PACKAGE = Path(c4s.__file__).resolve().parent


@functools.cache
def compile_sources() -> None:
    """Compile what is out of date, where this Python writes such files at all and may write beside the sources."""
    if sys.dont_write_bytecode:
        return
    sources = [(str(path), path.stat().st_mtime_ns) for path in sorted(_PACKAGE.rglob("*.py"))]
    note = cache_root() / "bytecode" / digest([sys.version, sources])[:16]
    if not note.is_file():
        compileall.compile_dir(_PACKAGE, quiet=2)
        write_text(note, "")
