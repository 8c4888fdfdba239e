"""Checks of what is saved: levels that open again, in this engine and in a clean one, and what they depend on."""

from __future__ import annotations

from typing import Any

from c4s.engine.conformance.check import Failed, Group, need, need_facts
from c4s.engine.conformance.ground import PACKAGE, Ground
from c4s.errors import BadInput

check = Group("saving")
CHECKS = check.checks
_BUILD = """
box = place("Cube", 100, 200, 50)
box.set_actor_rotation(unreal.Rotator(roll=0, pitch=0, yaw=30), False)
box.set_actor_scale3d(unreal.Vector(1, 2, 3))
box.set_actor_label("Known box")
box.tags = ["first", "second"]
box.set_folder_path("Yard/Boxes")
ball = place("Sphere", 100, 200, 250)
ball.set_actor_label("Ball above")
keep = unreal.AttachmentRule.KEEP_WORLD
ball.attach_to_actor(box, "None", keep, keep, keep, False)
lamp = actors.spawn_actor_from_class(unreal.PointLight, unreal.Vector(0, 0, 300))
lamp.set_actor_label("Lamp")
lamp.point_light_component.set_intensity(1234.0)
"""
_SAVE = f"""
fact("saved", unreal.EditorLoadingAndSavingUtils.save_map(editor.get_editor_world(), "{PACKAGE}"))
"""
_TELL = """
found = {actor.get_actor_label(): actor for actor in actors.get_all_level_actors()}
fact("labels", sorted(found))
box, ball, lamp = found["Known box"], found["Ball above"], found["Lamp"]
fact("location", box.get_actor_location())
fact("rotation", box.get_actor_rotation())
fact("scale", box.get_actor_scale3d())
fact("tags", box.tags)
fact("folder", box.get_folder_path())
fact("mesh", box.static_mesh_component.static_mesh.get_path_name())
fact("parent", ball.get_attach_parent_actor().get_actor_label())
fact("intensity", lamp.point_light_component.get_editor_property("intensity"))
"""
_FACTS: dict[str, Any] = {
    "labels": ["Ball above", "Known box", "Lamp"],
    "location": [100, 200, 50],
    "rotation": [0, 0, 30],
    "scale": [1, 2, 3],
    "tags": ["first", "second"],
    "folder": "Yard/Boxes",
    "mesh": "/Engine/BasicShapes/Cube.Cube",
    "parent": "Known box",
    "intensity": 1234,
}


def _saved(ground: Ground) -> None:
    need_facts(ground.facts(_BUILD + _SAVE), {"saved": True})


def _labelled(snapshot: dict[str, Any]) -> dict[str, Any]:
    return {actor["label"]: actor for actor in snapshot["actors"]}


@check("A level that was saved opens again as it was")
def a_saved_level_opens_again(ground: Ground) -> None:
    _saved(ground)
    script = f"""
unreal.EditorLoadingAndSavingUtils.new_blank_map(False)
clear()
fact("loaded", levels.load_level("{PACKAGE}"))
"""
    need_facts(ground.facts(script + _TELL), {"loaded": True, **_FACTS})


@check("A saved level opens in a clean engine to the same snapshot")
def a_clean_engine_reads_the_same(ground: Ground) -> None:
    _saved(ground)
    here = ground.engine.call("snapshot.export_snapshot")
    ground.close()
    with ground.another(ground.content, start_map=PACKAGE, content_read_only=True) as clean:
        there = clean.call("snapshot.export_snapshot")
    names = sorted({*here, *there})
    differ = [name for name in names if here.get(name) != there.get(name)]
    need(not differ, f"the snapshots differ in {', '.join(differ)}")


@check("Content that is mounted read-only cannot be saved over")
def read_only_content_stays(ground: Ground) -> None:
    _saved(ground)
    ground.close()
    with ground.another(ground.content, start_map=PACKAGE, content_read_only=True) as clean:
        clean.execute(
            "import unreal\n"
            "for actor in unreal.get_editor_subsystem(unreal.EditorActorSubsystem).get_all_level_actors():\n"
            "    unreal.get_editor_subsystem(unreal.EditorActorSubsystem).destroy_actor(actor)\n"
            "unreal.get_editor_subsystem(unreal.LevelEditorSubsystem).save_current_level()\n"
        )
    with ground.another(ground.content, start_map=PACKAGE, content_read_only=True) as clean:
        need(clean.call("snapshot.export_snapshot")["actor_count"] == 3, "the level was saved over")


@check("A start map that there is not is bad input")
def unknown_start_maps_are_refused(ground: Ground) -> None:
    try:
        ground.another(ground.folder / "empty", start_map="/Game/C4SConformance/Nowhere").close()
    except BadInput:
        return
    raise Failed("the engine started")


@check("A snapshot tells where things are, what they show and what they are attached to")
def a_snapshot_tells_known_places(ground: Ground) -> None:
    _saved(ground)
    snapshot = ground.engine.call("snapshot.export_snapshot")
    need(snapshot["actor_count"] == 3 and snapshot["units"] == "cm", f"{snapshot['actor_count']} actors")
    box = _labelled(snapshot)["Known box"]
    need_facts(box["transform"], {"location_cm": [100, 200, 50], "rotation_deg": [0, 30, 0], "scale": [1, 2, 3]})
    need_facts(box, {"actor_tags": ["first", "second"], "component_asset_paths": ["/Engine/BasicShapes/Cube.Cube"]})
    need_facts(box["bounds"], {"origin_cm": [100, 200, 50], "extent_cm": [93.30127, 111.60254, 150]})


@check("A snapshot says which engine made it, and which version")
def a_snapshot_names_its_engine(ground: Ground) -> None:
    snapshot = ground.engine.call("snapshot.export_snapshot")
    said = (snapshot["c4s"]["engine"], snapshot["c4s"]["engine_version"])
    engine = ground.engine
    need(said == (engine.kind, engine.version), f"it says {said}, the engine is {engine.kind} {engine.version}")


@check("A level that nothing changed has the revision that it had, and no second snapshot")
def an_unchanged_level_is_known(ground: Ground) -> None:
    _saved(ground)
    first = ground.engine.call("snapshot.export_if_changed")
    need(first["snapshot"] is not None, "the first export has no snapshot")
    if first["revision"] is None:
        return
    again = ground.engine.call("snapshot.export_if_changed", known=first["revision"])
    need(again == {"revision": first["revision"], "snapshot": None}, "it was exported again")
    ground.facts("box = place()")
    changed = ground.engine.call("snapshot.export_if_changed", known=first["revision"])
    need(changed["snapshot"] is not None, "a new actor was not noticed")


@check("The dependencies of a saved level are told, and none is missing")
def dependencies_are_told(ground: Ground) -> None:
    _saved(ground)
    told = ground.engine.call("dependencies.export_dependencies")
    need_facts(told, {"root": PACKAGE, "unresolved": [], "content_root": "/Game/"})


@check("A level that was never saved is itself missing among its dependencies")
def an_unsaved_level_is_missing(ground: Ground) -> None:
    ground.close()
    told = ground.engine.call("dependencies.export_dependencies")
    need(told["unresolved"] == [told["root"]], f"unresolved is {told['unresolved']}")
