"""What published image tasks need and do not bring: content packs, levels, assets; and content given in their place.

A task's recipe names meshes, Blueprint classes and materials; its scene names the levels, a few assets by which a pack
is known, and what has to be made. The levels are not published: without the original level nothing tells where the
other actors stand, so a task with all its assets still does not run.
"""

from __future__ import annotations

import csv
import shutil
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c4s.errors import BadInput
from c4s.files import read_json, read_yaml
from c4s.names import file_in, package_fault, place_in
from c4s.packs.check import check_pack
from c4s.records.pack import MANIFEST, Asset, Material, Pack
from cases.code4scene.tasks import Task
from cases.recipe import Recipe, SetStaticMesh, SpawnActor
from catalog.ingest.writer import identifier

COLUMNS = ("published", "pack", "asset")
LISTING = "packs.yaml"
"""The benchmark's list of content packs: beside the tasks or in a folder above."""
MOST_ROWS = 100_000


@dataclass(frozen=True)
class TaskNeeds:
    """What an image task needs: content folders, level packages, and asset paths."""

    case_id: str
    packs: tuple[str, ...]
    levels: tuple[str, ...]
    assets: tuple[str, ...]


def needs_of(task: Task) -> TaskNeeds:
    """The needs of an image task, by its recipe and its scene where these lie beside it.

    ``BadInput`` names the file and field where one of these is wrong.
    """
    levels, assets = {task.start_map}, set[str]()
    file = task.folder / "recipe.json"
    if file.is_file():
        recipe = Recipe.read(file)
        if recipe.case_id != task.case_id:
            raise BadInput(f"this recipe is of the case {recipe.case_id!r}, not {task.case_id!r}", where=str(file))
        levels |= {recipe.source_map, recipe.ground_truth_map, recipe.input_map}
        levels |= {path for change in recipe.level_structure for path in (change.source, change.target)}
        assets |= _assets_of(recipe)
        if recipe.scene_spec is not None:
            scene = (task.folder / recipe.scene_spec).resolve()
            assets |= _scene_assets(scene) - levels if scene.is_file() and scene.name == "scene.json" else set()
    packs = tuple(pack for pack in task.packs if not task.start_map.startswith(f"/Game/{pack}/"))
    return TaskNeeds(task.case_id, packs, tuple(sorted(levels)), tuple(sorted(assets)))


def _assets_of(recipe: Recipe) -> set[str]:
    found: set[str] = set()
    for operation in recipe.operations:
        if isinstance(operation, SpawnActor):
            found |= set(operation.source.values())
        elif isinstance(operation, SetStaticMesh):
            found |= {operation.static_mesh, operation.replaces}
        expect = getattr(operation, "expect", None)
        if expect is not None:
            found |= {slot.material_path for slot in expect.material_slots or () if not slot.is_dynamic}
            found |= set(expect.component_asset_paths or ())
    return found


def _scene_assets(file: Path) -> set[str]:
    """The assets that a scene's description names by which its packs are known."""
    named = read_json(file, what="scene").get("key_assets", [])
    if not isinstance(named, list) or not all(isinstance(path, str) for path in named):
        raise BadInput("malformed scene.json: field 'key_assets' is no list of paths", where=str(file))
    for number, path in enumerate(named):
        if fault := package_fault(path):
            raise BadInput(f"malformed scene.json: field 'key_assets.{number}': {fault}", where=str(file))
    return {path for path in named if "." in path}


def listings(folder: Path) -> dict[str, dict[str, Any]]:
    """What the benchmark's list says of packs by content folder; empty where it does not lie in or above ``folder``."""
    found = next((at / LISTING for at in (folder, *folder.resolve().parents[:2]) if (at / LISTING).is_file()), None)
    raw = read_yaml(found, what="list of packs") if found else {}
    packs = raw.get("packs") if isinstance(raw, Mapping) else None
    rows = [row for row in packs if isinstance(row, Mapping)] if isinstance(packs, list) else []
    return {
        str(row["folder"]): {"title": row.get("title"), "seller": row.get("seller"), "url": row.get("fab_url")}
        for row in rows
        if "folder" in row
    }


@dataclass(frozen=True)
class Given:
    """Content given for published paths: the asset of a pack that stands in for each."""

    packs: dict[str, Pack]
    """By id."""
    assets: dict[str, tuple[str, Asset]]
    """Published path -> pack id and asset."""


