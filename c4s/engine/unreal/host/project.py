"""The project of one editor: made new for each, so that nothing of an earlier one is in its reach."""

from __future__ import annotations

import os
import shutil
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import c4s
from c4s.engine.unreal.host.content import content_files, mesh_facts
from c4s.engine.unreal.host.installation import PLUGINS, Installation
from c4s.errors import BadInput
from c4s.files import write_json, write_text
from c4s.folders import remove_tree
from c4s.records.level import Level

NAME = "C4SProject"
GAME = "Game"
"""Below a content folder: what lies in a project's ``Content``."""
SAVED: Final = (".umap", ".uasset")
"""Suffixes of the packages of a submission."""
_PACKAGE = Path(c4s.__file__).resolve().parent
INSIDE: Final = (
    "__init__.py",
    "bounds.py",
    "errors.py",
    "editor",
    "engine/__init__.py",
    "engine/base.py",
    "engine/channel.py",
    "engine/faults.py",
    "engine/finding.py",
    "engine/inside",
    "engine/unreal/boot",
)
"""Of the package ``c4s``: what runs inside the editor."""
_FACES: Final = ("engine/unreal",)
"""Packages of it whose own face stays outside."""
_START = """import sys

sys.path.insert(0, {modules!r})
from c4s.engine.unreal.boot.serve import main

main({job!r})
"""
_ENGINE_INI = """[/Script/EngineSettings.GameMapsSettings]
EditorStartupMap=
GameDefaultMap=

[/Script/PythonScriptPlugin.PythonScriptPluginSettings]
bRemoteExecution=False
bDeveloperMode=False
bIsolateInterpreterEnvironment=True

[/Script/NavigationSystem.NavigationSystemV1]
bAutoCreateNavigationData=True

[/Script/NavigationSystem.RecastNavMesh]
RuntimeGeneration=Dynamic

[/Script/UnrealEd.AnalyticsPrivacySettings]
bSendUsageData=False

[/Script/UnrealEd.CrashReportsPrivacySettings]
bSendUnattendedBugReports=False
"""
_CACHE_INI = """
[{section}]
Local=(Type=FileSystem, ReadOnly=false, Clean=false, Flush=false, Path="{local}")
Shared=(Type=FileSystem, ReadOnly={read_only}, Clean=false, Flush=false, Path="{shared}")
"""
_SECTIONS = ("InstalledDerivedDataBackendGraph", "DerivedDataBackendGraph")


@dataclass(frozen=True)
class Project:
    """Where the parts of a project lie."""

    root: Path
    linked: frozenset[Path]
    """Files below ``Content`` that are the packs', not the project's own."""

    @property
    def file(self) -> Path:
        """The project file that the editor is given."""
        return self.root / f"{NAME}.uproject"

    @property
    def content(self) -> Path:
        """What ``/Game`` is to the editor."""
        return self.root / "Content"

    @property
    def start_script(self) -> Path:
        """The script that the editor runs when it has started."""
        return self.root / "Start" / "start.py"

    @property
    def log(self) -> Path:
        """The editor's own log file."""
        return self.root / "Saved" / "Logs" / f"{NAME}.log"

    def clear_derived(self) -> None:
        """Remove what the editor can make again; its log, its reports and what scripts wrote stay."""
        for name in ("DerivedDataCache", "Intermediate", "Start"):
            remove_tree(self.root / name, inside=self.root, at_best=True)

    @property
    def crashes(self) -> Path:
        """Where the editor puts its crash reports."""
        return self.root / "Saved" / "Crashes"


