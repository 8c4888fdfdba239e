"""Starts the engine process in a sandbox: bubblewrap, else Landlock, else a refusal that says what is missing.

Inside there are the Python runtime, the package ``c4s``, and the paths that the caller names; no network, no other
process, no other file. ``c4s.engine.confine.confinement`` closes the rest from inside.
"""

from __future__ import annotations

import functools
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import c4s
from c4s.engine.confine import landlock, seccomp
from c4s.engine.confine.confinement import Backend, Confinement, Limits
from c4s.errors import BadInput, MachineryFault

CHOICE = "C4S_SANDBOX"
"""Environment variable: which sandbox, or ``none``."""
_SYSTEM = ("/usr/lib", "/usr/lib64", "/lib", "/lib64", "/etc/ld.so.cache", "/etc/localtime", "/usr/share/zoneinfo")
_RUNTIME_PARTS = ("bin", "lib", "lib64", "pyvenv.cfg")
_PACKAGE = Path(c4s.__file__).resolve().parent
_BOOTSTRAP = "import sys; sys.path.insert(0, sys.argv.pop(1)); from {module} import main; main()"


@dataclass(frozen=True)
class Mounts:
    """What the process may see besides the runtime, at the paths that the host uses. All absolute."""

    read_only: tuple[Path, ...] = ()
    read_write: tuple[Path, ...] = ()
    work: Path = field(default_factory=Path.cwd)
    """Working and temporary folder; must be one of ``read_write``."""


def backend() -> Backend:
    """The sandbox that engines get here: the one that ``C4S_SANDBOX`` names, else the first that works.

    ``C4S_SANDBOX=none`` accepts the risk of agent code without one. ``BadInput`` for another name, ``MachineryFault``
    when the sandbox that is asked for, or every sandbox, is missing: agent code never runs without one by itself.
    """
    wanted, missing = os.environ.get(CHOICE, ""), faults()
    if wanted == "none":
        return "none"
    if wanted and wanted not in missing:
        raise BadInput(f"no sandbox is called {wanted!r}", where=CHOICE, todo=f"{', '.join(missing)} or none")
    for name, fault in missing.items():
        if fault is None and wanted in ("", name):
            return name
    raise MachineryFault(
        "no sandbox for the engine, so it will not start: "
        + "; ".join(f"{name}: {fault}" for name, fault in missing.items() if wanted in ("", name)),
        todo="install bubblewrap, or use Linux 6.7 or newer with Landlock enabled, or set "
        f"{CHOICE}=none to accept that agent code can do whatever you can",
    )


@functools.cache
def faults() -> dict[Backend, str | None]:
    """Why each sandbox is unusable here, or ``None`` where it works; in order of preference."""
    if not seccomp.supported():
        reason = f"no system-call filter for the processor {os.uname().machine}"
        return {"bubblewrap": reason, "landlock": reason}
    return {"bubblewrap": _bubblewrap_fault(), "landlock": _landlock_fault()}


def _bubblewrap_fault() -> str | None:
    program = shutil.which("bwrap")
    if program is None:
        return "not installed (Debian and Ubuntu: the package bubblewrap)"
    mounts = [argument for path in _system_paths() for argument in _mount(path, writable=False)]
    trial = subprocess.run(
        [
            program,
            *_NAMESPACES,
            *mounts,
            *_mount(Path("/usr/bin/true"), writable=False),
            *_SEALED,
            "--",
            "/usr/bin/true",
        ],
        capture_output=True,
        text=True,
        env={},
        check=False,
    )
    return None if trial.returncode == 0 else f"cannot create namespaces ({trial.stderr.strip()})"


def _landlock_fault() -> str | None:
    version = landlock.abi()
    if version >= landlock.REQUIRED_ABI:
        return None
    return f"the kernel offers Landlock ABI {version}, {landlock.REQUIRED_ABI} is needed"


