import unreal

unreal.EditorLoadingAndSavingUtils.load_map("/Game/Maps/Start")
eas = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()


def trace_down(x, y, ignore):
    start, end = unreal.Vector(x, y, 5000), unreal.Vector(x, y, -5000)
    channel = (
        getattr(unreal.TraceTypeQuery, "TRACE_TYPE_QUERY1", None)
        or unreal.TraceTypeQuery.ECC_VISIBILITY
    )
    result = unreal.SystemLibrary.line_trace_single(
        world, start, end, channel, False, ignore, unreal.DrawDebugTrace.NONE, True
    )
    if isinstance(result, tuple):  # newer layout
        result = result[1] if result[0] else None
    if result is None:
        return None
    values = result.to_dict() if hasattr(result, "to_dict") else None
    return values["impact_point"] if values else result.to_tuple()[5]


props = [
    a
    for a in eas.get_all_level_actors()
    if isinstance(a, unreal.StaticMeshActor) and a.get_actor_label() != "Ground"
]
moved = []
for actor in props:
    origin, extent = actor.get_actor_bounds(False)
    bottom = origin.z - extent.z
    hit = trace_down(origin.x, origin.y, props)
    if hit is None:
        unreal.log_warning(f"no ground under {actor.get_actor_label()}")
        continue
    gap = bottom - hit.z
    if abs(gap) > 1.0:
        actor.add_actor_world_offset(unreal.Vector(0, 0, -gap), False, True)
        moved.append((actor.get_actor_label(), round(gap, 1)))
print("snapped:", moved)
unreal.EditorLoadingAndSavingUtils.save_map(world, "/Game/SavedScenes/s05_ground_snap")
