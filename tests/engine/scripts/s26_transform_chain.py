import unreal

# A clock: twelve markers placed by composing transforms, hands by relative rotation
M = unreal.MathLibrary
sub = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
cube = unreal.load_asset("/Engine/BasicShapes/Cube")

clock = unreal.Transform(
    location=unreal.Vector(0, 0, 300),
    rotation=unreal.Rotator(roll=0, pitch=0, yaw=30),
    scale=unreal.Vector(1, 1, 1),
)
arm = unreal.Transform(
    location=unreal.Vector(0, 0, 200), scale=unreal.Vector(0.2, 0.2, 0.4)
)
for hour in range(12):
    spin = unreal.Transform(rotation=unreal.Rotator(roll=hour * 30.0))
    world = arm * spin * clock  # arm first, then spin, then the clock's frame
    same = M.compose_transforms(M.compose_transforms(arm, spin), clock)
    assert world.is_near_equal(same), hour
    marker = sub.spawn_actor_from_object(cube, unreal.Vector())
    marker.set_actor_transform(world, False, False)
    marker.set_actor_label(f"Hour_{hour:02d}")
    back = world.make_relative(clock)
    assert abs(back.translation.length() - 200) < 0.01

q = unreal.Rotator(0, 0, 90).quaternion() * unreal.Rotator(0, 45, 0).quaternion()
r = q.rotator()
print(f"pitch {r.pitch:.1f} yaw {r.yaw:.1f} roll {r.roll:.1f}")
hand = sub.spawn_actor_from_object(cube, unreal.Vector(0, 0, 300), r)
hand.set_actor_label("Hand")
hand.add_actor_local_rotation(unreal.Rotator(yaw=10), False, False)
hand.add_actor_world_rotation(unreal.Rotator(yaw=-30), False, False)
mid = M.r_lerp(unreal.Rotator(0, 0, 170), unreal.Rotator(0, 0, -170), 0.5, True)
assert abs(abs(mid.yaw) - 180) < 0.01
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(),
    "/Game/SavedScenes/s26_transform_chain",
)
