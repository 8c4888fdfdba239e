"""The scene snapshot (published schema 0.3.0 and c4s's own keys). Runs inside an engine: stdlib and ``unreal`` only.

Centimetres and degrees; ``rotation_deg`` is [pitch, yaw, roll], quaternions are x, y, z, w. An actor that cannot be
read stops the export: a snapshot is complete, so ``export_errors`` is always empty.
"""

from __future__ import annotations

import gc
import hashlib
import json
from typing import Any

import unreal

from c4s.editor.facts import Part, Reader, angles, row
from c4s.editor.host import host

SCHEMA_VERSION = "0.3.0"
IDENTITY_TAG = "simcodearena.stable_actor_id="
ORIGIN_TAG = "simcodearena.actor_origin="

_LIGHT = (
    "intensity",
    "intensity_units",
    "light_color",
    "temperature",
    "use_temperature",
    "indirect_lighting_intensity",
    "volumetric_scattering_intensity",
)
_FOG = ("fog_density", "fog_height_falloff", "start_distance")
_POST = {
    "exposure_compensation": "auto_exposure_bias",
    "min_brightness": "auto_exposure_min_brightness",
    "max_brightness": "auto_exposure_max_brightness",
    "white_temp": "white_temp",
    "color_saturation": "color_saturation",
    "color_contrast": "color_contrast",
    "color_gamma": "color_gamma",
    "color_gain": "color_gain",
    "color_offset": "color_offset",
}


def _json_value(value: Any) -> Any:
    """A property as JSON: colours as rows, enums as their text."""
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    for names in ("rgba", "xyzw", "xyz"):
        if all(hasattr(value, name) for name in names):
            return [getattr(value, name) for name in names]
    return str(value)


_canonical = json.JSONEncoder(sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode


def stable_actor_id(tags: list[str], name: str, class_path: str, asset_paths: list[str]) -> str:
    """The id in the actor's tags, else one generated from its object name, class and component assets."""
    for tag in tags:
        if tag.startswith(IDENTITY_TAG) and tag[len(IDENTITY_TAG) :]:
            return tag[len(IDENTITY_TAG) :]
    canonical = _canonical({"actor_name": name, "class": class_path, "component_asset_paths": sorted(asset_paths)})
    return "sca_generated_" + hashlib.sha256(canonical.encode()).hexdigest()[:32]


def _slots(part: Part, identity: str) -> list[dict[str, Any]]:
    found = []
    for index, (path, kind) in enumerate(part.slots):
        dynamic = path is not None and (
            str(kind).endswith(".MaterialInstanceDynamic") or path.startswith("/Engine/Transient")
        )
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


def _given(owner: Any, names: dict[str, str]) -> dict[str, Any]:
    """Those of the named editor properties that the object has."""
    found = {}
    for name, source in names.items():
        try:
            value = owner.get_editor_property(source)
        except Exception:  # Unreal raises a bare Exception for a property that the class does not have
            continue
        found[name] = _json_value(value)
    return found


def _light_properties(actor: Any, components: list[Any]) -> dict[str, Any]:
    """The light, fog and grading values of an actor, under the published names."""
    found: dict[str, Any] = {}
    for light in [each for each in components if isinstance(each, unreal.LightComponentBase)][:1]:
        found |= _given(light, {name: name for name in _LIGHT} | {"source_angle": "light_source_angle"})
    for fog in [each for each in components if isinstance(each, unreal.ExponentialHeightFogComponent)][:1]:
        found |= _given(fog, {name: name for name in _FOG})
    if isinstance(actor, unreal.PostProcessVolume):
        found |= _given(actor.get_editor_property("settings"), _POST)
    return found


def _component(part: Part, mesh_path: str | None) -> dict[str, Any]:
    record: dict[str, Any] = {
        "name": part.name,
        "class": part.kind,
        "mesh": mesh_path,
        "transform": part.place,
        "collision_enabled": part.collides,
    }
    if part.instances is not None:
        record["instances"] = part.instances
    return record


def _origin_tag(tags: list[str]) -> str | None:
    return next((tag[len(ORIGIN_TAG) :] for tag in tags if tag.startswith(ORIGIN_TAG)), None)


def export_actor(actor: Any, meshes: dict[str, Any], reader: Reader) -> dict[str, Any]:
    """One actor's record; meshes that it shows are added to ``meshes`` by path."""
    components, identities, slots, assets, colliding, primitives = [], [], [], set(), [], 0
    scene_components = reader.parts(actor)
    for part in map(reader.part, scene_components):
        identities.append(part.kind)
        identity = f"{part.name}|{part.kind}"
        primitives += part.primitive
        if part.collides:
            colliding.append(identity)
        mesh_path = None
        if part.mesh is not None:
            mesh_path = reader.paths[part.mesh]
            assets.add(mesh_path)
            meshes[mesh_path] = part.mesh
            slots += _slots(part, identity)
        components.append(_component(part, mesh_path))
    stand = reader.stand(actor)
    asset_paths = sorted(assets)
    single = asset_paths[0] if len(asset_paths) == 1 else None
    parent_path, parent_label = stand.parent or (None, None)
    return {
        "stable_actor_id": stable_actor_id(stand.tags, stand.name, stand.kind, asset_paths),
        "actor_guid": stand.guid,
        "actor_origin": _origin_tag(stand.tags),
        "logical_object_id": None,
        "actor_role": None,
        "attachment_parent_path": parent_path,
        "attachment_parent_label": parent_label,
        "label": stand.label,
        "name": stand.name,
        "actor_path": stand.path,
        "class": stand.kind,
        "asset_path": single or (stand.kind if stand.kind.startswith("/Game/") else None),
        "asset_category": None,
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
        "properties": _light_properties(actor, scene_components),
        "export_diagnostics": {"component_classes": sorted(set(identities))},
        "export_errors": [],
        "c4s": {"quaternion_xyzw": stand.quaternion, "components": components},
    }


def _mesh_facts(path: str, mesh: Any) -> dict[str, Any]:
    """Digest, local bounds and collision bodies of a mesh (cm)."""
    hook = getattr(unreal, "c4s_mesh_facts", None)
    facts: dict[str, Any] | None = hook(path) if hook is not None else None
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
    headless = hasattr(unreal, "c4s_mesh_facts")
    return {
        "schema_version": SCHEMA_VERSION,
        "snapshot_type": "ue_editor_scene",
        "units": "cm",
        "map_path": str(world.get_path_name()).split(".", 1)[0],
        "actor_count": len(actors),
        "export_metadata": {"status": "success", "engine_version": str(unreal.SystemLibrary.get_engine_version())},
        "actors": actors,
        "c4s": {
            "engine": "headless" if headless else "unreal",
            "meshes": {path: _mesh_facts(path, meshes[path]) for path in sorted(meshes)},
        },
    }
