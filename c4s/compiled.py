"""Compiling a package's kernels once: where the machine code is kept, and what happens when nothing can be written.

The kept code belongs to exactly the package's sources (the folder's name carries their digest), so a changed helper
never leaves a stale kernel. Folders are tried in order: ``NUMBA_CACHE_DIR``, the package's ``__pycache__``, the cache
under ``C4S_HOME``. A folder that holds the code but is read-only is copied to a temporary one; with nowhere to write,
the process compiles for itself.
"""

from __future__ import annotations

import atexit
import functools
import hashlib
import importlib
import os
import shutil
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar, cast

import numba
from numba.np import linalg

from c4s.folders import remove_tree
from c4s.home import cache_root
from c4s.kept_code import prune, writable

_Kernel = TypeVar("_Kernel", bound=Callable[..., Any])


class Kernels:
    """The kernels of one package."""

    def __init__(self, package: Path) -> None:
        self._package = package

    @functools.cached_property
    def sources_digest(self) -> str:
        """Digest of the package's Python files and of the compiler's version."""
        digest = hashlib.sha256(numba.__version__.encode())
        for path in sorted(self._package.glob("*.py")):
            digest.update(path.read_bytes())
        return digest.hexdigest()[:16]

    @functools.cached_property
    def code_folder(self) -> Path | None:
        """A writable folder for compiled code, with the code in it if any candidate has it; ``None`` for none."""
        named = os.environ.get("NUMBA_CACHE_DIR")
        roots = [*([Path(named)] if named else []), self._package / "__pycache__", cache_root()]
        folders = [root / f"kernels-{self.sources_digest}" for root in roots]
        holders = [folder for folder in folders if next(folder.glob("*/*.nbi"), None)]
        for folder in [*holders[:1], *([] if holders else folders)]:
            if writable(folder):
                if not holders and folder.parent == self._package / "__pycache__":
                    prune(folder, "kernels")
                return folder
        try:
            scratch = Path(tempfile.mkdtemp(prefix="c4s-kernels-"))
        except OSError:
            return None
        atexit.register(remove_tree, scratch, inside=scratch.parent, at_best=True)
        if holders:
            shutil.copytree(holders[0], scratch, dirs_exist_ok=True)
        return scratch

    def _kept(self, compile_: Callable[..., Any]) -> Any:
        """What ``compile_(cache=...)`` makes, with its machine code in the folder."""
        _leave_out_linear_algebra()
        config: Any = numba.config
        if self.code_folder is None:
            return compile_(cache=False)
        before = config.CACHE_DIR
        config.CACHE_DIR = str(self.code_folder)
        try:
            return compile_(cache=True)
        finally:
            config.CACHE_DIR = before

    def kernel(self, function: _Kernel) -> _Kernel:
        """Compile a function with numba at its first call, without the interpreter lock, and keep the machine code."""
        compile_: Any = numba.njit
        return cast(_Kernel, self._kept(lambda cache: compile_(nogil=True, cache=cache, error_model="numpy")(function)))

    def callback(self, signature: Any, function: Callable[..., Any]) -> Any:
        """Compile a function that a C library calls, and keep the machine code; the library gets its ``address``."""
        compile_: Any = numba.cfunc
        return self._kept(lambda cache: compile_(signature, cache=cache, error_model="numpy")(function))


@functools.cache
def _leave_out_linear_algebra() -> None:
    """Load numba's array functions as where there is no BLAS: no kernel here uses it, and looking for it loads
    scipy.linalg, which takes as long as all the rest that the first kernel needs."""
    if "scipy.linalg" in sys.modules:
        return
    looked: Any = linalg.ensure_blas
    linalg.ensure_blas = _without
    try:
        importlib.import_module("numba.np.arraymath")
    finally:
        linalg.ensure_blas = looked


def _without() -> None:
    raise ImportError("kernels use no linear algebra")


def inner(function: _Kernel) -> _Kernel:
    """Compile a function that only kernels call.

    It counts no references (several times faster here), as its arrays belong to the caller, and therefore cannot
    allocate; a ``kernel`` must stand between it and Python.
    """
    compile_: Any = numba.njit
    return cast(_Kernel, compile_(nogil=True, _nrt=False, error_model="numpy", forceinline=True)(function))
