import json
import os
from dataclasses import dataclass, field

import unreal

SPEC = json.loads("""
{"name": "s24_town_from_spec", "blocks": [
  {"asset": "/Game/Props/SM_House.SM_House", "grid": [2, 3], "pitch": [900, 900], "origin": [0, 0, 0], "yaw": 90},
  {"asset": "/Game/Props/SM_Tree.SM_Tree", "grid": [1, 6], "pitch": [0, 450], "origin": [-700, 0, 0], "jitter": true},
  {"asset": "/Game/Props/SM_Missing.SM_Missing", "grid": [1, 1], "pitch": [0, 0], "origin": [0, 0, 0]}
]}
""")


@dataclass
class Report:
    spawned: list[str] = field(default_factory=list)
    missing: list[str] = field(default_factory=list)
    error: str | None = None


def place(block, report, sub):
    mesh = unreal.EditorAssetLibrary.load_asset(block["asset"])
    if mesh is None or not isinstance(mesh, unreal.StaticMesh):
        report.missing.append(block["asset"])
        return
    rows, cols = block["grid"]
    ox, oy, oz = block["origin"]
    for r in range(rows):
        for c in range(cols):
            jitter = 40.0 if block.get("jitter") and (r + c) % 2 else 0.0
            loc = unreal.Vector(
                ox + r * block["pitch"][0] + jitter, oy + c * block["pitch"][1], oz
            )
            actor = sub.spawn_actor_from_object(
                mesh, loc, unreal.Rotator(yaw=float(block.get("yaw", 0)))
            )
            label = f"{mesh.get_name().replace('SM_', '')}_{r}_{c}"
            actor.set_actor_label(label)
            report.spawned.append(label)


report = Report()
try:
    subsystem = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    for block in SPEC["blocks"]:
        place(block, report, subsystem)
    world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
    if not unreal.EditorLoadingAndSavingUtils.save_map(
        world, f"/Game/SavedScenes/{SPEC['name']}"
    ):
        report.error = "save_map returned False"
except Exception as exc:  # report, never crash the editor
    report.error = f"{type(exc).__name__}: {exc}"
    raise
finally:
    folder = unreal.Paths.combine([unreal.Paths.project_saved_dir(), "AgentReports"])
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, SPEC["name"] + ".json"), "w") as handle:
        json.dump(report.__dict__, handle)
    unreal.log(
        f"missing: {report.missing}, spawned: {len(report.spawned)}, error: {report.error}"
    )
