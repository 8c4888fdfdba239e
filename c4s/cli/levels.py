"""Levels that a command is given, and the built packs that they need."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from c4s.cli.suites import built_suite
from c4s.engine import DEFAULT_ENGINE, backend
from c4s.errors import unknown
from c4s.home import packs_root
from c4s.packs.store import object_path
from c4s.packs.suite_check import check_case
from c4s.records.level import Level
from c4s.records.pack import Pack
from c4s.records.suite import SuiteFolder


@dataclass(frozen=True)
class ScriptGround:
    """Where a script runs: pack folders, and the level that is open; without one an empty level."""

    packs: Sequence[Path]
    level: Path | None = None
    package: str | None = None


def ground_of(case: str | None, suite: str, level: Path | None) -> ScriptGround:
    """The start level of a case with its packs, a level document with those that it uses, or none with all built."""
    if level is not None:
        package = Level.read(level).package
        return ScriptGround(packs_of(backend(DEFAULT_ENGINE).asset_paths(level)), level, package)
    if case is None:
        return ScriptGround([path.parent for path in sorted(packs_root().glob("*/pack.json"))])
    folder = SuiteFolder(built_suite(suite))
    rows = {row.case_id: row for row in folder.suite().cases}
    if case not in rows:
        raise unknown("case", case, rows, where=suite)
    opened, packs = check_case(folder, rows[case])
    return ScriptGround(packs, folder.agent(rows[case].alias) / "start.level.json", opened.start_map)


def named_pack(name: str) -> Path:
    """A built pack by its id, or any by its folder; ``BadInput`` for no pack."""
    built = [path.parent.name for path in packs_root().glob("*/pack.json")]
    if name in built:
        return packs_root() / name
    if name and (Path(name) / "pack.json").is_file():
        return Path(name)
    raise unknown("pack", name, built, where=str(packs_root()), todo="or give the folder of a pack")


def packs_of(paths: Sequence[str]) -> list[Path]:
    """The built packs that hold one of these assets."""
    wanted = {object_path(path.removesuffix("_C")) for path in paths}
    return [path.parent for path in sorted(packs_root().glob("*/pack.json")) if held_paths(path.parent) & wanted]


def held_paths(pack: Path) -> set[str]:
    """Object paths of what a pack holds."""
    manifest = Pack.read(pack / "pack.json")
    paths = [asset.path for asset in manifest.assets] + [material.path for material in manifest.materials]
    return {object_path(path) for path in paths}
