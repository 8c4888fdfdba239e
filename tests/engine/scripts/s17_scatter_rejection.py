"""Scatter rocks with a minimum distance and no overlap with houses, deterministic through RandomStream."""

import unreal

stream = unreal.RandomStream(1234)
eas = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
rock, house = (
    unreal.load_asset(p) for p in ("/Game/Props/SM_Rock", "/Game/Props/SM_House")
)

houses = []
for x, y in ((0, 0), (1500, 300)):
    h = eas.spawn_actor_from_object(house, unreal.Vector(x, y, 0))
    h.set_actor_label(f"House_{len(houses)}")
    houses.append(h)


def blocked(point, margin=150.0):
    for h in houses:
        origin, extent = h.get_actor_bounds(False)
        grown = unreal.MathLibrary.make_box_with_origin(
            origin, extent + unreal.Vector(margin, margin, 1000)
        )
        if unreal.MathLibrary.box_is_point_inside(grown, point):
            return True
    return False


placed, tries = [], 0
area = unreal.Box(min=unreal.Vector(-2000, -2000, 0), max=unreal.Vector(3000, 2000, 0))
while len(placed) < 25 and tries < 2000:
    tries += 1
    p = stream.random_point_in_box(area)
    if blocked(p) or any(p.distance2d(q) < 300 for q in placed):
        continue
    placed.append(p)
    r = eas.spawn_actor_from_object(rock, p, stream.random_rotator(False))
    r.set_actor_rotation(
        unreal.Rotator(yaw=stream.random_float_in_range(0, 360)), False
    )
    s = stream.random_float_in_range(0.7, 1.6)
    r.set_actor_scale3d(unreal.Vector(s, s, s))
    r.set_actor_label(f"Rock_{len(placed):02d}")
unreal.log(f"{len(placed)} rocks in {tries} tries")
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(),
    "/Game/SavedScenes/s17_scatter_rejection",
)
