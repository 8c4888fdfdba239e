import unreal

CUBE = "/Engine/BasicShapes/Cube.Cube"
LEVEL = "/Game/SavedScenes/s19_room_with_walls"
T = 20  # wall thickness in cm


def box(sub, label, x0, y0, z0, x1, y1, z1, folder):
    """A cube scaled to the given corners."""
    mesh = unreal.load_asset(CUBE)
    center = unreal.Vector((x0 + x1) / 2.0, (y0 + y1) / 2.0, (z0 + z1) / 2.0)
    actor = sub.spawn_actor_from_object(mesh, center, unreal.Rotator())
    actor.set_actor_scale3d(
        unreal.Vector((x1 - x0) / 100.0, (y1 - y0) / 100.0, (z1 - z0) / 100.0)
    )
    actor.set_actor_label(label)
    actor.set_folder_path(unreal.Name(folder))
    return actor


def main():
    levels = unreal.get_editor_subsystem(unreal.LevelEditorSubsystem)
    sub = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    if unreal.EditorAssetLibrary.does_asset_exist(LEVEL):
        levels.load_level(LEVEL)
    else:
        levels.new_level(LEVEL)
    w, d, h = 800, 600, 300
    box(sub, "Floor", 0, 0, -T, w, d, 0, "Room")
    box(sub, "Ceiling", 0, 0, h, w, d, h + T, "Room")
    box(sub, "Wall_N", 0, d, 0, w, d + T, h, "Room/Walls")
    box(sub, "Wall_W", -T, 0, 0, 0, d, h, "Room/Walls")
    box(sub, "Wall_E", w, 0, 0, w + T, d, h, "Room/Walls")
    # south wall with a door 100 wide, 210 high
    box(sub, "Wall_S_Left", 0, -T, 0, 350, 0, h, "Room/Walls")
    box(sub, "Wall_S_Right", 450, -T, 0, w, 0, h, "Room/Walls")
    box(sub, "Wall_S_Lintel", 350, -T, 210, 450, 0, h, "Room/Walls")
    light = sub.spawn_actor_from_class(
        unreal.RectLight, unreal.Vector(w / 2, d / 2, h - 10), unreal.Rotator(pitch=-90)
    )
    light.set_actor_label("CeilingLight")
    light.rect_light_component.set_source_width(200)
    light.rect_light_component.set_intensity(60)
    dirty = unreal.EditorLoadingAndSavingUtils.get_dirty_map_packages()
    print("dirty maps:", [p.get_name() for p in dirty])
    saved = levels.save_all_dirty_levels()
    print("SAVED" if saved else "NOT SAVED")


main()
