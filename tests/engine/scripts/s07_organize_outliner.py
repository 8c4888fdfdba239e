from collections import defaultdict

import unreal

unreal.get_editor_subsystem(unreal.LevelEditorSubsystem).load_level("/Game/Maps/Start")
sub = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)

RULES = [
    ("SM_Tree", "Nature/Trees"),
    ("SM_Rock", "Nature/Rocks"),
    ("SM_House", "Buildings"),
    ("Light", "Lights"),
]
groups = defaultdict(list)
for actor in sub.get_all_level_actors():
    key = actor.get_class().get_name()
    if isinstance(actor, unreal.StaticMeshActor):
        mesh = actor.static_mesh_component.static_mesh
        key = mesh.get_name() if mesh else "Empty"
    folder = next((f for token, f in RULES if token in key), "Misc")
    actor.set_folder_path(unreal.Name(folder))
    groups[folder].append(actor)

for folder, actors in sorted(groups.items()):
    stem = folder.split("/")[-1].rstrip("s")
    for n, actor in enumerate(sorted(actors, key=lambda a: a.get_name()), 1):
        actor.modify()
        actor.set_actor_label(f"{stem}_{n:02d}")
    print(folder, [a.get_actor_label() for a in actors])

unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world(),
    "/Game/SavedScenes/s07_organize_outliner",
)
