import unreal

eas = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
cube = unreal.load_asset("/Engine/BasicShapes/Cube")
cyl = unreal.load_asset("/Engine/BasicShapes/Cylinder")

table = eas.spawn_actor_from_object(cube, unreal.Vector(500, 500, 75))
table.set_actor_scale3d(unreal.Vector(2, 1, 0.1))
table.set_actor_label("TableTop")
legs = []
for sx in (-1, 1):
    for sy in (-1, 1):
        leg = eas.spawn_actor_from_object(
            cyl, unreal.Vector(500 + sx * 90, 500 + sy * 40, 35)
        )
        leg.set_actor_scale3d(unreal.Vector(0.1, 0.1, 0.7))
        leg.set_actor_label(f"Leg_{len(legs)}")
        leg.attach_to_actor(
            table,
            "",
            unreal.AttachmentRule.KEEP_WORLD,
            unreal.AttachmentRule.KEEP_WORLD,
            unreal.AttachmentRule.KEEP_WORLD,
            False,
        )
        legs.append(leg)

lamp = eas.spawn_actor_from_class(unreal.PointLight, unreal.Vector(0, 0, 0))
lamp.set_actor_label("DeskLamp")
lamp.attach_to_actor(
    table,
    "None",
    unreal.AttachmentRule.SNAP_TO_TARGET,
    unreal.AttachmentRule.SNAP_TO_TARGET,
    unreal.AttachmentRule.KEEP_RELATIVE,
    False,
)
lamp.set_actor_relative_location(unreal.Vector(0, 0, 400), False, False)

# move and turn the whole group
table.set_actor_location_and_rotation(
    unreal.Vector(0, 0, 75), unreal.Rotator(0, 0, 90), False, False
)
children = table.get_attached_actors()
print("children:", sorted(a.get_actor_label() for a in children))
legs[3].detach_from_actor(
    unreal.DetachmentRule.KEEP_WORLD,
    unreal.DetachmentRule.KEEP_WORLD,
    unreal.DetachmentRule.KEEP_WORLD,
)
assert legs[3].get_attach_parent_actor() is None
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(),
    "/Game/SavedScenes/s10_attach_furniture",
)
