"""The compiled numerical kernels (numba): compiled once by a trusted process, read-only to every engine.

A cache entry is machine code, so an engine that runs agent code must never write what another engine loads. Each engine
gets a private cache folder of symbolic links into the shared one; what it compiles itself stays in its scratch folder.
"""

from __future__ import annotations

import fcntl
import os
import shutil
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import c4s
from c4s.errors import MachineryFault
from c4s.files import digest
from c4s.home import cache_root

_PACKAGE = Path(c4s.__file__).resolve().parent
_SOURCES = _PACKAGE / "engine/headless/render"
_TIMEOUT_S = 600
_WARM = "from c4s.engine.headless.render_scene import warm; warm()"


def compiled() -> Path:
    """The folder of compiled kernels for these sources, compiled now if there is none (some seconds, once)."""
    folder = _root() / f"compiled-{_stamp()}"
    if (folder / "ready").is_file():
        return folder
    folder.parent.mkdir(parents=True, exist_ok=True)
    with (folder.parent / f".{folder.name}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (folder / "ready").is_file():
            _compile(folder)
    return folder


def _root() -> Path:
    """Beside the sources, where every ``C4S_HOME`` shares it; else in the cache of ``C4S_HOME``."""
    return _SOURCES / "__pycache__" if os.access(_SOURCES, os.W_OK) else cache_root() / "numba"


def _compile(folder: Path) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    done = subprocess.run([sys.executable, "-c", _WARM], env={**os.environ, "NUMBA_CACHE_DIR": str(folder)},
                          cwd=_PACKAGE.parent, capture_output=True, text=True, timeout=_TIMEOUT_S, check=False)
    if done.returncode:
        raise MachineryFault(f"cannot compile the render kernels: {done.stderr.strip()[-1500:]}", where=str(folder))
    (folder / "ready").touch()


def _stamp() -> str:
    """Digest of what numba's own cache key looks at: the sources with their times, and the versions."""
    import importlib.metadata

    files = sorted(_SOURCES.rglob("*.py"))
    versions = [importlib.metadata.version(name) for name in ("numba", "llvmlite", "embreex", "numpy")]
    return digest([sys.version, versions, [[str(path), path.stat().st_mtime_ns, path.stat().st_size] for path in files],
                   os.uname().machine])[:16]


def linked(shared: Path, scratch: Path) -> Mapping[str, str]:
    """Make ``scratch/kernels`` a private view of the shared folder; the variables that point numba at it."""
    private = scratch / "kernels"
    shutil.rmtree(private, ignore_errors=True)
    for source in shared.rglob("*"):
        target = private / source.relative_to(shared)
        if source.is_dir():
            target.mkdir(parents=True, exist_ok=True)
        else:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.symlink_to(source)
    private.mkdir(parents=True, exist_ok=True)
    return {"NUMBA_CACHE_DIR": str(private)}
