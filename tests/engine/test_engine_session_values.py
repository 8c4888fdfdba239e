"""Scripts in engine processes of their own: what one wrote through properties, another one opens."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from c4s.engine.headless.host.session import EngineSession

WRITE = """
import json, os, unreal
actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
cube = unreal.load_asset("/Script/Engine.StaticMesh'/Engine/EditorMeshes/EditorCube.EditorCube'")
crate = actors.spawn_actor_from_object(cube, unreal.Vector())
crate.static_mesh_component.relative_location.z = 77
crate.static_mesh_component.lighting_channels.channel2 = True
crate.tags.append("x")
volume = actors.spawn_actor_from_class(unreal.PostProcessVolume, unreal.Vector())
volume.settings.film_slope = 0.5
volume.settings.weighted_blendables.array.append(unreal.WeightedBlendable(0.25))
volume.settings.color_gain_shadows.y = 3
try:
    volume.settings.film_slop = 1
except AttributeError as error:
    print(error)
trigger = actors.spawn_actor_from_class(unreal.TriggerBox, unreal.Vector(500, 0, 0))
trigger.collision_component.box_extent.x = 10
saved = os.path.join(unreal.Paths.project_dir(), "Saved", "notes", "a.json")
os.makedirs(os.path.dirname(saved))
with open(saved, "w") as file:
    json.dump({"version": unreal.SystemLibrary.get_engine_version()}, file)
print(json.load(open(saved))["version"], os.path.isdir(unreal.Paths.project_saved_dir()))
print(unreal.EditorLoadingAndSavingUtils.save_map(unreal.EditorLevelLibrary.get_editor_world(), "/Game/A/B"))
"""
READ = """
import json, unreal
crate, volume, trigger = unreal.get_editor_subsystem(unreal.EditorActorSubsystem).get_all_level_actors()
blend = volume.settings.weighted_blendables.array[0]
part, settings, box = crate.static_mesh_component, volume.settings, trigger.collision_component
print(json.dumps({
    "place": crate.get_actor_location().to_tuple(),
    "tags": [str(tag) for tag in crate.tags],
    "channel": part.lighting_channels.channel2,
    "slope": settings.film_slope,
    "gain": settings.color_gain_shadows.y,
    "blend": blend.weight,
    "mesh": part.static_mesh.get_path_name(),
    "box": box.box_extent.to_tuple(),
    "kind": box.get_class().get_name(),
}))
"""


@pytest.fixture(scope="module")
def told(tmp_path_factory: pytest.TempPathFactory) -> tuple[list[str], list[str], Path]:
    """What a script printed that wrote, and one that read in a clean process; and the folder of the first."""
    root = tmp_path_factory.mktemp("values")
    printed = []
    for name, script, start in (("one", WRITE, None), ("two", READ, "/Game/A/B")):
        with EngineSession.start(packs=[], content=root / "content", scratch=root / name, start_map=start) as engine:
            reply = engine.execute(script)
            assert reply["status"] == "ok", reply
            printed.append(reply["result"]["python_logs"])
    return printed[0], printed[1], root


def test_a_wrong_name_raises_and_the_project_can_be_written_to(told):
    printed, _, root = told
    assert printed[0] == "'PostProcessSettings' object has no attribute 'film_slop'"
    assert [line for line in printed if line.startswith("5.6")] == ["5.6.0-c4s.headless+5.8-names True"]
    assert (root / "one" / "Saved" / "notes" / "a.json").is_file() and printed[-1] == "True"


def test_a_clean_process_opens_what_was_written_through_properties(told):
    assert json.loads(told[1][-1]) == {
        "place": [0, 0, 77],
        "tags": ["x"],
        "channel": True,
        "slope": 0.5,
        "gain": 3,
        "blend": 0.25,
        "mesh": "/Engine/EditorMeshes/EditorCube.EditorCube",
        "box": [10, 40, 40],
        "kind": "BoxComponent",
    }
