"""The packs' Unreal content: which files a project needs for what a case offers, and what is known of the meshes."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from c4s.engine.unreal.host.installation import Installation
from c4s.errors import BadInput
from c4s.packs import basic_shapes
from c4s.protocol.content import Offered
from c4s.records.pack import Asset, Pack
from c4s.records.unreal_content import CONTENT_FILE, CONTENT_FOLDER, UnrealContent


def content_files(pack: Path, offered: Sequence[str] | None, editor: Installation) -> dict[Path, Path]:
    """Files of a pack's Unreal content by their place below a project's ``Content``.

    Only what the offered assets and the materials need is there; all of it where nothing is said.
    ``BadInput`` for a pack without Unreal content, or with that of another engine.
    """
    manifest = Pack.read(pack / "pack.json")
    if not (pack / CONTENT_FILE).is_file():
        raise BadInput(
            "this pack has no Unreal content, so a real editor has nothing to show of it",
            where=str(pack),
            todo="docs/unreal.md says how content is added, or use the engine headless",
        )
    content = UnrealContent.read(pack / CONTENT_FILE)
    if content.engine != editor.api:
        raise BadInput(
            f"the pack's content was saved by engine {content.engine}, and this editor is {editor.version}",
            where=str(pack / CONTENT_FILE),
            todo="use an editor of that version, or save the content again with this one",
        )
    assets = {asset.path: asset for asset in manifest.assets}
    there = None if offered is None else Offered(offered)
    if there is not None:
        there.take_parts({path: [part.asset for part in asset.parts] for path, asset in assets.items()})
    missing = sorted({*assets, *(material.path for material in manifest.materials)} - content.needs.keys())
    if missing:
        raise BadInput(f"{len(missing)} assets have no Unreal content, {missing[0]} first", where=str(pack))
    found: dict[Path, Path] = {}
    for path, names in content.needs.items():
        if there is None or path not in assets or path in there:
            found |= {Path(name): pack / CONTENT_FOLDER / name for name in names}
    for place, file in found.items():
        name = (CONTENT_FOLDER / place).as_posix()
        if name not in manifest.files or not file.is_file():
            raise BadInput(f"{name} is not among the pack's files", where=str(pack))
    return found


def mesh_facts(packs: Sequence[Path]) -> dict[str, Any]:
    """What a snapshot keeps of each mesh by path, as the manifests say it: a real editor shows no hulls to Python."""
    assets: list[Asset] = list(basic_shapes.assets().values())
    for pack in packs:
        assets += Pack.read(pack / "pack.json").assets
    return {
        asset.path: {
            "sha256": asset.mesh_sha256,
            "bounds_min_cm": list(asset.bounds_min_cm),
            "bounds_max_cm": list(asset.bounds_max_cm),
            "collision": [body.model_dump(mode="json") for body in asset.collision],
        }
        for asset in assets
        if asset.kind == "static_mesh"
    }