def make_project(
    root: Path,
    editor: Installation,
    *,
    packs: Sequence[Path],
    content: Path,
    levels: Sequence[Path],
    start_map: str | None,
    offered: Sequence[str] | None,
    cache: Path,
    cache_read_only: bool,
    job: Mapping[str, Any],
) -> Project:
    """Make a project in ``root``, which is replaced: files, settings, the packs' content as links, saved packages as
    copies, level documents that the editor makes levels of.

    ``job``: what else the start script is told. ``BadInput`` for packs, levels or a start map that cannot be used.
    """
    remove_tree(root, inside=root.parent)
    linked = _linked(packs, offered, editor)
    project = Project(root, frozenset(linked))
    known = {level.package: level for level in map(Level.read, levels)}
    if len(known) < len(levels):
        raise BadInput("two level documents have one package", where=str(levels[-1]))
    _write_settings(project, editor, cache, cache_read_only)
    for place, file in linked.items():
        (project.content / place).parent.mkdir(parents=True, exist_ok=True)
        (project.content / place).symlink_to(file)
    _copy_saved(content / GAME, project)
    if start_map is not None and start_map not in known and not _map_file(project, start_map).is_file():
        raise BadInput("no such start map", where=start_map, todo="give its level document in `levels`")
    _write_start(project, packs, {**job, "start_map": start_map}, list(known.values()))
    return project


def _linked(packs: Sequence[Path], offered: Sequence[str] | None, editor: Installation) -> dict[Path, Path]:
    linked: dict[Path, Path] = {}
    for pack in packs:
        for place, file in content_files(pack, offered, editor).items():
            if linked.get(place, file) != file:
                raise BadInput(f"Content/{place} is in two packs", where=str(pack))
            linked[place] = file
    return linked


def _map_file(project: Project, package: str) -> Path:
    return project.content / f"{package.removeprefix('/Game/')}.umap"


def _write_settings(project: Project, editor: Installation, cache: Path, cache_read_only: bool) -> None:
    write_json(
        project.file,
        {
            "FileVersion": 3,
            "EngineAssociation": ".".join(map(str, editor.numbers[:2])),
            "Category": "",
            "Description": "",
            "DisableEnginePluginsByDefault": False,
            "Plugins": [{"Name": name, "Enabled": True} for name in PLUGINS],
        },
    )
    caches = "".join(
        _CACHE_INI.format(
            section=section,
            local=project.root / "DerivedDataCache",
            shared=cache,
            read_only=str(cache_read_only).lower(),
        )
        for section in _SECTIONS
    )
    write_text(project.root / "Config" / "DefaultEngine.ini", _ENGINE_INI + caches)
    for folder in (project.content, project.log.parent, project.crashes):
        folder.mkdir(parents=True, exist_ok=True)


def _write_start(project: Project, packs: Sequence[Path], job: Mapping[str, Any], levels: Sequence[Level]) -> None:
    folder = project.start_script.parent
    modules = folder / "modules"
    for name in INSIDE:
        source, target = _PACKAGE / name, modules / "c4s" / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copyfile(source, target)
    for name in _FACES:
        write_text(modules / "c4s" / name / "__init__.py", "")
    documents = []
    for number, level in enumerate(levels):
        level.write(folder / f"level-{number}.json")
        documents.append(str(folder / f"level-{number}.json"))
    write_json(folder / "facts.json", mesh_facts(packs))
    write_json(folder / "job.json", {**job, "levels": documents, "facts": str(folder / "facts.json")})
    write_text(project.start_script, _START.format(modules=str(modules), job=str(folder / "job.json")))


def _copy_saved(source: Path, project: Project) -> None:
    """Copy the packages that lie in a content folder into the project, links left out."""
    for file in _packages(source):
        target = project.content / file.relative_to(source)
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.is_symlink():
            shutil.copyfile(file, target)


def saved_packages(project: Project) -> list[Path]:
    """Packages that lie in the project and are no pack's, as paths below ``Content``, those written first first."""
    found = []
    for file in _packages(project.content):
        with suppress(FileNotFoundError):  # a script that still runs may have removed it again
            found.append((file.lstat().st_mtime_ns, file.relative_to(project.content)))
    return [name for _, name in sorted(found) if name not in project.linked]


def _packages(folder: Path) -> list[Path]:
    """Plain files with a package's suffix, below a folder; no link is followed."""
    return [
        Path(above) / name
        for above, _, names in os.walk(folder)
        for name in names
        if name.endswith(SAVED) and not (Path(above) / name).is_symlink() and (Path(above) / name).is_file()
    ]
