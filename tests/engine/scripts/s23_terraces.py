import math

import unreal

N, CELL, STEP = 12, 200.0, 50.0
cube = unreal.load_asset("/Engine/BasicShapes/Cube")
sub = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)


def height(i, j):
    """Smooth hill, quantised to terraces."""
    x = unreal.MathLibrary.map_range_clamped(float(i), 0.0, N - 1.0, -1.0, 1.0)
    y = unreal.MathLibrary.map_range_clamped(float(j), 0.0, N - 1.0, -1.0, 1.0)
    raw = 400.0 * math.exp(-2.0 * (x * x + y * y))
    return max(STEP, unreal.MathLibrary.grid_snap_float(raw, STEP))


heights = {}
for i in range(N):
    for j in range(N):
        h = height(i, j)
        heights[(i, j)] = h
        a = sub.spawn_actor_from_object(cube, [i * CELL, j * CELL, h / 2])
        a.set_actor_scale3d([CELL / 100, CELL / 100, h / 100])
        a.set_actor_label(f"T_{i:02}_{j:02}")
        a.set_folder_path("Terrain")

peak = max(heights, key=heights.get)
flag = sub.spawn_actor_from_object(
    unreal.load_asset("/Engine/BasicShapes/Cylinder"),
    unreal.Vector(peak[0] * CELL, peak[1] * CELL, heights[peak] + 100),
)
flag.set_actor_scale3d(unreal.Vector(0.1, 0.1, 2))
flag.set_actor_label("Flag")
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(), "/Game/SavedScenes/s23_terraces"
)
