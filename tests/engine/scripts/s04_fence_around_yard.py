import math

import unreal

# A fence along a closed rounded path, one panel every ~200 cm, aligned with the path
PANEL = 200.0
mesh = unreal.load_object(None, "/Game/Props/SM_Fence.SM_Fence")
eas = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)


def path_point(t, rx=1500.0, ry=1000.0):
    return unreal.Vector(rx * math.cos(t), ry * math.sin(t), 0.0)


points = [path_point(2 * math.pi * k / 400) for k in range(401)]
travelled, panels, last = 0.0, [], points[0]
for a, b in zip(points, points[1:]):
    travelled += a.distance(b)
    if travelled >= PANEL:
        mid = (last + b) / 2.0
        direction = (b - last).normal()
        panels.append((mid, direction.rotator().yaw))
        last, travelled = b, 0.0

with unreal.ScopedSlowTask(len(panels), "Building fence") as task:
    task.make_dialog(True)
    for index, (where, yaw) in enumerate(panels):
        if task.should_cancel():
            break
        task.enter_progress_frame(1, f"panel {index}")
        actor = eas.spawn_actor_from_object(mesh, where, unreal.Rotator(0, 0, yaw))
        actor.set_actor_label("Fence_%03d" % index)
        actor.set_folder_path("/Yard/Fence")
        actor.tags = [unreal.Name("fence"), unreal.Name(f"panel_{index}")]

les = unreal.get_editor_subsystem(unreal.LevelEditorSubsystem)
w = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
ok = unreal.EditorLoadingAndSavingUtils.save_map(
    w, "/Game/SavedScenes/s04_fence_around_yard"
)
unreal.log(f"fence panels: {len(panels)}, saved: {ok}")
