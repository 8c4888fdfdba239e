import unreal

PREFIX = "GEN_"
eas = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
cube = unreal.load_asset("/Engine/BasicShapes/Cube")


def cleanup():
    victims = [
        a for a in eas.get_all_level_actors() if a.get_actor_label().startswith(PREFIX)
    ]
    ok = eas.destroy_actors(victims) if victims else True
    return len(victims), ok


def build(n, step):
    for i in range(n):
        a = eas.spawn_actor_from_object(cube, unreal.Vector(0, i * step, 50))
        a.set_actor_label(f"{PREFIX}Block_{i}")


build(12, 150)
removed, ok = cleanup()
print("removed", removed, ok)
build(5, 300)
stale = eas.get_all_level_actors()[0]
eas.destroy_actor(stale)
try:
    stale.get_actor_label()
except Exception as exc:
    print("stale reference:", exc)
copy = eas.duplicate_actor(
    eas.get_all_level_actors()[0], None, unreal.Vector(500, 0, 0)
)
copy.set_actor_label(PREFIX + "Copy")
keeper = eas.spawn_actor_from_object(
    unreal.load_asset("/Engine/BasicShapes/Sphere"), unreal.Vector(0, -500, 50)
)
keeper.set_actor_label("Keeper")
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(),
    "/Game/SavedScenes/s13_delete_and_rebuild",
)
