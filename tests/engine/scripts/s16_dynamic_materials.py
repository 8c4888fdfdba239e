import unreal

sphere = unreal.load_asset("/Engine/BasicShapes/Sphere")
wood = unreal.load_asset("/Game/Props/M_Wood")
eas = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)

palette = [
    unreal.LinearColor(1, 0, 0, 1),
    unreal.LinearColor(0, 1, 0, 1),
    unreal.LinearColor(0, 0, 1, 1),
]
blended = [palette[0].lerp_to(palette[1], a / 4.0) for a in range(5)]
for i, color in enumerate(blended):
    ball = eas.spawn_actor_from_object(sphere, unreal.Vector(i * 120.0, 0, 50))
    ball.set_actor_label("Ball_%d" % i)
    comp = ball.static_mesh_component
    mid = comp.create_dynamic_material_instance(0, wood)
    if mid is None:
        raise RuntimeError("no MID")
    mid.set_vector_parameter_value("BaseColor", color)
    mid.set_scalar_parameter_value("Roughness", 0.1 * i)
    got = mid.get_vector_parameter_value("BaseColor")
    assert got.is_near_equal(color, 0.01), (got, color)

hsv = unreal.LinearColor(0.2, 0.4, 0.6, 1.0).rgb_to_hsv()
unreal.log(f"hue {hsv.r:.1f} saturation {hsv.g:.2f} value {hsv.b:.2f}")
shared = unreal.MaterialLibrary.create_dynamic_material_instance(
    unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world(), wood
)
shared.set_scalar_parameter_value("Metallic", 1.0)
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(),
    "/Game/SavedScenes/s16_dynamic_materials",
)
