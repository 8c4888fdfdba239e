import unreal

asset_tools = unreal.AssetToolsHelpers.get_asset_tools()
MEL = unreal.MaterialEditingLibrary
EAL = unreal.EditorAssetLibrary
DIR = "/Game/Generated/Materials"

if not EAL.does_directory_exist(DIR):
    EAL.make_directory(DIR)


def make_material(name, rgb, roughness):
    path = f"{DIR}/{name}"
    if EAL.does_asset_exist(path):
        EAL.delete_asset(path)
    mat = asset_tools.create_asset(
        name, DIR, unreal.Material, unreal.MaterialFactoryNew()
    )
    color = MEL.create_material_expression(
        mat, unreal.MaterialExpressionConstant3Vector, -350, 0
    )
    color.set_editor_property(
        "constant", unreal.LinearColor(rgb[0], rgb[1], rgb[2], 1.0)
    )
    rough = MEL.create_material_expression(
        mat, unreal.MaterialExpressionConstant, -350, 200
    )
    rough.set_editor_property("r", roughness)
    MEL.connect_material_property(color, "", unreal.MaterialProperty.MP_BASE_COLOR)
    MEL.connect_material_property(rough, "", unreal.MaterialProperty.MP_ROUGHNESS)
    MEL.recompile_material(mat)
    EAL.save_asset(path)
    return mat


def make_instance(name, parent, color):
    inst = asset_tools.create_asset(
        name,
        DIR,
        unreal.MaterialInstanceConstant,
        unreal.MaterialInstanceConstantFactoryNew(),
    )
    MEL.set_material_instance_parent(inst, parent)
    MEL.set_material_instance_vector_parameter_value(inst, "BaseColor", color)
    MEL.update_material_instance(inst)
    EAL.save_loaded_asset(inst)
    return inst


base = make_material("M_Paint", (0.8, 0.8, 0.8), 0.4)
colors = {
    "Red": unreal.LinearColor(0.7, 0.05, 0.05, 1),
    "Green": unreal.LinearColor(0.05, 0.5, 0.1, 1),
    "Blue": unreal.LinearColor(0.05, 0.1, 0.7, 1),
}
cube = EAL.load_asset("/Engine/BasicShapes/Cube")
eas = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
for i, (name, color) in enumerate(colors.items()):
    mi = make_instance(f"MI_Paint_{name}", base, color)
    a = eas.spawn_actor_from_object(cube, unreal.Vector(i * 200, 0, 50))
    a.set_actor_label(f"Box_{name}")
    a.static_mesh_component.set_material(0, mi)
plain = eas.spawn_actor_from_object(cube, unreal.Vector(-200, 0, 50))
plain.static_mesh_component.set_material(0, base)
print([str(n) for n in MEL.get_vector_parameter_names(base)], EAL.list_assets(DIR))
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(),
    "/Game/SavedScenes/s06_materials_and_instances",
)
unreal.EditorLoadingAndSavingUtils.save_dirty_packages(True, True)
