import unreal

eas = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
bench = unreal.load_asset("/Game/Props/SM_Bench")
originals = []
for i in range(4):
    b = eas.spawn_actor_from_object(
        bench, unreal.Vector(300 + 200 * i, 100 * i, 0), unreal.Rotator(0, 0, 15 * i)
    )
    b.set_actor_label(f"Bench_R{i}")
    originals.append(b)

copies = eas.duplicate_actors(originals)
for src, dst in zip(originals, copies):
    loc = src.get_actor_location()
    rot = src.get_actor_rotation()
    dst.set_actor_location(unreal.Vector(-loc.x, loc.y, loc.z), False, True)
    dst.set_actor_rotation(unreal.Rotator(rot.roll, rot.pitch, 180 - rot.yaw), True)
    s = dst.get_actor_scale3d()
    dst.set_actor_scale3d(unreal.Vector(s.x, -s.y, s.z))
    dst.set_actor_label(src.get_actor_label().replace("_R", "_L"))

sel = [a for a in copies]
eas.set_selected_level_actors(sel)
print(len(eas.get_selected_level_actors()), "selected")
for a in eas.get_selected_level_actors():
    a.set_actor_hidden_in_game(False)
    assert a.get_actor_scale3d().y < 0
eas.select_nothing() if hasattr(
    eas, "select_nothing"
) else eas.clear_actor_selection_set()
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(), "/Game/SavedScenes/s20_mirror_copies"
)
