import math

import unreal

STEPS = 36
RADIUS = 300.0
RISE = 25.0
cube = unreal.EditorAssetLibrary.load_asset("/Engine/BasicShapes/Cube.Cube")
cyl = unreal.EditorAssetLibrary.load_asset("/Engine/BasicShapes/Cylinder.Cylinder")

with unreal.ScopedEditorTransaction("Build spiral tower") as trans:
    core = unreal.EditorLevelLibrary.spawn_actor_from_object(
        cyl, unreal.Vector(0, 0, STEPS * RISE / 2)
    )
    core.set_actor_label("Tower_Core")
    core.set_actor_scale3d(unreal.Vector(2, 2, STEPS * RISE / 100))
    for i in range(STEPS):
        angle = math.radians(i * 20.0)
        loc = unreal.Vector(
            RADIUS * math.cos(angle), RADIUS * math.sin(angle), i * RISE + RISE / 2
        )
        rot = unreal.MathLibrary.make_rot_from_x(unreal.Vector(loc.x, loc.y, 0))
        step = unreal.EditorLevelLibrary.spawn_actor_from_object(cube, loc, rot)
        step.set_actor_scale3d(unreal.Vector(2.0, 0.8, RISE / 100.0))
        step.set_actor_label(f"Step_{i:02d}")
        step.set_folder_path("Tower/Steps")

    top = unreal.EditorLevelLibrary.spawn_actor_from_class(
        unreal.PointLight, unreal.Vector(0, 0, STEPS * RISE + 150)
    )
    top.set_actor_label("Tower_Beacon")
    top.set_brightness(8000.0)

idx = unreal.SystemLibrary.begin_transaction("c4s", "second edit", core)
core.set_actor_scale3d(unreal.Vector(2.5, 2.5, core.get_actor_scale3d().z))
unreal.SystemLibrary.end_transaction()
unreal.SystemLibrary.execute_console_command(None, "r.ScreenPercentage 100")
if not unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(), "/Game/SavedScenes/s14_spiral_tower"
):
    unreal.log_error("save failed")
