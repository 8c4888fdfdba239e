"""Build a small village street with houses on both sides."""

import unreal

MAP_PATH = "/Game/SavedScenes/s01_village_street"

actor_subsystem = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
level_subsystem = unreal.get_editor_subsystem(unreal.LevelEditorSubsystem)


def load(path):
    asset = unreal.EditorAssetLibrary.load_asset(path)
    if not asset:
        unreal.log_warning(f"[Village] asset not found: {path}")
    return asset


def spawn_mesh(mesh, label, location, yaw=0.0, scale=(1.0, 1.0, 1.0), folder="Village"):
    actor = actor_subsystem.spawn_actor_from_object(
        mesh, unreal.Vector(*location), unreal.Rotator(0.0, 0.0, yaw)
    )
    actor.set_actor_label(label)
    actor.set_actor_scale3d(unreal.Vector(*scale))
    actor.set_folder_path(folder)
    return actor


if not level_subsystem.new_level(MAP_PATH):
    raise RuntimeError("could not create level")

house = load("/Game/Props/SM_House")
plane = load("/Engine/BasicShapes/Plane.Plane")
missing = load("/Game/Props/SM_DoesNotExist")
assert missing is None

ground = spawn_mesh(plane, "Ground", (0, 0, 0), scale=(100, 100, 1))
count = 0
for side in (-1, 1):
    for i in range(5):
        x = -2000 + i * 1000
        y = side * 800
        yaw = 90.0 if side < 0 else -90.0
        spawn_mesh(
            house,
            f"House_{count:02d}",
            (x, y, 0),
            yaw,
            folder=f"Village/{'Left' if side < 0 else 'Right'}",
        )
        count += 1

print(f"Spawned {count} houses")
if level_subsystem.save_current_level():
    unreal.log("[Village] saved")
