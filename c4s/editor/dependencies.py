"""What the open level depends on. Runs inside an engine: standard library and ``unreal`` only."""

from __future__ import annotations

from typing import Any

import unreal

SKIPPED = ("/Engine/", "/Script/", "/Temp/", "/Paper2D/")
MAX_DEPTH = 4
CONTENT_ROOT = "/Game/"


def _options() -> Any:
    return unreal.AssetRegistryDependencyOptions(
        include_soft_package_references=True, include_hard_package_references=True
    )


def export_dependencies() -> dict[str, Any]:
    """Walk the references of the saved level, breadth first, as they are on disk.

    Returns ``root`` (the level's package), ``packages`` (all that were reached and resolve, sorted), ``unresolved``
    (named, but in no content; sorted), ``referenced_by`` (each unresolved package to those that name it) and
    ``content_root`` (the mount that packages are named under). A level that was never saved is itself unresolved.
    Engine packages are not walked.
    """
    registry = unreal.AssetRegistryHelpers.get_asset_registry()
    world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
    root = str(world.get_path_name()).split(".", 1)[0]
    options = _options()
    seen, resolved = {root}, set()
    missing: dict[str, set[str]] = {}
    level = [(root, "")]
    for depth in range(MAX_DEPTH + 1):
        following = []
        for package, parent in level:
            found = registry.get_dependencies(package, options)
            if found is None:
                missing.setdefault(package, set()).add(parent)
                continue
            resolved.add(package)
            for name in (str(entry) for entry in found):
                if name in missing:
                    missing[name].add(package)
                if name not in seen and not name.startswith(SKIPPED) and depth < MAX_DEPTH:
                    seen.add(name)
                    following.append((name, package))
        level = following
    return {
        "root": root,
        "packages": sorted(resolved - {root}),
        "unresolved": sorted(missing),
        "referenced_by": {name: sorted(parents) for name, parents in sorted(missing.items())},
        "content_root": CONTENT_ROOT,
    }
