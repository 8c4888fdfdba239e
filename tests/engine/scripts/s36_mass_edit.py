"""Open the start level, classify everything by label, tag and file it, then edit by tag inside one transaction."""

import re
from collections import defaultdict

import unreal

unreal.EditorLoadingAndSavingUtils.load_map("/Game/Maps/Start")
sub = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
RULES = [
    (re.compile(r"^(House|Building)"), "building", "Set/Buildings"),
    (re.compile(r"^Tree"), "plant", "Set/Plants"),
    (re.compile(r"^(Rock|Bench)"), "prop", "Set/Props"),
    (re.compile(r"Ground|Floor"), "ground", "Set/Ground"),
]
counts = defaultdict(int)
all_actors = sub.get_all_level_actors()
unreal.log(f"{len(all_actors)} actors before")

with unreal.ScopedEditorTransaction("Classify actors"):
    with unreal.ScopedSlowTask(len(all_actors), "Classifying") as slow:
        slow.make_dialog_delayed(1.0)
        for actor in all_actors:
            slow.enter_progress_frame(1.0, actor.get_actor_label())
            for pattern, tag, folder in RULES:
                if pattern.search(actor.get_actor_label()):
                    actor.modify()
                    tags = actor.get_editor_property("tags")
                    if tag not in [str(t) for t in tags]:
                        tags.append(tag)
                    tags.append("classified")
                    actor.set_editor_property("tags", tags)
                    actor.set_folder_path(folder)
                    counts[tag] += 1
                    break
            else:
                actor.set_folder_path("Set/Other")
print(dict(counts))
assert counts == {"building": 1, "plant": 3, "prop": 2, "ground": 1}
world = unreal.EditorLevelLibrary.get_editor_world()
plants = unreal.GameplayStatics.get_all_actors_with_tag(world, "plant")
assert len(plants) == 3 and all(a.actor_has_tag("classified") for a in plants)
houses = unreal.GameplayStatics.get_all_actors_of_class_with_tag(
    world, unreal.StaticMeshActor, unreal.Name("building")
)
assert [a.get_actor_label() for a in houses] == ["House_A"]

# remove exact doubles
seen, doubles = {}, []
for a in plants:
    l = a.get_actor_location()
    key = (
        round(l.x),
        round(l.y),
        round(l.z),
        a.static_mesh_component.static_mesh.get_path_name(),
    )
    (doubles.append(a) if key in seen else seen.setdefault(key, a))
sub.destroy_actors(doubles)
print("removed", len(doubles))
plants = [a for a in plants if unreal.SystemLibrary.is_valid(a)]
assert len(plants) == 2

with unreal.ScopedEditorTransaction("Drop and straighten") as t:
    for a in (
        list(plants)
        + list(houses)
        + list(unreal.GameplayStatics.get_all_actors_with_tag(world, "prop"))
    ):
        rot = a.get_actor_rotation()
        a.set_actor_rotation(unreal.Rotator(roll=0.0, pitch=0.0, yaw=rot.yaw), False)
        origin, extent = a.get_actor_bounds(False)
        a.add_actor_world_offset(
            unreal.Vector(0, 0, -(origin.z - extent.z)), False, True
        )
    for a in plants:
        s = a.get_actor_scale3d()
        uniform = (s.x * s.y * s.z) ** (1 / 3)
        a.set_actor_scale3d(unreal.Vector(uniform, uniform, uniform))
sub.set_selected_level_actors(plants)
assert len(sub.get_selected_level_actors()) == 2
sub.select_nothing()
ground = unreal.GameplayStatics.get_all_actors_with_tag(world, "ground")[0]
ground.set_is_temporarily_hidden_in_editor(True)
assert ground.is_temporarily_hidden_in_editor()
ground.set_is_temporarily_hidden_in_editor(False)
for a in sub.get_all_level_actors():
    line = f"{a.get_folder_path()}/{a.get_actor_label()} {[str(x) for x in a.tags]} {a.get_class().get_name()}"
    unreal.log(line)
level_sub = unreal.get_editor_subsystem(unreal.LevelEditorSubsystem)
if not unreal.EditorLoadingAndSavingUtils.save_map(
    world, "/Game/SavedScenes/s36_mass_edit"
):
    unreal.log_error("save failed")
