"""The scene snapshot. Runs inside an engine: stdlib and ``unreal`` only.

Its fields are the published exporter's (schema 0.3.0), each found as it finds it; c4s's own lie under ``c4s``.

Centimetres and degrees; ``rotation_deg`` is [pitch, yaw, roll], quaternions are x, y, z, w. An actor that cannot be
read stops the export: a snapshot is complete, so ``export_errors`` is always empty.
"""

from __future__ import annotations

import gc
from collections import Counter
from typing import Any

import unreal

from c4s.editor import identity
from c4s.editor.facts import PartFacts, Reader, angles, row
from c4s.editor.host import host
from c4s.editor.materials import material_record

SCHEMA_VERSION = "0.3.0"


def _slots(part: PartFacts, identity: str) -> list[dict[str, Any]]:
    found = []
    for index, (path, kind) in enumerate(part.slots):
        dynamic = path is not None and ("MaterialInstanceDynamic" in str(kind) or path.startswith("/Engine/Transient"))
        found.append(
            {
                "component_identity": identity,
                "slot_index": index,
                "material_path": path,
                "material_class_path": kind,
                "is_dynamic": dynamic,
            }
        )
    return found


def _component(part: PartFacts, mesh_path: str | None) -> dict[str, Any]:
    record: dict[str, Any] = {
        "name": part.name,
        "class": part.kind,
        "mesh": mesh_path,
        "transform": part.place,
        "collision_enabled": part.collides,
        "visible": part.visible,
    }
    if part.instances is not None:
        record["instances"] = part.instances
    return record


def export_actor(actor: Any, meshes: dict[str, Any], reader: Reader) -> dict[str, Any]:
    """One actor's record; meshes that it shows are added to ``meshes`` by path."""
    components, kinds, slots, assets, colliding, primitives, shown = [], [], [], set(), [], 0, []
    parts = reader.parts(actor)
    for part in map(reader.part, parts):
        kinds.append(part.kind)
        primitives += part.primitive
        if part.collides:
            colliding.append({"name": part.name, "class": part.kind, "collision_enabled": part.collision})
        mesh_path = None
        if part.mesh is not None:
            mesh_path = reader.paths[part.mesh]
            assets.add(mesh_path)
            meshes[mesh_path] = part.mesh
            shown.append(part.visible)
        slots += _slots(part, f"{part.name}|{part.kind}")
        if part.place is not None:
            components.append(_component(part, mesh_path))
    slots.sort(key=lambda slot: (slot["component_identity"], slot["slot_index"]))
    stand = reader.stand(actor)
    asset_paths = sorted(assets)
    single = asset_paths[0] if len(asset_paths) == 1 else None
    parent_path, parent_label = stand.parent or (None, None)
    tagged = identity.tag_values(stand.tags)
    tagged_id = identity.told(tagged, "stable_actor_id")
    return {
        "stable_actor_id": tagged_id or identity.generated_id(stand.name, stand.kind, asset_paths),
        "actor_guid": stand.guid,
        "actor_origin": identity.told(tagged, "actor_origin"),
        "logical_object_id": identity.told(tagged, "logical_object_id"),
        "actor_role": identity.told(tagged, "actor_role"),
        "attachment_parent_path": parent_path,
        "attachment_parent_label": parent_label,
        "label": stand.label,
        "name": stand.name,
        "actor_path": stand.path,
        "class": stand.kind,
        "asset_path": single or (stand.kind if stand.kind.startswith("/Game/") else None),
        "asset_category": identity.told(tagged, "asset_category"),
        "component_asset_paths": asset_paths,
        "material_paths": sorted({slot["material_path"] for slot in slots if slot["material_path"]}),
        "component_material_slots": slots,
        "actor_tags": stand.tags,
        "collision": {
            "collision_enabled": bool(colliding),
            "primitive_component_count": primitives,
            "collision_enabled_component_count": len(colliding),
            "collision_enabled_components": colliding,
        },
        "transform": {"location_cm": stand.location, "rotation_deg": stand.rotation, "scale": stand.scale},
        "bounds": {"origin_cm": stand.origin, "extent_cm": stand.extent},
        "properties": reader.properties([actor, *parts]),
        "export_diagnostics": {
            "folder_path": stand.folder,
            "hidden_in_editor": stand.hidden_in_editor,
            "component_classes": sorted(set(kinds)),
            "stable_actor_id_provenance": identity.EXPLICIT if tagged_id else identity.GENERATED,
        },
        "export_errors": [],
        "c4s": {
            "quaternion_xyzw": stand.quaternion,
            "hidden": stand.hidden or (bool(shown) and not any(shown)),
            "components": components,
        },
    }


