"""How an editor is started: its command line, its environment, and what confines it."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Final

import c4s
from c4s.engine.confine.confinement import Backend, Limits
from c4s.engine.confine.sandbox import CHOICE, Mounts
from c4s.engine.confine.sandbox import backend as choose_sandbox
from c4s.engine.unreal.host.installation import Installation
from c4s.engine.unreal.host.project import Project
from c4s.engine.unreal.host.slots import CUDA, MARK, EditorSlot
from c4s.errors import BadInput, MachineryFault

READABLE = "C4S_UNREAL_READABLE"
"""Environment variable: more paths that the editor may read, with ``:`` between them."""
FLAGS: Final = (
    "-unattended",
    "-nosplash",
    "-nopause",
    "-nosound",
    "-nop4",
    "-RenderOffScreen",
    "-stdout",
    "-FullStdOutLogOutput",
)
LIMITS: Final = Limits(
    memory=48 << 30, threads=2048, files=200_000, disk=32 << 30, written=256 << 30, file_size=8 << 30
)
"""What ends an editor: it takes far more than the headless engine. The kernel's own limits are left as they are."""
_SPLITTING: Final = " ,\"'"
"""What ends a command on the editor's command line."""
_SYSTEM: Final = ("/usr", "/etc", "/lib", "/lib64", "/bin", "/sbin", "/opt/nvidia", "/sys")
_PROC: Final = (
    "/proc/self",
    *(f"/proc/{name}" for name in ("cpuinfo", "driver", "filesystems", "meminfo", "stat", "sys", "uptime", "version")),
)
"""Of ``/proc`` under Landlock: the editor's own, and the machine's; of other processes nothing."""
_DEVICES: Final = ("/dev/nvidia*", "/dev/nvidia-caps", "/dev/dri")
_DEVICE_FILES: Final = ("/dev/null", "/dev/zero", "/dev/random", "/dev/urandom", "/dev/shm")


def command_line(editor: Installation, project: Project, slot: EditorSlot) -> list[str]:
    """The program with its arguments: no window, no question, the log on standard output, our script at the start."""
    if any(mark in str(project.start_script) for mark in _SPLITTING):
        raise BadInput(
            "an editor's commands cannot name a path with a blank, a comma or a quote",
            where=str(project.root),
            todo="use a C4S_HOME and a TMPDIR without",
        )
    adapter = [f"-graphicsadapter={slot.gpu}"] if slot.gpu.isdecimal() else []
    return [
        str(editor.program),
        str(project.file),
        *FLAGS,
        f"-abslog={project.log}",
        *adapter,
        f"-ExecCmds=py {project.start_script}",
    ]


def environment(project: Project, slot: EditorSlot) -> dict[str, str]:
    """The variables that an editor gets: none of the host's but where programs and GPU drivers are found."""
    kept = {name: os.environ[name] for name in ("PATH", "LD_LIBRARY_PATH", "VK_ICD_FILENAMES") if name in os.environ}
    gpu = {CUDA: slot.gpu, "NVIDIA_VISIBLE_DEVICES": slot.gpu} if slot.gpu else {}
    return {
        **kept,
        **gpu,
        "HOME": str(project.root),
        "TMPDIR": str(project.root / "Saved"),
        "LANG": "C.UTF-8",
        MARK: slot.mark,
    }


def start(
    command: Sequence[str], variables: dict[str, str], mounts: Mounts, *, life: int, output: int, use: Backend
) -> subprocess.Popen[bytes]:
    """Start a keeper that starts the editor, in what confines it. Their output goes to the descriptor ``output``."""
    rules = None
    if use == "bubblewrap":
        command = _bubblewrapped(command, variables, mounts)
    elif use == "landlock":
        devices = [str(path) for pattern in (*_DEVICES, *_DEVICE_FILES) for path in Path("/").glob(pattern[1:])]
        rules = {
            "programs": [*_SYSTEM, *_PROC, *map(str, mounts.read_only)],
            "read_write": [*map(str, mounts.read_write)],
            "devices": devices,
        }
    keeper = [sys.executable, "-P", "-s", "-B", "-m", "c4s.engine.unreal.host.keeper", str(life), json.dumps(rules)]
    return subprocess.Popen(
        [*keeper, *command],
        stdin=subprocess.DEVNULL,
        stdout=output,
        stderr=output,
        env={**variables, "PYTHONPATH": str(_package().parent)},
        cwd=mounts.work,
        pass_fds=(life,),
        start_new_session=True,
    )


def choose() -> Backend:
    """What confines editors here: as for any engine, and bubblewrap only where it can show a process its own /proc."""
    chosen = choose_sandbox()
    if chosen != "bubblewrap":
        return chosen
    fault = _bubblewrap_fault()
    if fault is None:
        return chosen
    if os.environ.get(CHOICE):
        raise MachineryFault(f"bubblewrap cannot hold an editor here: {fault}", where=CHOICE)
    return "landlock"


@cache
def _bubblewrap_fault() -> str | None:
    trial = subprocess.run(
        _bubblewrapped(["/usr/bin/true"], {}, Mounts()), capture_output=True, text=True, env={}, check=False
    )
    return trial.stderr.strip() or "it ended with an error" if trial.returncode else None


def readable() -> tuple[Path, ...]:
    """The paths that ``C4S_UNREAL_READABLE`` names."""
    return tuple(Path(path) for path in os.environ.get(READABLE, "").split(":") if path)


def _package() -> Path:
    return Path(c4s.__file__).resolve().parent


def _bubblewrapped(command: Sequence[str], variables: dict[str, str], mounts: Mounts) -> list[str]:
    words = [
        *(shutil.which("bwrap") or "bwrap", "--unshare-all", "--unshare-user", "--disable-userns"),
        *("--uid", "1000", "--gid", "1000", "--die-with-parent", "--cap-drop", "ALL", "--hostname", "engine"),
        *("--clearenv", "--proc", "/proc", "--dev", "/dev", "--tmpfs", "/tmp"),
    ]
    for path in (Path(path) for path in _SYSTEM):
        if path.is_symlink():
            words += ["--symlink", str(path.readlink()), str(path)]
        elif path.exists():
            words += ["--ro-bind", str(path), str(path)]
    for device in (device for pattern in _DEVICES for device in Path("/").glob(pattern[1:])):
        words += ["--dev-bind", str(device), str(device)]
    for option, paths in (("--ro-bind", mounts.read_only), ("--bind", mounts.read_write)):
        for path in paths:
            words += [option, str(path), str(path)]
    for name, value in variables.items():
        words += ["--setenv", name, value]
    return [*words, "--chdir", str(mounts.work) if mounts.read_write else "/", "--", *command]
