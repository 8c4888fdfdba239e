import unreal

BASE = "/Game/SavedScenes/s29_base"
FINAL = "/Game/SavedScenes/s29_save_twice_extend"
utils = unreal.EditorLoadingAndSavingUtils
sub = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
les = unreal.get_editor_subsystem(unreal.LevelEditorSubsystem)

world = utils.new_blank_map(False)
for i in range(3):
    a = sub.spawn_actor_from_object(
        unreal.load_asset("/Game/Props/SM_Post"), unreal.Vector(i * 300, 0, 0)
    )
    a.set_actor_label(f"Post_{i}")
assert utils.save_map(world, BASE)

# continue from a copy, keep the base as it is
assert les.new_level_from_template(FINAL, BASE)
current = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
package = str(current.get_path_name()).split(".", 1)[0]
assert package == FINAL, package
posts = [
    a for a in sub.get_all_level_actors() if a.get_actor_label().startswith("Post_")
]
rail = unreal.load_asset("/Game/Props/SM_Fence")
for a, b in zip(posts, posts[1:]):
    mid = unreal.MathLibrary.v_lerp(a.get_actor_location(), b.get_actor_location(), 0.5)
    r = sub.spawn_actor_from_object(rail, mid)
    r.set_actor_label(f"Rail_{a.get_actor_label()[-1]}")
assert utils.save_dirty_packages(True, True)
assert len(utils.get_dirty_map_packages()) == 0

assert les.load_level(BASE)
assert len(sub.get_all_level_actors()) == 3
assert les.load_level(FINAL)
extra = sub.spawn_actor_from_class(unreal.StaticMeshActor, unreal.Vector(0, 500, 0))
extra.set_actor_label("Empty")
extra.static_mesh_component.set_static_mesh(
    unreal.load_asset("/Engine/BasicShapes/Sphere")
)
assert utils.save_current_level()
