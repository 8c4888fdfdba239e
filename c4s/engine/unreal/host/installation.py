"""The Unreal Editor of this machine: where it is, which version, which plugins it has."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from c4s.errors import BadInput, MachineryFault
from c4s.files import read_json

EDITOR = "C4S_UNREAL_EDITOR"
"""Environment variable: the editor program, or the engine's folder."""
VERSION = "C4S_UNREAL_VERSION"
"""Environment variable: the version that the editor must have, in place of ``PINNED``."""
PINNED = "5.6"
"""The version whose Python API c4s's editor scripts are written against."""
KIND, STAND_IN_KIND = "unreal", "unreal-standin"
"""Kinds of engine: what a stand-in made is never taken for Unreal's, nor ranked beside it."""
PROGRAM = Path("Engine/Binaries/Linux/UnrealEditor-Cmd")
BUILD = Path("Engine/Build/Build.version")
PLUGINS = ("PythonScriptPlugin", "EditorScriptingUtilities")
"""What the editor scripts need; a project switches them on."""
STAND_IN = "c4s-standin"
"""The branch that a stand-in editor says it was built from."""
USUAL = ("/home/ue4/UnrealEngine", "/opt/UnrealEngine", "/opt/unreal-engine", "~/UnrealEngine")
"""Folders where an engine is looked for: the first is that of Epic's container images."""


@dataclass(frozen=True)
class Installation:
    """An editor that can be started."""

    root: Path
    """The folder that holds ``Engine``."""
    numbers: tuple[int, int, int]
    stand_in: bool

    @property
    def program(self) -> Path:
        """The editor's program for command lines."""
        return self.root / PROGRAM

    @property
    def kind(self) -> str:
        """The kind of engine that its results are labelled with."""
        return STAND_IN_KIND if self.stand_in else KIND

    @property
    def api(self) -> str:
        """The version that content and scripts are made for: ``5.6``, of a stand-in ``5.6-standin``."""
        return f"{self.numbers[0]}.{self.numbers[1]}{'-standin' if self.stand_in else ''}"

    @property
    def version(self) -> str:
        """The whole version: ``5.6.0``, of a stand-in ``5.6.0-standin``."""
        return f"{'.'.join(map(str, self.numbers))}{'-standin' if self.stand_in else ''}"

    def missing_plugins(self) -> list[str]:
        """The plugins that it lacks."""
        folder = self.root / "Engine/Plugins"
        return [name for name in PLUGINS if next(folder.glob(f"*/{name}/{name}.uplugin"), None) is None]


def find_installation(kind: str) -> Installation:
    """The editor for a kind of engine: the one that ``C4S_UNREAL_EDITOR`` names, else the first in a usual place.

    ``MachineryFault`` in one line where there is none, it is none of that kind, of another version, or lacks a plugin.
    """
    found = installed()
    if found.kind != kind:
        raise MachineryFault(
            f"this editor is {found.version}, of the engine {found.kind}",
            where=str(found.root),
            todo=f"ask for that engine, or let {EDITOR} name another editor",
        )
    wanted = os.environ.get(VERSION) or PINNED
    if found.version.removesuffix("-standin") != wanted and found.api.removesuffix("-standin") != wanted:
        raise MachineryFault(
            f"this editor is {found.version}, and c4s is pinned to {wanted}",
            where=str(found.root),
            todo=f"install {wanted}, or set {VERSION} once `c4s engine conform --engine unreal` has passed on this one",
        )
    missing = found.missing_plugins()
    if missing:
        raise MachineryFault(
            f"this editor has no plugin {' and '.join(missing)}",
            where=str(found.root / "Engine/Plugins"),
            todo="install the engine with its editor plugins",
        )
    return found


def installed() -> Installation:
    """The editor that is there, of whatever version; ``MachineryFault`` where there is none."""
    told = os.environ.get(EDITOR, "").strip()
    places = [Path(told)] if told else [Path(place).expanduser() for place in USUAL]
    for place in places:
        root = _root(place)
        if root is not None:
            return _read(root)
    if told:
        raise MachineryFault("this is no Unreal Editor", where=told, todo=f"set {EDITOR} to one, or to its engine")
    raise MachineryFault(
        f"no Unreal Editor: {EDITOR} is not set, and there is none in {', '.join(USUAL)}",
        todo="docs/unreal.md says what a host needs, and how to rehearse without one; else use the engine headless",
    )


def _root(place: Path) -> Path | None:
    """The folder of an engine, told by it or by a program in it."""
    if place.is_file():
        return next((above for above in place.absolute().parents if (above / BUILD).is_file()), None)
    return place.absolute() if (place / PROGRAM).is_file() else None


def _read(root: Path) -> Installation:
    try:
        build = read_json(root / BUILD, what="version of the engine", plain=True)
        numbers = (int(build["MajorVersion"]), int(build["MinorVersion"]), int(build["PatchVersion"]))
    except (BadInput, KeyError, TypeError, ValueError) as error:
        raise MachineryFault(f"this engine does not say its version: {error}", where=str(root / BUILD)) from error
    return Installation(root, numbers, build.get("BranchName") == STAND_IN)
