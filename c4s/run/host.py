"""The machine that a plan was made on, for the record."""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
from functools import cache
from pathlib import Path

import c4s
from c4s.engine import DEFAULT_ENGINE, backend
from c4s.engine.confine.sandbox import CHOICE, faults
from c4s.records.plan import Host

_CHECKOUT = Path(c4s.__file__).resolve().parents[1]
_GPUS = Path("/proc/driver/nvidia/gpus")


@cache
def this_host() -> Host:
    """This machine."""
    usable = [name for name, fault in faults().items() if fault is None]
    return Host(
        engine_version=backend(DEFAULT_ENGINE).version,
        commit=_commit(_CHECKOUT),
        system=platform.platform(),
        processor=_told(Path("/proc/cpuinfo"), "model name") or platform.machine(),
        cores=len(os.sched_getaffinity(0)),
        gpus=[_told(path, "Model") or path.parent.name for path in sorted(_GPUS.glob("*/information"))],
        sandbox=os.environ.get(CHOICE) or next(iter(usable), None),
    )


def _told(path: Path, field: str) -> str | None:
    """The first value of a field in a file of ``field: value`` lines."""
    if not path.is_file():
        return None
    rows = (line.partition(":") for line in path.read_text(errors="replace").splitlines())
    return next((value.strip() for name, _, value in rows if name.strip() == field), None)


def _commit(folder: Path) -> str | None:
    """The commit of a git checkout, with ``-dirty`` where files were changed; None where it is none."""
    git = shutil.which("git")
    if git is None or not (folder / ".git").exists():
        return None
    told = subprocess.run(
        [git, "-C", str(folder), "describe", "--always", "--dirty", "--exclude=*", "--abbrev=40"],
        capture_output=True,
        text=True,
        check=False,
    )
    return told.stdout.strip() or None
