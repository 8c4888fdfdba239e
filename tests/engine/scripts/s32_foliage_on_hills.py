"""Scatter foliage over uneven ground: line traces find the surface, HISM components hold the plants."""

import math
import random

import unreal

SEED = 20240611
AREA = 4000.0
random.seed(SEED)

actor_sub = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
editor_sub = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem)
level_sub = unreal.get_editor_subsystem(unreal.LevelEditorSubsystem)
world = editor_sub.get_editor_world()


def spawn_mesh(
    path, label, loc, scale=(1, 1, 1), rot=unreal.Rotator(0, 0, 0), folder="Terrain"
):
    mesh = unreal.EditorAssetLibrary.load_asset(path)
    if mesh is None:
        raise RuntimeError(f"missing asset {path}")
    actor = actor_sub.spawn_actor_from_object(mesh, unreal.Vector(*loc), rot)
    actor.set_actor_label(label)
    actor.set_actor_scale3d(unreal.Vector(*scale))
    actor.set_folder_path(folder)
    actor.static_mesh_component.set_mobility(unreal.ComponentMobility.STATIC)
    return actor


ground = spawn_mesh(
    "/Engine/BasicShapes/Plane", "Terrain_Ground", (0, 0, 0), (AREA / 50, AREA / 50, 1)
)
hills = []
for i, (x, y, r, h) in enumerate(
    [(-900, 500, 900, 260), (1200, -700, 700, 180), (300, 1500, 500, 140)]
):
    hill = spawn_mesh(
        "/Engine/BasicShapes/Sphere",
        f"Terrain_Hill_{i + 1}",
        (x, y, 0),
        (r / 50, r / 50, h / 50),
    )
    hill.tags = [unreal.Name("terrain"), unreal.Name("hill")]
    hills.append(hill)

house = spawn_mesh("/Game/Props/SM_House", "House", (1800, 1500, 0), folder="Buildings")


def ground_at(x, y, ignore=()):
    """Height, normal and actor of whatever lies below a point."""
    start, end = unreal.Vector(x, y, 5000), unreal.Vector(x, y, -1000)
    hit = unreal.SystemLibrary.line_trace_single(
        world,
        start,
        end,
        unreal.TraceTypeQuery.TRACE_TYPE_QUERY1,
        True,
        list(ignore),
        unreal.DrawDebugTrace.NONE,
        True,
    )
    if not hit:
        return None
    data = hit.to_tuple()
    blocking, location, normal, actor = data[0], data[4], data[7], data[9]
    return (location, normal, actor) if blocking else None


def make_foliage_actor(label, mesh_path):
    actor = actor_sub.spawn_actor_from_class(unreal.Actor, unreal.Vector(0, 0, 0))
    actor.set_actor_label(label)
    actor.set_folder_path("Foliage")
    subsystem = unreal.get_engine_subsystem(unreal.SubobjectDataSubsystem)
    root = subsystem.k2_gather_subobject_data_for_instance(actor)[0]
    handle, reason = subsystem.add_new_subobject(
        unreal.AddNewSubobjectParams(
            parent_handle=root,
            new_class=unreal.HierarchicalInstancedStaticMeshComponent,
            blueprint_context=None,
        )
    )
    if not reason.is_empty():
        unreal.log_error(str(reason))
    obj = unreal.SubobjectDataBlueprintFunctionLibrary.get_object(
        unreal.SubobjectDataBlueprintFunctionLibrary.get_data(handle)
    )
    obj.set_editor_property("static_mesh", unreal.load_asset(mesh_path))
    obj.set_collision_enabled(unreal.CollisionEnabled.QUERY_AND_PHYSICS)
    return actor, obj


trees_actor, trees = make_foliage_actor("Foliage_Trees", "/Game/Props/SM_Tree")
rocks_actor, rocks = make_foliage_actor("Foliage_Rocks", "/Game/Props/SM_Rock")
placed, tries = [], 0
with unreal.ScopedSlowTask(80, "Scattering foliage...") as task:
    task.make_dialog(True)
    while len(placed) < 80 and tries < 4000:
        tries += 1
        if task.should_cancel():
            break
        x, y = random.uniform(-AREA, AREA), random.uniform(-AREA, AREA)
        found = ground_at(x, y, [trees_actor, rocks_actor])
        if found is None:
            continue
        location, normal, below = found
        if below == house or not below.get_actor_label().startswith("Terrain_"):
            continue
        slope = math.degrees(
            math.acos(max(-1.0, min(1.0, normal.dot(unreal.Vector(0, 0, 1)))))
        )
        if slope > 35:
            continue
        p = unreal.Vector2D(x, y)
        if any((p - unreal.Vector2D(q.x, q.y)).length() < 220 for q in placed):
            continue
        is_tree = slope < 20 and random.random() < 0.7
        yaw = random.uniform(0, 360)
        scale = random.uniform(0.85, 1.25)
        rotation = unreal.Rotator(roll=0, pitch=0, yaw=yaw)
        if not is_tree:  # rocks follow the surface
            rotation = unreal.MathLibrary.make_rot_from_zx(
                normal, rotation.get_forward_vector()
            )
        transform = unreal.Transform(
            location=location,
            rotation=rotation,
            scale=unreal.Vector(scale, scale, scale),
        )
        (trees if is_tree else rocks).add_instance(transform, world_space=True)
        placed.append(location)
        task.enter_progress_frame(1, f"{len(placed)} plants")

unreal.log(
    f"{trees.get_instance_count()} trees, {rocks.get_instance_count()} rocks in {tries} tries"
)
assert trees.get_instance_count() + rocks.get_instance_count() == len(placed) == 80

# Every tree must stand on something: check by a short trace down from just above its foot.
floating = 0
for i in range(trees.get_instance_count()):
    foot = trees.get_instance_transform(i, world_space=True).translation
    hit = unreal.SystemLibrary.line_trace_single(
        world,
        foot + unreal.Vector(0, 0, 20),
        foot - unreal.Vector(0, 0, 20),
        unreal.TraceTypeQuery.TRACE_TYPE_QUERY1,
        True,
        [trees_actor, rocks_actor],
        unreal.DrawDebugTrace.NONE,
        True,
    )
    floating += hit is None
print("floating trees:", floating)
assert floating == 0

origin, extent = trees_actor.get_actor_bounds(only_colliding_components=False)
print(f"forest spans {extent.x * 2:.0f} x {extent.y * 2:.0f} cm around {origin}")
level_sub.save_all_dirty_levels() if False else None
unreal.EditorLoadingAndSavingUtils.save_map(
    world, "/Game/SavedScenes/s32_foliage_on_hills"
)