def read_table(file: Path, packs_root: Path) -> Given:
    """A table of content: CSV with the columns ``published``, ``pack``, ``asset`` (an asset's path or id).

    ``BadInput`` with the line for an unknown or missing column, a value that is no path, a pack that is not built, an
    asset that its pack does not hold, a Blueprint for a mesh or the other way round, and a path that comes twice.
    """
    try:
        with file.open(newline="", encoding="utf-8-sig") as text:
            rows = list(csv.reader(text, strict=True))
    except (UnicodeDecodeError, csv.Error) as error:
        raise BadInput(f"this is no CSV table: {error}", where=str(file)) from None
    if not rows or len(rows) > MOST_ROWS:
        raise BadInput(f"a table has 1 to {MOST_ROWS:,} lines", where=str(file))
    head = [name.strip() for name in rows[0]]
    if sorted(head) != sorted(COLUMNS):
        wrong = [name for name in head if name not in COLUMNS]
        told = f"unknown column {wrong[0]!r}" if wrong else "each column once"
        raise BadInput(told, where=f"{file} line 1", todo=f"the columns are {', '.join(COLUMNS)}")
    given = Given({}, {})
    for number, values in enumerate(rows[1:], 2):
        if not any(value.strip() for value in values):
            continue
        where = f"{file} line {number}"
        if len(values) != len(head):
            raise BadInput(f"{len(values)} values for {len(head)} columns", where=where)
        row = dict(zip(head, (value.strip() for value in values), strict=True))
        try:
            _take(given, row["published"], row["pack"], row["asset"], packs_root)
        except BadInput as error:
            raise BadInput(error.what, where=where, todo=error.todo) from None
    return given


def _take(given: Given, published: str, pack_id: str, named: str, packs_root: Path) -> None:
    if not published.startswith("/Game/") or package_fault(published) or "." not in published:
        raise BadInput(f"{published!r} is no path of an asset, such as /Game/Pack/SM_A.SM_A")
    if published in given.assets:
        raise BadInput(f"{published} comes twice")
    if pack_id not in given.packs:
        folder = place_in(packs_root, pack_id, "pack")
        if not (folder / MANIFEST).is_file():
            raise BadInput(f"no pack {pack_id!r} is built", todo="make it with `c4s catalog build`")
        check_pack(folder)
        given.packs[pack_id] = Pack.read(folder / MANIFEST)
    known = {name: asset for asset in given.packs[pack_id].assets for name in (asset.path, asset.spawn_path, asset.id)}
    if named not in known:
        raise BadInput(f"the pack {pack_id!r} has no asset {named!r}", todo=f"see `c4s catalog show {pack_id}`")
    asset = known[named]
    if published.endswith("_C") != (asset.kind == "blueprint"):
        raise BadInput(f"{published} and {asset.path} are not of one kind: a Blueprint class ends in _C")
    given.assets[published] = (pack_id, asset)


def content_pack(given: Given, wanted: Sequence[str], packs_root: Path, root: Path, pack_id: str) -> Pack | None:
    """Write ``root/<pack_id>``: the given meshes that are wanted, under their published paths.

    None where there are none. With it the packages of a level made with the published content resolve. Blueprints are
    not remade.
    """
    chosen = {path: given.assets[path] for path in wanted if path in given.assets and not path.endswith("_C")}
    if not chosen:
        return None
    folder = root / pack_id
    materials: dict[str, Material] = {}
    assets: list[Asset] = []
    files: dict[str, str] = {}

    def taken(origin: str, name: str | None) -> str | None:
        if name is None:
            return None
        here = f"{origin}/{name}"
        if here not in files:
            (folder / here).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file_in(packs_root / origin, name), folder / here)
            files[here] = given.packs[origin].files[name]
        return here

    for number, (path, (origin, asset)) in enumerate(chosen.items()):
        used = {slot.material for slot in asset.slots}
        for material in given.packs[origin].materials:
            if material.path in used and material.path not in materials:
                pictures = ("texture", "normal_texture", "roughness_metal_texture", "emissive_texture")
                moved = {name: taken(origin, getattr(material, name)) for name in pictures}
                materials[material.path] = material.model_copy(update=moved)
        copied = {"mesh": taken(origin, asset.mesh), "preview": taken(origin, asset.preview)}
        assets.append(asset.model_copy(update={**copied, "path": path, "id": f"{asset.id}_{number}"}))
    licences = sorted({given.packs[origin].license for origin, _ in chosen.values()})
    pack = Pack(
        pack_id=pack_id,
        content_folder=identifier(pack_id),
        title="Content given for published tasks",
        license=licences[0] if len(licences) == 1 else " AND ".join(licences),
        description=f"Assets of {', '.join(sorted({origin for origin, _ in chosen.values()}))} under published paths",
        assets=assets,
        materials=list(materials.values()),
        files=dict(sorted(files.items())),
    )
    pack.write(folder / MANIFEST)
    return pack


def told(needs: Sequence[TaskNeeds], given: Given | None, known: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    """The needs of all tasks together: each pack, level and asset with how many tasks need it, and what is given."""
    packs = Counter(pack for one in needs for pack in one.packs)
    levels = Counter(level for one in needs for level in one.levels)
    assets = Counter(asset for one in needs for asset in one.assets)
    mapped = given.assets if given else {}
    return {
        "packs": [{"folder": name, "tasks": count, **known.get(name, {})} for name, count in sorted(packs.items())],
        "levels": dict(sorted(levels.items())),
        "levels_note": "the levels are not published: export them from the packs by the benchmark's own builder",
        "assets": dict(sorted(assets.items())),
        "given": {path: f"{mapped[path][0]}:{mapped[path][1].id}" for path in sorted(assets) if path in mapped},
        "not_given": {path: count for path, count in sorted(assets.items()) if path not in mapped},
        "not_needed": sorted(set(mapped) - set(assets)),
    }
