import math
import random

import unreal

random.seed(7)
tree = unreal.load_asset("/Game/Props/SM_Tree")
eas = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
sds = unreal.get_engine_subsystem(unreal.SubobjectDataSubsystem)


def add_hism(actor, mesh):
    """Adds an HISM component to a level actor instance through the subobject subsystem."""
    root_handle = sds.k2_gather_subobject_data_for_instance(actor)[0]
    params = unreal.AddNewSubobjectParams(
        parent_handle=root_handle,
        new_class=unreal.HierarchicalInstancedStaticMeshComponent,
    )
    handle, fail = sds.add_new_subobject(params)
    if not fail.is_empty():
        raise RuntimeError(f"add_new_subobject failed: {fail}")
    bp_lib = unreal.SubobjectDataBlueprintFunctionLibrary
    comp = bp_lib.get_object(bp_lib.get_data(handle))
    comp.set_static_mesh(mesh)
    return comp


host = eas.spawn_actor_from_class(unreal.Actor, unreal.Vector(1000, 0, 0))
host.set_actor_label("Forest")
hism = add_hism(host, tree)

transforms = []
while len(transforms) < 120:
    r = 4000 * math.sqrt(random.random())
    a = random.uniform(0, 2 * math.pi)
    p = unreal.Vector(r * math.cos(a), r * math.sin(a), 0)
    if p.length() < 600:  # keep a clearing in the middle
        continue
    s = random.uniform(0.8, 1.4)
    transforms.append(
        unreal.Transform(
            location=p,
            rotation=unreal.Rotator(yaw=random.uniform(0, 360)),
            scale=unreal.Vector(s, s, s),
        )
    )
indices = hism.add_instances(transforms, True, world_space=True)
print("added", len(indices), "of", hism.get_instance_count())

first = hism.get_instance_transform(0, True)
first.translation = unreal.Vector(0, 0, 0)
hism.update_instance_transform(0, first, world_space=True, mark_render_state_dirty=True)
hism.remove_instance(hism.get_instance_count() - 1)
hism.set_cull_distances(5000, 20000)

world = unreal.EditorLevelLibrary.get_editor_world()
unreal.EditorLoadingAndSavingUtils.save_map(world, "/Game/SavedScenes/s03_hism_forest")
