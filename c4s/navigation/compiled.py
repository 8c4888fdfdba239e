"""The kernels of the walkable space (``c4s.compiled``)."""

from __future__ import annotations

from pathlib import Path

from c4s.compiled import Kernels, inner

__all__ = ["code_folder", "inner", "kernel"]

_KERNELS = Kernels(Path(__file__).parent)
kernel = _KERNELS.kernel


def code_folder() -> Path | None:
    """The folder of this package's compiled code."""
    return _KERNELS.code_folder
