import unreal

ess = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
unreal.EditorLoadingAndSavingUtils.load_map("/Game/Maps/Start")

by_label = {a.get_actor_label(): a for a in ess.get_all_level_actors()}
house = by_label["House_A"]
before = house.get_actor_rotation()
unreal.log(
    f"House_A before: pitch={before.pitch:.1f} yaw={before.yaw:.1f} roll={before.roll:.1f}"
)

# tipped over: make it upright, keep heading
house.set_actor_rotation(unreal.Rotator(roll=0.0, pitch=0.0, yaw=before.yaw), False)
try:
    house.set_actor_location(unreal.Vector(0, 0, 0))
except TypeError as err:
    unreal.log(f"expected: {err}")
    loc = house.get_actor_location()
    house.set_actor_location(unreal.Vector(loc.x, loc.y, 0.0), False, False)

for label in ("Tree_A", "Tree_B"):
    t = by_label[label].get_actor_transform()
    t.scale3d = unreal.Vector(1, 1, 1)
    t.rotation = unreal.Rotator(0, 0, 45).quaternion()
    by_label[label].set_actor_transform(t, False, True)

rock = by_label.get("Rock_A")
if rock is not None:
    ess.destroy_actor(rock)
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(),
    "/Game/SavedScenes/s08_repair_rotations",
)
