import unreal


class ParkingLot:
    def __init__(self, rows, cols, origin=unreal.Vector(0, 0, 0), slot=(250.0, 500.0)):
        self.rows, self.cols, self.origin, self.slot = rows, cols, origin, slot
        self.subsystem = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
        self.cube = unreal.load_asset("/Engine/BasicShapes/Cube.Cube")
        self.actors = []

    def _box(self, label, loc, size):
        a = self.subsystem.spawn_actor_from_class(unreal.StaticMeshActor, loc)
        comp = a.static_mesh_component
        comp.set_mobility(unreal.ComponentMobility.MOVABLE)
        comp.set_static_mesh(self.cube)
        comp.set_mobility(unreal.ComponentMobility.STATIC)
        a.set_actor_scale3d(
            unreal.Vector(size[0] / 100.0, size[1] / 100.0, size[2] / 100.0)
        )
        a.set_actor_label(label, mark_dirty=True)
        self.actors.append(a)
        return a

    def build(self):
        w, l = self.slot
        for r in range(self.rows):
            for c in range(self.cols):
                corner = self.origin + unreal.Vector(c * w, r * (l + 600.0), 0)
                line = self._box(
                    f"Line_{r}_{c}", corner + unreal.Vector(0, 0, 0.5), (10, l, 1)
                )
                line.static_mesh_component.set_collision_enabled(
                    unreal.CollisionEnabled.NO_COLLISION
                )
                if (r + c) % 3 == 0:
                    self._box(
                        f"Car_{r}_{c}",
                        corner + unreal.Vector(w / 2, 0, 75),
                        (180, 420, 150),
                    )
        return len(self.actors)


lot = ParkingLot(3, 8)
total = lot.build()
center, extent = unreal.GameplayStatics.get_actor_array_bounds(lot.actors, False)
print(f"{total} actors, lot spans {extent.x * 2:.0f} x {extent.y * 2:.0f}")
unreal.get_editor_subsystem(
    unreal.UnrealEditorSubsystem
).set_level_viewport_camera_info(
    center + unreal.Vector(0, 0, 4000), unreal.Rotator(0, -90, 0)
)
world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
unreal.EditorLoadingAndSavingUtils.save_map(world, "/Game/SavedScenes/s09_parking_lot")