def _mesh_facts(path: str, mesh: Any) -> dict[str, Any]:
    """Digest, local bounds and collision bodies of a mesh (cm)."""
    hook = getattr(unreal, "c4s_mesh_facts", None)
    facts: dict[str, Any] | None = hook(path) if hook is not None else host().mesh_facts.get(path)
    if facts is not None:
        return facts
    box = mesh.get_bounding_box()
    return {
        "sha256": None,
        "bounds_min_cm": row(box.min),
        "bounds_max_cm": row(box.max),
        "collision": _simple_collision(mesh),
    }


def _simple_collision(mesh: Any) -> list[dict[str, Any]] | None:
    """Boxes, spheres and capsules of a mesh; None (not known) when it has convex hulls, which Python cannot read."""
    setup = mesh.get_editor_property("body_setup")
    if setup is None:
        return []
    geom = setup.get_editor_property("agg_geom")
    if len(geom.get_editor_property("convex_elems")):
        return None
    boxes = [
        {
            "kind": "box",
            "center": row(of("center")),
            "rotation_deg": angles(of("rotation")),
            "half_extent": [of("x") / 2, of("y") / 2, of("z") / 2],
        }
        for of in (elem.get_editor_property for elem in geom.get_editor_property("box_elems"))
    ]
    spheres = [
        {"kind": "sphere", "center": row(of("center")), "radius": of("radius")}
        for of in (elem.get_editor_property for elem in geom.get_editor_property("sphere_elems"))
    ]
    capsules = [
        {
            "kind": "capsule",
            "center": row(of("center")),
            "rotation_deg": angles(of("rotation")),
            "radius": of("radius"),
            "length": of("length"),
        }
        for of in (elem.get_editor_property for elem in geom.get_editor_property("sphyl_elems"))
    ]
    return [*boxes, *spheres, *capsules]


def export_if_changed(known: int | None = None) -> dict[str, Any]:
    """``{"revision", "snapshot"}``: the level's state, and its snapshot; no snapshot when ``known`` is that state."""
    now = host().revision()
    return {"revision": now, "snapshot": None if now is not None and now == known else export_snapshot()}


def export_snapshot() -> dict[str, Any]:
    """The open level as a snapshot."""
    meshes: dict[str, Any] = {}
    reader = host().reader()
    collecting = gc.isenabled()
    gc.disable()  # the records hold no garbage, and looking through them as they grow takes as long as making them
    try:
        actors = [
            export_actor(actor, meshes, reader)
            for actor in unreal.get_editor_subsystem(unreal.EditorActorSubsystem).get_all_level_actors()
        ]
    finally:
        if collecting:
            gc.enable()
    world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
    level = str(world.get_path_name()).split(".", 1)[0]
    identity.separate(actors, level)
    materials = {
        path: material_record(material, path, reader.paths[reader.class_of(material)])
        for path, material in sorted(reader.materials.items())
    }
    headless = hasattr(unreal, "c4s_mesh_facts")
    return {
        "schema_version": SCHEMA_VERSION,
        "snapshot_type": "ue_editor_scene",
        "units": "cm",
        "map_path": level,
        "actor_count": len(actors),
        "actors": actors,
        "material_parameter_catalog": materials,
        "export_metadata": _metadata(actors, level, len(materials)),
        "c4s": {
            "engine": "headless" if headless else host().kind,
            "engine_version": str(unreal.SystemLibrary.get_engine_version()),
            "meshes": {path: _mesh_facts(path, meshes[path]) for path in sorted(meshes)},
        },
    }


def _metadata(actors: list[dict[str, Any]], level: str, materials: int) -> dict[str, Any]:
    """What the export says of itself: the open level was exported, so none was asked for."""
    provenance = Counter(actor["export_diagnostics"]["stable_actor_id_provenance"] for actor in actors)
    return {
        "status": "success",
        "requested_map": None,
        "previous_map_package": level,
        "stable_actor_id_count": len(actors),
        "explicit_stable_actor_id_count": provenance[identity.EXPLICIT],
        "generated_stable_actor_id_count": len(actors) - provenance[identity.EXPLICIT],
        "disambiguated_generated_stable_actor_id_count": provenance[identity.SEPARATED],
        "generated_stable_actor_id_algorithm": identity.ALGORITHM,
        "actor_guid_count": _count(actors, "actor_guid"),
        "asset_path_count": _count(actors, "asset_path"),
        "material_actor_count": _count(actors, "material_paths"),
        "material_parameter_catalog_count": materials,
        "actor_error_count": _count(actors, "export_errors"),
    }


def _count(actors: list[dict[str, Any]], field: str) -> int:
    return sum(bool(actor[field]) for actor in actors)
