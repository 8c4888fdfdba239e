"""Installs the stand-in: a folder that looks to c4s as an engine's does."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path
from typing import Any

import c4s
from c4s.engine.unreal.host.installation import BUILD, EDITOR, PLUGINS, PROGRAM, STAND_IN
from c4s.engine.unreal.host.launch import READABLE
from c4s.errors import BadInput
from c4s.files import read_json, write_json, write_text

VERSION = (5, 6, 0)
VERSION_TEXT = f"{'.'.join(map(str, VERSION))}-standin"
"""What the stand-in calls itself, in every file that is made with it."""
BEHAVIOUR, KERNELS, ROOT = "standin.json", "kernels", "C4S_STANDIN_ROOT"
_PARENT = Path(c4s.__file__).resolve().parents[1]
_START = "import sys; sys.path.insert(0, sys.argv.pop(1)); from c4s.engine.unreal.standin.editor import main; main()"


def install(root: Path, **behaviour: Any) -> dict[str, str]:
    """Write an installation into a new folder; the variables that let c4s use it.

    ``behaviour``: fields of ``c4s.engine.unreal.standin.editor.Behaviour``. The kernels for its pictures are compiled.
    """
    from c4s.engine.headless.host.kernels import compiled

    if root.exists() and any(root.iterdir()):
        raise BadInput("this is no new or empty folder", where=str(root), todo="choose another name")
    kernels = compiled()
    numbers = dict(zip(("MajorVersion", "MinorVersion", "PatchVersion"), VERSION, strict=True))
    write_json(root / BUILD, {**numbers, "Changelist": 0, "BranchName": STAND_IN})
    for name in PLUGINS:
        write_json(root / "Engine/Plugins/StandIn" / name / f"{name}.uplugin", {"FileVersion": 3})
    write_json(root / BEHAVIOUR, {KERNELS: str(kernels)})
    behave(root, **behaviour)
    python = " ".join(map(shlex.quote, (sys.executable, "-P", "-s", "-B", "-c", _START, str(_PARENT))))
    write_text(root / PROGRAM, f'#!/bin/sh\nexport {ROOT}={shlex.quote(str(root.resolve()))}\nexec {python} "$@"\n')
    (root / PROGRAM).chmod(0o755)
    seen = dict.fromkeys((sys.prefix, sys.base_prefix, str(_PARENT / "c4s"), str(kernels)))
    return {EDITOR: str(root.resolve()), READABLE: ":".join(path for path in seen if path != "/usr")}


def behave(root: Path, **behaviour: Any) -> None:
    """Say how the editors that start from now on behave."""
    write_json(root / BEHAVIOUR, {KERNELS: read_json(root / BEHAVIOUR)[KERNELS], **behaviour})
