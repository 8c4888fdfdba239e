"""Makes a level of a level document, through ``unreal`` alone. Runs inside an engine: stdlib and ``unreal`` only.

A document (``c4s.records.level``, as plain data) is what a case starts from; a real editor needs a package. Centimetres
and degrees, rotations as [pitch, yaw, roll].
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import unreal

from c4s.editor.conversions import rotator

Record = Mapping[str, Any]
_PLACE: Record = {"location_cm": (0.0, 0.0, 0.0), "rotation_deg": (0.0, 0.0, 0.0), "scale": (1.0, 1.0, 1.0)}
_VECTORS = ("Vector", "Vector2D", "Vector4", "LinearColor", "IntPoint")
"""Structs whose fields a document keeps as a row, in the order of the constructor."""


class LevelNotMade(ValueError):
    """A document has what this cannot make."""


def make_level(document: Record) -> dict[str, Any]:
    """Close the open level, make that of a document, and save it as the document's package: package, actor count.

    ``LevelNotMade`` names the actor that cannot be made as the document says it.
    """
    maps = unreal.EditorLoadingAndSavingUtils
    world = maps.new_blank_map(False)
    made: dict[str, Any] = {}
    for record in document["actors"]:
        try:
            made[record["name"]] = _make_actor(record)
        except Exception as error:  # Unreal raises bare Exceptions; which actor it was must be told
            raise LevelNotMade(f"{record['name']}: {error}") from error
    for record in document["actors"]:
        if record.get("parent"):
            keep = unreal.AttachmentRule.KEEP_WORLD
            made[record["name"]].attach_to_actor(made[record["parent"]], "None", keep, keep, keep, False)
    if not maps.save_map(world, document["package"]):
        raise LevelNotMade(f"the editor did not save {document['package']}")
    return {"package": document["package"], "actors": len(made)}


def _make_actor(record: Record) -> Any:
    kind = unreal.load_class(None, record["class_path"])
    if kind is None:
        raise LevelNotMade(f"there is no class {record['class_path']}")
    place = {**_PLACE, **record.get("transform", {})}
    actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    actor = actors.spawn_actor_from_class(kind, unreal.Vector(*place["location_cm"]), rotator(place["rotation_deg"]))
    if actor is None:
        raise LevelNotMade(f"the editor did not spawn a {record['class_path']}")
    if actor.get_name() != record["name"] and not actor.rename(record["name"]):
        raise LevelNotMade("the editor did not take its object name")
    actor.set_actor_label(record["label"])
    actor.set_actor_location(unreal.Vector(*place["location_cm"]), False, True)
    actor.set_actor_rotation(rotator(place["rotation_deg"]), True)
    actor.set_actor_scale3d(unreal.Vector(*place["scale"]))
    if record.get("tags"):
        actor.set_editor_property("tags", [unreal.Name(tag) for tag in record["tags"]])
    if record.get("folder"):
        actor.set_folder_path(record["folder"])
    _set_properties(actor, record.get("properties", {}))
    free = list(actor.get_components_by_class(unreal.ActorComponent))
    for number, part in enumerate(record.get("components", ())):
        _fill(_component(actor, part, free), part, is_root=number == 0)
    if record.get("hidden"):
        actor.set_actor_hidden_in_game(True)
    return actor


def _component(actor: Any, part: Record, free: list[Any]) -> Any:
    """The component of a new actor that a record describes, by name or else by class; or one that is added."""
    alike = [component for component in free if component.get_class().get_path_name() == part["class_path"]]
    found = next((one for one in alike if one.get_name() == part["name"]), alike[0] if alike else None)
    if found is not None:
        free.remove(found)
        return found
    subobjects = unreal.get_engine_subsystem(unreal.SubobjectDataSubsystem)
    parent = subobjects.k2_gather_subobject_data_for_instance(actor)[0]
    kind = unreal.load_class(None, part["class_path"])
    parameters = unreal.AddNewSubobjectParams(parent_handle=parent, new_class=kind)
    handle, fault = subobjects.add_new_subobject(parameters)
    data = subobjects.k2_find_subobject_data_from_handle(handle)
    added = unreal.SubobjectDataBlueprintFunctionLibrary.get_object(data) if data is not None else None
    if added is None:
        raise LevelNotMade(f"no component {part['name']} of class {part['class_path']}: {fault}")
    return added


def _fill(component: Any, part: Record, *, is_root: bool) -> None:
    if part.get("static_mesh"):
        mesh = unreal.EditorAssetLibrary.load_asset(part["static_mesh"])
        if mesh is None:
            raise LevelNotMade(f"there is no mesh {part['static_mesh']}")
        component.set_static_mesh(mesh)
    for slot, path in part.get("materials", {}).items():
        material = unreal.EditorAssetLibrary.load_asset(path)
        if material is None:
            raise LevelNotMade(f"there is no material {path}")
        component.set_material(int(slot), material)
    for instance in part.get("instances", ()):
        component.add_instance(_transform(instance))
    _set_properties(component, part.get("properties", {}))
    if not part.get("collision_enabled", True) and isinstance(component, unreal.PrimitiveComponent):
        component.set_collision_enabled(unreal.CollisionEnabled.NO_COLLISION)
    if not is_root and part.get("relative") and isinstance(component, unreal.SceneComponent):
        place = {**_PLACE, **part["relative"]}
        component.set_editor_property("relative_location", unreal.Vector(*place["location_cm"]))
        component.set_editor_property("relative_rotation", rotator(place["rotation_deg"]))
        component.set_editor_property("relative_scale3d", unreal.Vector(*place["scale"]))


def _transform(record: Record) -> Any:
    place = {**_PLACE, **record}
    return unreal.Transform(
        unreal.Vector(*place["location_cm"]), rotator(place["rotation_deg"]), unreal.Vector(*place["scale"])
    )


def _set_properties(owner: Any, values: Record) -> None:
    for name, raw in values.items():
        owner.set_editor_property(name, _value(raw, owner.get_editor_property(name)))


def _value(raw: Any, now: Any) -> Any:
    """A value of a document as the property's present value is one."""
    kind = type(now)
    if isinstance(raw, str) and raw.startswith("/") and "." in raw:
        return unreal.EditorAssetLibrary.load_asset(raw)
    if isinstance(raw, str) and hasattr(kind, raw) and not isinstance(now, str):
        return getattr(kind, raw)
    if isinstance(now, unreal.Color):
        return unreal.Color(r=raw[0], g=raw[1], b=raw[2], a=raw[3])
    if isinstance(now, unreal.Rotator):
        return rotator(raw)
    if kind.__name__ in _VECTORS:
        return kind(*raw)
    if isinstance(raw, Mapping):
        for name, inner in raw.items():
            now.set_editor_property(name, _value(inner, now.get_editor_property(name)))
        return now
    if isinstance(raw, Sequence) and not isinstance(raw, str) and len(now):
        return [_value(item, now[0]) for item in raw]
    return raw
