import unreal

# Stack things on each other by their bounds, then check that nothing overlaps
sub = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
PIECES = [
    ("/Engine/BasicShapes/Cube", (2, 2, 0.5)),
    ("/Engine/BasicShapes/Cylinder", (1, 1, 1)),
    ("/Game/Props/SM_Bench", (1, 1, 1)),
    ("/Engine/BasicShapes/Sphere", (0.5, 0.5, 0.5)),
    ("/Engine/BasicShapes/Cone", (0.5, 0.5, 0.5)),
]


def bounds(actor):
    origin, extent = actor.get_actor_bounds(only_colliding_components=False)
    return origin - extent, origin + extent


def overlap(a, b, eps=0.01):
    (alo, ahi), (blo, bhi) = bounds(a), bounds(b)
    return all(
        getattr(alo, k) < getattr(bhi, k) - eps
        and getattr(blo, k) < getattr(ahi, k) - eps
        for k in "xyz"
    )


top, stack = 0.0, []
for n, (path, scale) in enumerate(PIECES):
    actor = sub.spawn_actor_from_object(
        unreal.load_asset(path), unreal.Vector(0, 0, 0), unreal.Rotator(yaw=n * 20)
    )
    actor.set_actor_scale3d(unreal.Vector(*scale))
    lo, hi = bounds(actor)
    actor.add_actor_world_offset(unreal.Vector(0, 0, top - lo.z), False, False)
    lo, hi = bounds(actor)
    assert abs(lo.z - top) < 0.01
    top = hi.z
    actor.set_actor_label(f"Stack_{n}")
    stack.append(actor)

bad = [
    (a.get_actor_label(), b.get_actor_label())
    for i, a in enumerate(stack)
    for b in stack[i + 1 :]
    if overlap(a, b)
]
assert not bad, bad
box_origin, box_extent = unreal.GameplayStatics.get_actor_array_bounds(stack, False)
print(f"stack height {box_extent.z * 2:.1f}")
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(),
    "/Game/SavedScenes/s31_stack_by_bounds",
)