_NAMESPACES = (
    "--unshare-all",
    "--unshare-user",
    "--disable-userns",
    "--uid",
    "65534",
    "--gid",
    "65534",
    "--die-with-parent",
    "--new-session",
    "--as-pid-1",
    "--cap-drop",
    "ALL",
    "--hostname",
    "engine",
    "--clearenv",
    "--tmpfs",
    "/dev",
    *(word for device in landlock.DEVICES for word in ("--dev-bind", device, device)),
)
_SEALED = ("--remount-ro", "/dev", "--remount-ro", "/")


def start(
    module: str,
    arguments: Mapping[str, Any],
    *,
    paths: Mounts,
    output: int,
    keep_open: Sequence[int] = (),
    limits: Limits | None = None,
    environment: Mapping[str, str] | None = None,
    use: Backend | None = None,
) -> subprocess.Popen[bytes]:
    """Start ``module.main`` with ``{"confinement", **arguments}`` as JSON in ``sys.argv[1]``; it must confine itself.

    Its standard output and error go to the descriptor ``output``. The whole process tree (one process: it can start
    no other) dies with this process.
    """
    name = use or backend()
    runtime = _runtime_paths()
    rules = Confinement(
        name,
        os.getpid(),
        tuple(map(str, (*_system_paths(), *runtime, *paths.read_only))),
        tuple(map(str, paths.read_write)),
        limits or Limits(),
    )
    program = [
        sys.executable,
        "-s",
        "-P",
        "-B",
        "-X",
        "faulthandler",
        "-c",
        _BOOTSTRAP.format(module=module),
        str(_PACKAGE.parent),
        json.dumps({"confinement": asdict(rules), **arguments}),
    ]
    variables = {
        "PATH": "/usr/bin",
        "HOME": str(paths.work),
        "TMPDIR": str(paths.work),
        "LANG": "C.UTF-8",
        "PYTHONHASHSEED": "0",
        "OPENBLAS_NUM_THREADS": "1",
        "OMP_NUM_THREADS": "1",
        **(environment or {}),
    }
    if name == "bubblewrap":
        program = _bubblewrap(program, (*_system_paths(), *runtime, *paths.read_only), paths, variables)
        variables = {"PATH": "/usr/bin:/bin"}
    return (
        _spawner(os.getpid())
        .submit(
            subprocess.Popen,
            program,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=output,
            env=variables,
            cwd=str(paths.work),
            pass_fds=tuple(keep_open),
            start_new_session=True,
        )
        .result()
    )


@functools.cache
def _spawner(process: int) -> ThreadPoolExecutor:
    """The one thread of this process that starts engines. The kernel kills an engine when the thread that started it
    ends, so it must be a thread that lives as long as the process."""
    return ThreadPoolExecutor(1, thread_name_prefix=f"engine-spawner-{process}")


def _bubblewrap(
    program: Sequence[str], visible: Iterable[Path], paths: Mounts, variables: Mapping[str, str]
) -> list[str]:
    command = [shutil.which("bwrap") or "bwrap", *_NAMESPACES]
    for path in visible:
        command += _mount(path, writable=False)
    for path in paths.read_write:
        command += _mount(path, writable=True)
    for name, value in variables.items():
        command += ["--setenv", name, value]
    return [*command, *_SEALED, "--chdir", str(paths.work), "--", *program]


def _mount(path: Path, *, writable: bool) -> list[str]:
    if path.is_symlink() and not writable:
        return ["--symlink", str(path.readlink()), str(path)]
    return ["--bind" if writable else "--ro-bind", str(path), str(path)]


@functools.cache
def _system_paths() -> tuple[Path, ...]:
    return tuple(path for path in map(Path, _SYSTEM) if path.exists())


@functools.cache
def _runtime_paths() -> tuple[Path, ...]:
    """The interpreter, its libraries and packages (the virtual environment and its base), and the package ``c4s``."""
    if sys.base_prefix == "/usr":
        parts = [Path(sys.executable).resolve()]
    else:
        parts = [Path(sys.base_prefix, part) for part in _RUNTIME_PARTS]
    if sys.prefix != sys.base_prefix:
        parts += [Path(sys.prefix, part) for part in _RUNTIME_PARTS]
    parts.append(_PACKAGE)
    return tuple(dict.fromkeys(path for path in parts if path.exists()))
