"""A modular building: a grid of wall modules below one root actor, blueprint gates as doors, props attached."""

import unreal

EAS = unreal.EditorActorSubsystem()
EAL = unreal.EditorAssetLibrary
CUBE = EAL.load_asset("/Engine/BasicShapes/Cube.Cube")
MODULE, HEIGHT, THICK = 400.0, 300.0, 20.0
COLUMNS, ROWS, FLOORS = 3, 2, 2

KEEP = unreal.AttachmentRule.KEEP_WORLD
RELATIVE = unreal.AttachmentRule.KEEP_RELATIVE


class Building:
    def __init__(self, name: str, origin: unreal.Vector, yaw: float):
        self.root = EAS.spawn_actor_from_class(
            unreal.Actor.static_class(), origin, unreal.Rotator(0, 0, yaw)
        )
        if self.root.root_component is None:
            print("plain actors have no root component of their own")
        self.root.set_actor_label(name)
        self.name = name
        self.frame = unreal.Transform(
            origin, unreal.Rotator(yaw=yaw), unreal.Vector(1, 1, 1)
        )
        self.parts = []

    def place(self, label, asset, local, yaw=0.0, scale=unreal.Vector(1.0, 1.0, 1.0)):
        t = unreal.Transform(local, unreal.Rotator(yaw=yaw), scale) * self.frame
        actor = EAS.spawn_actor_from_object(asset, t.translation, t.rotation.rotator())
        actor.set_actor_scale3d(scale)
        actor.set_actor_label(f"{self.name}_{label}")
        actor.set_folder_path(unreal.Name(f"Buildings/{self.name}"))
        actor.attach_to_actor(self.root, unreal.Name("None"), KEEP, KEEP, KEEP, False)
        self.parts.append(actor)
        return actor

    def wall(self, label, local, yaw):
        scale = unreal.Vector(MODULE / 100, THICK / 100, HEIGHT / 100)
        return self.place(
            label, CUBE, local + unreal.Vector(0, 0, HEIGHT / 2), yaw, scale
        )

    def slab(self, floor):
        z = floor * HEIGHT - THICK / 2
        scale = unreal.Vector(COLUMNS * MODULE / 100, ROWS * MODULE / 100, THICK / 100)
        return self.place(f"Slab_{floor}", CUBE, unreal.Vector(0, 0, z), 0.0, scale)


gate_class = EAL.load_blueprint_class("/Game/Props/BP_Gate")
assert isinstance(gate_class, unreal.Class)
b = Building("Block_A", unreal.Vector(2000, -1000, 20), 30.0)
half_x, half_y = COLUMNS * MODULE / 2, ROWS * MODULE / 2
with unreal.ScopedEditorTransaction("Build Block_A") as trans:
    for floor in range(FLOORS):
        base = floor * HEIGHT
        b.slab(floor)
        for c in range(COLUMNS):
            x = -half_x + MODULE * (c + 0.5)
            if floor == 0 and c == 1:
                door = b.place(
                    "Door",
                    EAL.load_asset("/Game/Props/BP_Gate"),
                    unreal.Vector(x - 110, -half_y, 0),
                )
                assert door.get_class() == gate_class, (door.get_class(), gate_class)
            else:
                b.wall(f"S_{floor}_{c}", unreal.Vector(x, -half_y, base), 0)
            b.wall(f"N_{floor}_{c}", unreal.Vector(x, half_y, base), 180)
        for r in range(ROWS):
            y = -half_y + MODULE * (r + 0.5)
            b.wall(f"W_{floor}_{r}", unreal.Vector(-half_x, y, base), 90)
            b.wall(f"E_{floor}_{r}", unreal.Vector(half_x, y, base), -90)
    b.slab(FLOORS)

# furniture hangs on the slab it stands on
bench = b.place(
    "Bench", EAL.load_asset("/Game/Props/SM_Bench"), unreal.Vector(0, 200, 0), 45
)
slab = next(p for p in b.parts if p.get_actor_label().endswith("Slab_0"))
bench.detach_from_actor(
    unreal.DetachmentRule.KEEP_WORLD,
    unreal.DetachmentRule.KEEP_WORLD,
    unreal.DetachmentRule.KEEP_WORLD,
)
bench.attach_to_actor(slab, "", KEEP, KEEP, KEEP, False)
assert bench.get_attach_parent_actor() == slab

lamp = EAS.spawn_actor_from_class(unreal.PointLight, unreal.Vector(0, 0, 0))
lamp.set_actor_label("Block_A_Lamp")
lamp.attach_to_actor(b.root, "", RELATIVE, RELATIVE, RELATIVE, False)
lamp.set_actor_relative_location(unreal.Vector(0, 0, HEIGHT - 40), False, False)
lamp.point_light_component.set_intensity(3200.0)
world_of_lamp = lamp.get_actor_location()

# the whole building moves with its root
before = b.parts[3].get_actor_location()
b.root.add_actor_world_offset(unreal.Vector(0, 500, 0), False, False)
after = b.parts[3].get_actor_location()
assert after.is_near_equal(before + unreal.Vector(0, 500, 0), 0.01), (before, after)
b.root.add_actor_local_rotation(unreal.Rotator(yaw=60), False, False)
assert abs(b.root.get_actor_rotation().yaw - 90) < 0.01
children = b.root.get_attached_actors(
    reset_array=True, recursively_include_attached_actors=True
)
print(
    f"{len(children)} parts below {b.root.get_actor_label()}, lamp was at {world_of_lamp}"
)
for part in children:
    assert part.get_attach_parent_actor() in (b.root, slab)

# a copy of one gate next to the building, as a class
copy = EAS.duplicate_actor(door, None, unreal.Vector(0, 0, 0))
copy.detach_from_actor(
    unreal.DetachmentRule.KEEP_WORLD,
    unreal.DetachmentRule.KEEP_WORLD,
    unreal.DetachmentRule.KEEP_WORLD,
)
copy.set_actor_label("Gate_Standalone")
copy.set_actor_location_and_rotation(
    unreal.Vector(0, 0, 0), unreal.Rotator(0, 0, 0), False, True
)
found = unreal.GameplayStatics.get_all_actors_of_class(copy.get_world(), gate_class)
assert len(found) == 2
meshes = copy.get_components_by_class(unreal.StaticMeshComponent)
print(
    "gate parts:",
    [m.get_name() for m in meshes],
    [str(m.get_editor_property("relative_location")) for m in meshes],
)
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(),
    "/Game/SavedScenes/s33_modular_building",
)
