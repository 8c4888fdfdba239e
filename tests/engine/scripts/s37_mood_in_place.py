"""Evening mood written straight into properties: tags, places, exposure and grading, and a report beside the project."""

import json
import os

import unreal

actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
cube = unreal.load_asset("StaticMesh'/Engine/BasicShapes/Cube.Cube'")

for number in range(3):
    crate = actors.spawn_actor_from_object(cube, unreal.Vector(0, 0, 50))
    crate.set_actor_label("Crate_01") if number == 0 else None
    crate.tags.append("crate")
    crate.static_mesh_component.relative_location.x = 200 * number
    crate.static_mesh_component.relative_rotation.yaw += 15 * number

first = next(
    a for a in actors.get_all_level_actors() if a.get_actor_label() == "Crate_01"
)
stacked = actors.duplicate_actor(first, None, unreal.Vector(0, 0, 100))
stacked.tags.append("stacked")

volume = actors.spawn_actor_from_class(unreal.PostProcessVolume, unreal.Vector())
volume.set_actor_label("Mood")
volume.unbound = True
settings = volume.settings
settings.set_editor_property("bOverride_AutoExposureBias", True)
settings.auto_exposure_bias = 0.75
settings.override_film_slope = True
settings.film_slope = 0.8
settings.override_lumen_final_gather_quality = True
settings.lumen_final_gather_quality = 2.0
settings.override_dynamic_global_illumination_method = True
settings.dynamic_global_illumination_method = (
    unreal.DynamicGlobalIlluminationMethod.LUMEN
)
settings.override_color_gain = True
settings.color_gain.x = 1.25

fog = actors.spawn_actor_from_class(unreal.ExponentialHeightFog, unreal.Vector())
fog.set_actor_label("Fog")
fog.component.fog_inscattering_luminance.r = 0.5
fog.component.second_fog_data.fog_density = 0.01

report = os.path.join(unreal.Paths.project_dir(), "Saved", "report.json")
os.makedirs(os.path.dirname(report), exist_ok=True)
with open(report, "w") as file:
    json.dump([a.get_actor_label() for a in actors.get_all_level_actors()], file)

world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
unreal.EditorLoadingAndSavingUtils.save_map(
    world, "/Game/SavedScenes/s37_mood_in_place"
)
