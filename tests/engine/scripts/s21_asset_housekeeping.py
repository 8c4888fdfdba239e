import unreal

EAS = unreal.get_editor_subsystem(unreal.EditorAssetSubsystem)
EAL = unreal.EditorAssetLibrary
SRC, DST = "/Game/Props/M_Wood", "/Game/Variants"

EAS.make_directory(DST)
dark = EAS.duplicate_asset(SRC, f"{DST}/M_WoodDark_Tmp")
EAS.duplicate_asset("/Game/Props/SM_Bench", f"{DST}/SM_BenchDark")
assert dark is not None and EAS.does_asset_exist(f"{DST}/M_WoodDark_Tmp")
assert EAS.rename_asset(f"{DST}/M_WoodDark_Tmp", f"{DST}/M_WoodDark")
assert not EAS.does_asset_exist(f"{DST}/M_WoodDark_Tmp")
assert dark.get_path_name() == f"{DST}/M_WoodDark.M_WoodDark"

tools = unreal.AssetToolsHelpers.get_asset_tools()
twins = [
    tools.create_asset(
        f"MI_{n}",
        DST,
        unreal.MaterialInstanceConstant,
        unreal.MaterialInstanceConstantFactoryNew(),
    )
    for n in ("Keep", "Drop")
]
for mi in twins:
    mi.set_editor_property("parent", dark)
    unreal.MaterialEditingLibrary.set_material_instance_vector_parameter_value(
        mi, "BaseColor", unreal.LinearColor(0.05, 0.03, 0.02, 1)
    )

sub = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
bench_mesh = EAL.load_asset(f"{DST}/SM_BenchDark")
bench_mesh.set_material(0, dark)
for i, mi in enumerate(twins):
    a = sub.spawn_actor_from_object(bench_mesh, unreal.Vector(0, i * 200, 0))
    a.set_actor_label(f"Bench_{i}")
    a.static_mesh_component.set_material(0, mi)
plain = sub.spawn_actor_from_object(bench_mesh, unreal.Vector(0, 600, 0))
plain.set_actor_label("Bench_Plain")

print("consolidated:", EAS.consolidate_assets(twins[0], [twins[1]]))
print(
    "cannot rename pack:", EAL.rename_asset("/Game/Props/M_Stone", "/Game/Props/M_Rock")
)
EAS.set_metadata_tag(bench_mesh, "Author", "agent")
print(EAL.get_metadata_tag(bench_mesh, "Author"), list(EAL.list_assets(DST)))
EAS.save_directory(DST)
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(),
    "/Game/SavedScenes/s21_asset_housekeeping",
)
