"""A small material library: a master material with parameters, instances of it and of each other, saved and assigned."""

import unreal

PKG = "/Game/MaterialLib"
asset_tools = unreal.AssetToolsHelpers.get_asset_tools()
eal = unreal.EditorAssetLibrary
mel = unreal.MaterialEditingLibrary
actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
assets = unreal.get_editor_subsystem(unreal.EditorAssetSubsystem)
registry = unreal.AssetRegistryHelpers.get_asset_registry()

if not eal.does_directory_exist(PKG):
    assert eal.make_directory(PKG)


def create(name, cls, factory, folder=PKG):
    path = f"{folder}/{name}"
    if eal.does_asset_exist(path):
        eal.delete_asset(path)
    made = asset_tools.create_asset(
        asset_name=name, package_path=folder, asset_class=cls, factory=factory
    )
    if made is None:
        raise RuntimeError("could not create " + path)
    return made


master = create("M_Master", unreal.Material, unreal.MaterialFactoryNew())
color = mel.create_material_expression(
    master, unreal.MaterialExpressionVectorParameter, -400, 0
)
color.set_editor_property("parameter_name", "BaseColor")
color.set_editor_property("default_value", unreal.LinearColor(0.5, 0.5, 0.5, 1.0))
grime = mel.create_material_expression(
    master, unreal.MaterialExpressionConstant, -400, -120
)
grime.set_editor_property("r", 0.9)
dirty = mel.create_material_expression(
    master, unreal.MaterialExpressionMultiply, -200, 0
)
assert mel.connect_material_expressions(
    color, "", dirty, "A"
) and mel.connect_material_expressions(grime, "", dirty, "B")
mel.connect_material_property(dirty, "", unreal.MaterialProperty.MP_BASE_COLOR)
for i, (name, prop, value) in enumerate(
    [
        ("Roughness", unreal.MaterialProperty.MP_ROUGHNESS, 0.6),
        ("Metallic", unreal.MaterialProperty.MP_METALLIC, 0.0),
    ]
):
    node = mel.create_material_expression(
        master, unreal.MaterialExpressionScalarParameter, -400, 200 + 150 * i
    )
    node.set_editor_property("parameter_name", unreal.Name(name))
    node.set_editor_property("default_value", value)
    if not mel.connect_material_property(node, "", prop):
        unreal.log_warning(f"{name} is not connected")
glow = mel.create_material_expression(
    master, unreal.MaterialExpressionVectorParameter, -700, 600
)
glow.set_editor_property("parameter_name", "EmissiveColor")
glow.set_editor_property("default_value", unreal.LinearColor(0, 0, 0, 1))
mel.connect_material_property(glow, "RGB", unreal.MaterialProperty.MP_EMISSIVE_COLOR)
mel.layout_material_expressions(master)
mel.recompile_material(master)
assert eal.save_loaded_asset(master, False)


def instance(name, parent, vectors=None, scalars=None):
    mi = create(
        name,
        unreal.MaterialInstanceConstant,
        unreal.MaterialInstanceConstantFactoryNew(),
    )
    mel.set_material_instance_parent(mi, parent)
    for key, value in (vectors or {}).items():
        mel.set_material_instance_vector_parameter_value(mi, key, value)
    for key, value in (scalars or {}).items():
        mel.set_material_instance_scalar_parameter_value(mi, key, value)
    mel.update_material_instance(mi)
    assets.save_loaded_asset(mi)
    return mi


LIBRARY = {
    "MI_Brick": (
        {"BaseColor": unreal.LinearColor(0.35, 0.1, 0.06)},
        {"Roughness": 0.9},
    ),
    "MI_Steel": (
        {"BaseColor": unreal.LinearColor(0.55, 0.56, 0.58)},
        {"Roughness": 0.3, "Metallic": 1.0},
    ),
    "MI_Neon": (
        {
            "BaseColor": unreal.LinearColor(0, 0, 0),
            "EmissiveColor": unreal.LinearColor(0, 6, 9),
        },
        {},
    ),
}
made = {name: instance(name, master, *params) for name, params in LIBRARY.items()}
worn = instance("MI_Brick_Worn", made["MI_Brick"], scalars={"Roughness": 0.98})
assert worn.get_editor_property("parent") == made["MI_Brick"]
assert worn.get_base_material() == master
v = mel.get_material_instance_vector_parameter_value(worn, "BaseColor")
assert abs(v.r - 0.35) < 1e-4, v  # inherited from the parent instance
print(
    "scalars:",
    [str(n) for n in mel.get_scalar_parameter_names(master)],
    "vectors:",
    [str(n) for n in mel.get_vector_parameter_names(master)],
)

listed = eal.list_assets(PKG, recursive=False, include_folder=False)
print("\n".join(str(p) for p in listed))
assert len(listed) == 5
found = registry.get_assets(
    unreal.ARFilter(
        class_paths=[
            unreal.TopLevelAssetPath("/Script/Engine", "MaterialInstanceConstant")
        ],
        package_paths=[PKG],
        recursive_paths=True,
    )
)
assert sorted(str(d.asset_name) for d in found) == [
    "MI_Brick",
    "MI_Brick_Worn",
    "MI_Neon",
    "MI_Steel",
]
data = eal.find_asset_data(f"{PKG}/MI_Steel")
assert data.is_valid() and str(data.package_name) == f"{PKG}/MI_Steel"
assert isinstance(data.get_asset(), unreal.MaterialInstanceConstant)

eal.set_metadata_tag(worn, "author", "agent")
assert eal.get_metadata_tag(worn, "author") == "agent"
assert eal.rename_asset(f"{PKG}/MI_Brick_Worn", f"{PKG}/Worn/MI_BrickWorn")
worn = eal.load_asset(f"{PKG}/Worn/MI_BrickWorn")
blue = eal.duplicate_asset(f"{PKG}/MI_Brick", f"{PKG}/MI_BrickBlue")
mel.set_material_instance_vector_parameter_value(
    blue, "BaseColor", unreal.LinearColor(0.05, 0.1, 0.4, 1)
)
assert eal.save_directory(PKG, only_if_is_dirty=False, recursive=True)

wanted = [
    ("Wall_Brick", made["MI_Brick"]),
    ("Wall_Worn", worn),
    ("Beam_Steel", made["MI_Steel"]),
    ("Sign_Neon", made["MI_Neon"]),
    ("Wall_Blue", blue),
]
for i, (label, material) in enumerate(wanted):
    cube = actors.spawn_actor_from_class(
        unreal.StaticMeshActor, unreal.Vector(0, 250.0 * i, 50)
    )
    cube.set_actor_label(label)
    smc = cube.static_mesh_component
    smc.set_static_mesh(unreal.load_asset("/Engine/BasicShapes/Cube"))
    smc.set_material(0, material)
    assert smc.get_material(0) == material and smc.get_num_materials() == 1
    assert (
        cube.get_component_by_class(unreal.MeshComponent).get_materials()[0] == material
    )

unreal.EditorLoadingAndSavingUtils.save_dirty_packages(True, True)
left = unreal.EditorLoadingAndSavingUtils.get_dirty_content_packages()
print("still dirty:", [p.get_name() for p in left])
world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
unreal.EditorLoadingAndSavingUtils.save_map(
    world, "/Game/SavedScenes/s35_material_library"
)
