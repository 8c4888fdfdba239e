import unreal

# Replace many single actors of the same mesh by one host with an instanced component per mesh.
sub = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
rock = unreal.load_asset("/Game/Props/SM_Rock")
post = unreal.load_asset("/Game/Props/SM_Post")
for i in range(20):
    a = sub.spawn_actor_from_object(
        rock if i % 4 else post,
        unreal.Vector(100 * i, 50 * (i % 3), 0),
        unreal.Rotator(0, 0, i * 18),
    )
    a.set_actor_label(f"Loose_{i}")

groups = {}
for actor in sub.get_all_level_actors():
    comp = actor.get_component_by_class(unreal.StaticMeshComponent)
    if comp is None or not actor.get_actor_label().startswith("Loose_"):
        continue
    groups.setdefault(comp.static_mesh, []).append(actor)

subobjects = unreal.get_engine_subsystem(unreal.SubobjectDataSubsystem)
library = unreal.SubobjectDataBlueprintFunctionLibrary
host = sub.spawn_actor_from_class(unreal.Actor.static_class(), unreal.Vector(0, 0, 0))
host.set_actor_label("MergedRocks")
for mesh, members in groups.items():
    root = subobjects.k2_gather_subobject_data_for_instance(host)[0]
    handle, reason = subobjects.add_new_subobject(
        unreal.AddNewSubobjectParams(
            parent_handle=root, new_class=unreal.InstancedStaticMeshComponent
        )
    )
    component = library.get_object(
        subobjects.k2_find_subobject_data_from_handle(handle)
    )
    component.set_static_mesh(mesh)
    for member in members:
        component.add_instance(member.get_actor_transform(), world_space=True)
    print(mesh.get_name(), component.get_instance_count())
for members in groups.values():
    sub.destroy_actors(members)
total = sum(
    c.get_instance_count()
    for c in host.get_components_by_class(unreal.InstancedStaticMeshComponent)
)
assert total == 20, total
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(), "/Game/SavedScenes/s25_merge_to_hism"
)
