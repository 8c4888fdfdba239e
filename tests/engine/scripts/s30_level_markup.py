import unreal

sub = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)


def add(cls, label, loc, rot=unreal.Rotator(0, 0, 0)):
    actor = sub.spawn_actor_from_class(cls, loc, rot)
    assert actor is not None, label
    actor.set_actor_label(label)
    actor.set_folder_path("Markup")
    return actor


start = add(unreal.PlayerStart, "Start", unreal.Vector(0, 0, 92))
goal = add(unreal.TargetPoint, "Goal", unreal.Vector(2000, 500, 0))
nav = add(unreal.NavMeshBoundsVolume, "Nav", unreal.Vector(1000, 250, 0))
origin, extent = nav.get_actor_bounds(False)
nav.set_actor_scale3d(unreal.Vector(1500 / extent.x, 1000 / extent.y, 500 / extent.z))

sign = add(
    unreal.TextRenderActor, "Sign", unreal.Vector(1000, 0, 150), unreal.Rotator(yaw=180)
)
sign.text_render.set_text("Welcome to C4S")
sign.text_render.set_editor_property("world_size", 60.0)
sign.text_render.set_text_render_color(unreal.Color(r=255, g=200, b=0, a=255))
sign.text_render.set_horizontal_alignment(unreal.HorizTextAligment.EHTA_CENTER)

note = add(unreal.Note, "Note", unreal.Vector(0, 0, 0))
note.set_editor_property("text", "check the gate")
trigger = add(unreal.TriggerVolume, "Trigger", unreal.Vector(2000, 500, 100))
cloud = add(unreal.VolumetricCloud, "Clouds", unreal.Vector())
cloud.volumetric_cloud_component.set_layer_bottom_altitude(4.0)

distance = start.get_distance_to(goal)
flat = start.get_horizontal_distance_to(goal)
print(f"start to goal {distance:.1f} cm, flat {flat:.1f} cm")
assert sub.spawn_actor_from_class(unreal.StaticMeshComponent, unreal.Vector()) is None
assert (
    sub.spawn_actor_from_object(unreal.load_asset("/Game/Nope"), unreal.Vector())
    is None
)
assert not unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(), "C:/Temp/level"
)
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(), "/Game/SavedScenes/s30_level_markup"
)
