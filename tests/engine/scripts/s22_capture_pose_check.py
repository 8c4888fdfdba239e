import unreal

# Place a capture actor the way a reference view is made, then take it away before saving.
sub = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
cube = sub.spawn_actor_from_object(
    unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector(0, 0, 50)
)
cube.set_actor_label("Subject")

rt = unreal.RenderingLibrary.create_render_target2d(
    world, 64, 48, unreal.TextureRenderTargetFormat.RTF_RGBA8
)
assert rt.get_editor_property("size_x") == 64
origin, extent = cube.get_actor_bounds(False)
distance = extent.length() * 3.0
eye = origin + unreal.Vector(-distance, -distance * 0.4, distance * 0.5)
cap = sub.spawn_actor_from_class(
    unreal.SceneCapture2D, eye, unreal.MathLibrary.find_look_at_rotation(eye, origin)
)
cap.set_actor_label("__capture__")
c2d = cap.capture_component2d
c2d.capture_every_frame = False
c2d.capture_on_movement = False
c2d.set_editor_property("capture_source", unreal.SceneCaptureSource.SCS_FINAL_COLOR_LDR)
c2d.set_editor_property("fov_angle", 60.0)
c2d.texture_target = rt
local = cap.get_actor_transform().inverse_transform_location(origin)
print(
    "subject straight ahead:",
    abs(local.y) < 0.01 and abs(local.z) < 0.01 and local.x > 0,
)
assert abs(local.y) < 0.01 and abs(local.z) < 0.01
unreal.RenderingLibrary.release_render_target2d(rt)
cap.destroy_actor()
unreal.EditorLoadingAndSavingUtils.save_map(
    world, "/Game/SavedScenes/s22_capture_pose_check"
)
