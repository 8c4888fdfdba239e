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
from contextlib import suppress
from pathlib import Path

import c4s
from c4s.errors import MachineryFault
from c4s.files import digest, write_text
from c4s.folders import remove_tree
from c4s.home import cache_root, home

_PACKAGE = Path(c4s.__file__).resolve().parent
_SOURCES = (_PACKAGE / "render", _PACKAGE / "navigation")
_TIMEOUT_S = 1200
_WARM = """
from c4s.navigation import compiled, warm as warm_navigation
from c4s.render.compiled import code_folder
from c4s.engine.headless.pictures.take import warm
warm()
warm_navigation()
print(code_folder())
print(compiled.code_folder())
"""


def compiled() -> Path:
    """The folder of compiled kernels for these sources, compiled now if there is none (half a minute, once).

    What another home had compiled beside the sources is used as it is.
    """
    note = cache_root() / "kernels" / _stamp()
    found = _noted(note)
    if found is not None:
        return found
    note.parent.mkdir(parents=True, exist_ok=True)
    with note.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        found = _noted(note)
        if found is None:
            folders = _beside() or _compile()
            write_text(note, "\n".join(map(str, folders)))
            with suppress(OSError):
                write_text(folders[0] / note.name, "\n".join(map(str, folders)))
            found = folders[0]
    return found


def _noted(note: Path) -> Path | None:
    """The folder that an earlier compilation left, if it is still there."""
    folders = _folders(note)
    return folders[0] if folders and all(next(folder.glob("*/*.nbi"), None) for folder in folders) else None


def _beside() -> list[Path]:
    """The folders beside the sources, where a home noted there that all is compiled; none else."""
    notes = (_SOURCES[0] / "__pycache__").glob(f"kernels-*/{_stamp()}")
    return next((_folders(note) for note in notes if _noted(note) is not None), [])


def _folders(note: Path) -> list[Path]:
    """The folders that a note names: those of the renderer, and of the walkable space."""
    return [Path(line) for line in note.read_text().splitlines()] if note.is_file() else []


def _compile() -> list[Path]:
    done = subprocess.run(
        [sys.executable, "-c", _WARM],
        cwd=_PACKAGE.parent,
        capture_output=True,
        text=True,
        env={**os.environ, "C4S_HOME": str(home())},
        timeout=_TIMEOUT_S,
        check=False,
    )
    folders = [Path(line) for line in done.stdout.split("\n") if line]
    if done.returncode or len(folders) != len(_SOURCES) or not all(folder.is_dir() for folder in folders):
        raise MachineryFault(
            f"cannot compile the kernels: {done.stderr.strip()[-1500:]}",
            where=str(_PACKAGE),
            todo="they need a folder to lie in: this one, or C4S_HOME",
        )
    return folders


def _stamp() -> str:
    """Digest of what numba's own cache key looks at: the sources with their times, and the versions."""
    versions = [importlib.metadata.version(name) for name in ("numba", "llvmlite", "embreex", "numpy")]
    sources = [path for folder in _SOURCES for path in sorted(folder.glob("*.py"))]
    files = [[str(path), path.stat().st_mtime_ns, path.stat().st_size] for path in sources]
    return digest([sys.version, versions, files, os.uname().machine])[:16]


def linked(shared: Path, scratch: Path) -> Mapping[str, str]:
    """Make ``scratch/kernels`` a private view of the shared folders; the variables that point the kernels at it."""
    private = scratch / "kernels"
    remove_tree(private, inside=scratch, at_best=True)
    private.mkdir(parents=True)
    for folder in dict.fromkeys([shared, *_folders(cache_root() / "kernels" / _stamp())]):
        for source in folder.rglob("*"):
            target = private / folder.name / source.relative_to(folder)
            if source.is_dir():
                target.mkdir(parents=True, exist_ok=True)
            else:
                target.parent.mkdir(parents=True, exist_ok=True)
                target.symlink_to(source)
    return {"NUMBA_CACHE_DIR": str(private)}
