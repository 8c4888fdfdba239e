"""Finding an installed client: its program, its version, and the folders that it must read."""

from __future__ import annotations

import json
import os
import shutil
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c4s.errors import BadInput
from c4s.home import home


@dataclass(frozen=True)
class Install:
    """A package of a registry and the program in it."""

    registry: str
    """``npm`` or ``pypi``."""
    package: str
    program: str

    def folder(self) -> Path:
        """Where ``make test-clients`` and the printed command install it."""
        return home() / "clients" / self.program

    def command(self) -> list[str]:
        """The command line that installs it there."""
        if self.registry == "npm":
            return ["npm", "install", "--no-audit", "--no-fund", "--prefix", str(self.folder()), self.package]
        folder = self.folder()
        return [
            "sh",
            "-c",
            f"'{sys.executable}' -m venv '{folder}' && '{folder}/bin/pip' install --quiet '{self.package}'",
        ]


@dataclass(frozen=True)
class Program:
    """An installed client."""

    path: Path
    version: str
    read_only: tuple[Path, ...]


def find(install: Install, options: Mapping[str, Any]) -> Program:
    """The program: the option ``program``, else the one under ``C4S_HOME/clients``, else the one on the path.

    ``BadInput`` with the installing command when there is none.
    """
    told = options.get("program")
    places = (
        [Path(str(told)).absolute()]
        if told
        else [install.folder() / "node_modules" / ".bin" / install.program, install.folder() / "bin" / install.program]
    )
    found = next((place for place in places if place.is_file()), None)
    if found is None and not told and (on_path := shutil.which(install.program)):
        found = Path(on_path).absolute()
    if found is None or not os.access(found, os.X_OK):
        raise BadInput(
            f"the client {install.program!r} is not installed" + (f" at {told}" if told else ""),
            todo="install it with: " + " ".join(f'"{part}"' if " " in part else part for part in install.command()),
        )
    return Program(found, _version(found, install), _needs(found))


def _needs(program: Path) -> tuple[Path, ...]:
    """The installation around a program: an npm prefix, a virtual environment with its base, or the file alone."""
    for folder in program.parents:
        if folder.name == "node_modules":
            return (folder,)
        if (folder / "pyvenv.cfg").is_file():
            python = (folder / "bin" / "python").resolve()
            return (folder, folder.resolve(), *(() if python.is_relative_to("/usr") else (python.parents[1],)))
    real = program.resolve()
    return (real,) if not real.is_relative_to("/usr") else ()


def _version(program: Path, install: Install) -> str:
    """The version that the installed package states; empty where it states none."""
    for folder in program.parents:
        manifest = folder / install.package / "package.json"
        if folder.name == "node_modules" and manifest.is_file():
            return str(json.loads(manifest.read_text()).get("version", ""))
        if (folder / "pyvenv.cfg").is_file():
            name = install.package.partition("[")[0].replace("-", "_")
            found = sorted(folder.glob(f"lib/python*/site-packages/{name}-*.dist-info"))
            return found[-1].name.removesuffix(".dist-info").rpartition("-")[2] if found else ""
    return ""
