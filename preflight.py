"""Whether this machine can set c4s up, told by ``make setup`` in one line. Any Python 3.6 reads this file."""

import os
import platform
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Tuple  # noqa: UP035

PYTHON = (3, 11)
GLIBC = (2, 28)
TREE = Path(__file__).resolve().parent


def glibc() -> Tuple[int, ...]:  # noqa: UP006
    """The version of the GNU C library; nothing where the system has another one."""
    try:
        told = os.confstr("CS_GNU_LIBC_VERSION") or ""
    except (OSError, ValueError):
        told = ""
    return tuple(int(part) for part in told.replace("glibc ", "").split(".") if part.isdigit())


def missing() -> str:
    """What c4s needs and this machine lacks, with what to do; empty where nothing is missing."""
    if sys.version_info < PYTHON:
        return f"Python 3.11 or newer, this is {sys.version.split()[0]}: run make PYTHON=python3.11 ..."
    if (sys.platform, platform.machine()) != ("linux", "x86_64"):
        return f"Linux on x86-64, this is {platform.system()} on {platform.machine()}"
    if glibc() < GLIBC:
        told = ".".join(map(str, glibc())) or "another C library (musl: Alpine, Void), for which packages are not built"
        return f"glibc 2.28 or newer, this is {told}: use Debian, Ubuntu, Fedora or a container of one of them"
    if find_spec("ensurepip") is None:
        return f"ensurepip to make .venv (Debian, Ubuntu: apt install python3-venv), {sys.executable} has none"
    if not os.access(str(TREE), os.W_OK):
        return f"to write to {TREE} once, to make .venv there: copy it to a folder of yours and set it up there"
    return ""


if __name__ == "__main__" and missing():
    sys.exit(f"c4s needs {missing()}")
