import math

import unreal

eas = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
target = unreal.Vector(0, 0, 100)
statue = eas.spawn_actor_from_object(
    unreal.load_asset("/Engine/BasicShapes/Cone"), target
)
statue.set_actor_label("Statue")

cams = []
for k in range(6):
    a = 2 * math.pi * k / 6
    loc = target + unreal.Vector(math.cos(a), math.sin(a), 0.5) * 600.0
    cam = eas.spawn_actor_from_class(
        unreal.CameraActor, loc, unreal.MathLibrary.find_look_at_rotation(loc, target)
    )
    cam.set_actor_label(f"Cam_{k}")
    cc = cam.camera_component
    cc.set_field_of_view(60.0)
    cc.set_editor_property("constrain_aspect_ratio", False)
    pps = cc.post_process_settings
    pps.override_auto_exposure_method = True
    pps.auto_exposure_method = unreal.AutoExposureMethod.AEM_MANUAL
    cc.set_editor_property("post_process_settings", pps)
    cams.append(cam)

for cam in cams:
    forward = cam.get_actor_forward_vector()
    to_target = (target - cam.get_actor_location()).normal()
    assert forward.dot(to_target) > 0.999, cam.get_actor_label()
    assert abs(forward | to_target) <= 1.001
unreal.get_editor_subsystem(
    unreal.UnrealEditorSubsystem
).set_level_viewport_camera_info(
    cams[0].get_actor_location(), cams[0].get_actor_rotation()
)
loc, rot = unreal.get_editor_subsystem(
    unreal.UnrealEditorSubsystem
).get_level_viewport_camera_info()
print(loc, rot)
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(), "/Game/SavedScenes/s18_camera_orbit"
)
