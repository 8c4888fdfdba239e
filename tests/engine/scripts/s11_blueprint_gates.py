import unreal

BP_PATH = "/Game/Props/BP_Gate"
subsystem = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)


def get_bp_class(path):
    """Try the usual ways to get a blueprint's generated class."""
    cls = unreal.EditorAssetLibrary.load_blueprint_class(path)
    if cls:
        return cls
    name = path.rsplit("/", 1)[-1]
    return unreal.load_class(None, f"{path}.{name}_C")


gate_class = get_bp_class(BP_PATH)
same = unreal.load_class(None, BP_PATH + ".BP_Gate_C")
print("classes equal:", gate_class == same, gate_class.get_path_name())

for i, yaw in enumerate((0.0, 90.0, 180.0, 270.0)):
    direction = unreal.Rotator(0, 0, yaw).get_forward_vector()
    gate = subsystem.spawn_actor_from_class(
        gate_class, direction * 1000.0, unreal.Rotator(yaw=yaw + 90)
    )
    gate.set_actor_label(f"Gate_{['North', 'East', 'South', 'West'][i]}")
    for comp in gate.get_components_by_class(unreal.StaticMeshComponent):
        stone = unreal.load_asset("/Game/Props/M_Stone")
        for slot in range(comp.get_num_materials()):
            comp.set_material(slot, stone)

bp = unreal.load_asset(BP_PATH)
extra = subsystem.spawn_actor_from_object(bp, unreal.Vector(0, 0, 0))
extra.set_actor_label("Gate_Extra")
assert not isinstance(extra, unreal.StaticMeshActor)
found = unreal.GameplayStatics.get_all_actors_of_class(extra.get_world(), gate_class)
print("gates:", len(found))
for a in list(found):
    if a.get_actor_label() == "Gate_Extra":
        a.destroy_actor()
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(),
    "/Game/SavedScenes/s11_blueprint_gates",
)
