"""The compiled numerical kernels (numba): compiled once by a trusted process, read-only to every engine.

A cache entry is machine code, so an engine that runs agent code must never write what another engine loads. Each engine
gets a private cache folder of symbolic links into the shared one; what it compiles itself stays in its scratch folder.
"""

from __future__ import annotations

import fcntl
import importlib.metadata
import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import c4s
from c4s.errors import MachineryFault
from c4s.files import digest, write_text
from c4s.folders import remove_tree
from c4s.home import cache_root, home

_PACKAGE = Path(c4s.__file__).resolve().parent
_SOURCES = _PACKAGE / "render"
_TIMEOUT_S = 1200
_WARM = """
from c4s.render.compiled import code_folder
from c4s.engine.headless.pictures.take import warm
warm()
print(code_folder())
"""


def compiled() -> Path:
    """The folder of compiled kernels for these sources, compiled now if there is none (half a minute, once)."""
    note = cache_root() / "kernels" / _stamp()
    found = _noted(note)
    if found is not None:
        return found
    note.parent.mkdir(parents=True, exist_ok=True)
    with note.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        found = _noted(note)
        if found is None:
            found = _compile()
            write_text(note, str(found))
    return found


def _noted(note: Path) -> Path | None:
    """The folder that an earlier compilation left, if it is still there."""
    folder = Path(note.read_text()) if note.is_file() else None
    return folder if folder is not None and next(folder.glob("*/*.nbi"), None) is not None else None


def _compile() -> Path:
    done = subprocess.run(
        [sys.executable, "-c", _WARM],
        cwd=_PACKAGE.parent,
        capture_output=True,
        text=True,
        env={**os.environ, "C4S_HOME": str(home())},
        timeout=_TIMEOUT_S,
        check=False,
    )
    folder = Path(done.stdout.strip() or "none")
    if done.returncode or not folder.is_dir():
        raise MachineryFault(
            f"cannot compile the render kernels: {done.stderr.strip()[-1500:]}",
            where=str(_SOURCES),
            todo="they need a folder to lie in: this one, or C4S_HOME",
        )
    return folder


def _stamp() -> str:
    """Digest of what numba's own cache key looks at: the sources with their times, and the versions."""
    versions = [importlib.metadata.version(name) for name in ("numba", "llvmlite", "embreex", "numpy")]
    files = [[str(path), path.stat().st_mtime_ns, path.stat().st_size] for path in sorted(_SOURCES.glob("*.py"))]
    return digest([sys.version, versions, files, os.uname().machine])[:16]


def linked(shared: Path, scratch: Path) -> Mapping[str, str]:
    """Make ``scratch/kernels`` a private view of the shared folder; the variables that point the renderer at it."""
    private = scratch / "kernels"
    remove_tree(private, inside=scratch, at_best=True)
    private.mkdir(parents=True)
    for source in shared.rglob("*"):
        target = private / shared.name / source.relative_to(shared)
        if source.is_dir():
            target.mkdir(parents=True, exist_ok=True)
        else:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.symlink_to(source)
    return {"NUMBA_CACHE_DIR": str(private)}
