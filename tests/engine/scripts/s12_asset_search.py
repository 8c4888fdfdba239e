import json

import unreal

registry = unreal.AssetRegistryHelpers.get_asset_registry()
registry.wait_for_completion()


def find_meshes(folder="/Game"):
    try:
        flt = unreal.ARFilter(
            class_paths=[unreal.TopLevelAssetPath("/Script/Engine", "StaticMesh")],
            package_paths=[folder],
            recursive_paths=True,
        )
    except Exception:  # very old engines
        flt = unreal.ARFilter(
            class_names=["StaticMesh"], package_paths=[folder], recursive_paths=True
        )
    return [
        {
            "name": str(d.asset_name),
            "package": str(d.package_name),
            "class": str(d.asset_class_path.asset_name),
        }
        for d in registry.get_assets(flt)
    ]


meshes = find_meshes()
print(json.dumps(meshes, indent=1))
listed = unreal.EditorAssetLibrary.list_assets(
    "/Game/Props", recursive=True, include_folder=False
)
assert all(isinstance(p, str) for p in listed)

x = 0.0
eas = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
for row in sorted(meshes, key=lambda m: m["name"]):
    mesh = unreal.EditorAssetLibrary.find_asset_data(row["package"]).get_asset()
    box = mesh.get_bounding_box()
    size = box.max - box.min
    actor = eas.spawn_actor_from_object(
        mesh, unreal.Vector(x + size.x / 2, 0, -box.min.z)
    )
    actor.set_actor_label(row["name"].replace("SM_", "Sample_"))
    x += size.x + 100
unreal.EditorLoadingAndSavingUtils.save_map(
    eas.get_world() or unreal.EditorLevelLibrary.get_editor_world(),
    "/Game/SavedScenes/s12_asset_search",
)
