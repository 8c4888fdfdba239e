"""Every package that a shipped level names has a file, as a dependency walk by ``PackageTools`` finds it."""

from __future__ import annotations

from pathlib import Path

import pytest

from c4s.engine.headless.process.boot import boot
from cases.starter.indoor_cases import scenes

SKIPPED = ("/Engine/", "/Script/")


@pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.scene_id)
def test_a_walk_over_the_references_of_a_shipped_level_ends_at_files(indoor_packs, tmp_path, scene):
    level, packs = scene.level, [indoor_packs / name for name in scene.packs]
    level.write(tmp_path / "start.level.json")
    unreal = boot(packs, tmp_path / "content", levels=[tmp_path / "start.level.json"], start_map=level.package)
    registry = unreal.AssetRegistryHelpers.get_asset_registry()
    options = unreal.AssetRegistryDependencyOptions(include_hard_package_references=True)
    seen, waiting = set(), [level.package]
    while waiting:
        package = waiting.pop()
        seen.add(package)
        names = [str(name) for name in registry.get_dependencies(package, options) or []]
        waiting += [name for name in dict.fromkeys(names) if name not in seen and not name.startswith(SKIPPED)]
    assert len(seen) > 80
    files = unreal.PackageTools.package_name_to_filename
    lost = [p for p in seen if not any(Path(files(p, kind)).is_file() for kind in (".umap", ".uasset"))]
    assert lost == []
