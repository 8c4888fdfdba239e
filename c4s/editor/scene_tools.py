"""The scene side of the tools. Runs inside the engine's Python: standard library and ``unreal`` only.

All functions take and return JSON-able values; centimetres and degrees, rotations as ``[pitch, yaw, roll]``. An actor
is addressed by its label, then by its object name, and an ambiguous address is an error.
"""

from __future__ import annotations

import difflib
import fnmatch
import math
from collections import Counter
from collections.abc import Sequence
from typing import Any

import unreal

from c4s.editor.conversions import SceneRefused, rotator, rounded, scale_of, vector
from c4s.editor.identity import doubles

ENVIRONMENT_PREFIX = "Arena_Env_"
SUN, GROUND, AFTERNOON = "Sun", "Ground", "afternoon"
SUN_HEIGHT_CM = 5000.0
MOST_SHOWN = 5
"""Actors of one part of the environment that are named."""
SUN_ANGLES = {
    "morning": (-25.0, -120.0),
    "noon": (-75.0, -30.0),
    AFTERNOON: (-45.0, 30.0),
    "sunset": (-10.0, 60.0),
    "night": (10.0, 0.0),
}
"""Pitch and yaw of the sun in degrees by time of day."""
GROUND_TOP_CM = -10.0
GROUND_MESH = "/Engine/BasicShapes/Plane"
GROUND_AREA_CM2 = 4.0e6
GROUND_FLATNESS = 0.05
FEWEST_TILES = 4
"""Actors that are this flat for their width are a ground where their plans cover 20 m x 20 m together, and so many
where they cover half of the scene's plan."""


MOST_NAMED = 20
"""Object names that an error lists."""
MOST_SOUGHT, LONGEST_SOUGHT = 3000, 100
"""Labels among which, and characters of a name for which, a near one is looked for."""


def _actors() -> list[Any]:
    return list(unreal.get_editor_subsystem(unreal.EditorActorSubsystem).get_all_level_actors())


def _world() -> Any:
    return unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()


def actor_id(actor: Any) -> str:
    """The actor's guid where the engine gives one, else its path."""
    guid = actor.get_editor_property("actor_guid")
    return str(guid.to_string() or actor.get_path_name())


def _mesh_paths(actor: Any) -> list[str]:
    found = []
    for component in actor.get_components_by_class(unreal.StaticMeshComponent):
        mesh = component.get_editor_property("static_mesh")
        if mesh is not None and mesh.get_path_name() not in found:
            found.append(mesh.get_path_name())
    return found


def describe(actor: Any, *, bounds: bool = False) -> dict[str, Any]:
    """What the tools tell of an actor."""
    location, rotation, scale = actor.get_actor_location(), actor.get_actor_rotation(), actor.get_actor_scale3d()
    told = {
        "label": actor.get_actor_label(),
        "name": actor.get_name(),
        "class": actor.get_class().get_path_name(),
        "location": rounded((location.x, location.y, location.z)),
        "rotation": rounded((rotation.pitch, rotation.yaw, rotation.roll)),
        "scale": rounded((scale.x, scale.y, scale.z)),
        "static_meshes": _mesh_paths(actor),
    }
    if bounds:
        origin, extent = actor.get_actor_bounds(False)
        told["bounds"] = {
            "origin_cm": rounded((origin.x, origin.y, origin.z)),
            "half_extent_cm": rounded((extent.x, extent.y, extent.z)),
        }
    return told


def find_one(name: str) -> Any:
    """The actor with this label, else with this object name, else with either but for upper and lower case.

    Raises when there is none or more than one.
    """
    actors = _actors()
    for key in (str, str.casefold):
        for read in ("get_actor_label", "get_name"):
            found = [actor for actor in actors if key(getattr(actor, read)()) == key(name)]
            if len(found) > 1:
                listed = ", ".join(sorted(actor.get_name() for actor in found)[:MOST_NAMED])
                raise SceneRefused(f"{len(found)} actors have the label {name!r}: use an object name ({listed})")
            if found:
                return found[0]
    labels = sorted({actor.get_actor_label() for actor in actors})
    near = difflib.get_close_matches(name[:LONGEST_SOUGHT], labels, n=3) if len(labels) <= MOST_SOUGHT else []
    raise SceneRefused(
        f"no actor has the label or name {name!r}: "
        + (f"near are {', '.join(near)}" if near else "see find_actors_by_name")
    )


def actor_ids() -> list[str]:
    """Ids of all actors of the level."""
    return [actor_id(actor) for actor in _actors()]


def current_level() -> str:
    """Package path of the level that is open."""
    return str(_world().get_path_name()).split(".", 1)[0]


def list_actors(offset: int = 0, limit: int | None = None) -> dict[str, Any]:
    """The actors of the level in its order, ``limit`` of them from ``offset`` on; ``total`` counts all.

    From the first on, ``kinds`` counts the classes and meshes of all.
    """
    actors = _actors()
    return {
        "actors": [describe(actor) for actor in actors[offset : _end(offset, limit)]],
        "total": len(actors),
        "kinds": _kinds(actors) if not offset else {},
    }


def _kinds(actors: Sequence[Any]) -> dict[str, dict[str, int]]:
    """How many actors have each class and each mesh."""
    return {
        "classes": dict(Counter(actor.get_class().get_path_name() for actor in actors)),
        "meshes": dict(Counter(path for actor in actors for path in _mesh_paths(actor))),
    }


def _end(offset: int, limit: int | None) -> int | None:
    return None if limit is None else offset + limit


def find_actors(pattern: str, offset: int = 0, limit: int | None = None) -> dict[str, Any]:
    """Actors whose label or object name holds ``pattern`` (``*`` and ``?`` match any text), ignoring case.

    ``limit`` of them from ``offset`` on; ``total`` counts all that fit.
    """
    wanted = pattern.lower()
    wanted = wanted if any(mark in wanted for mark in "*?[") else f"*{wanted}*"
    found = []
    for actor in _actors():
        matched = [
            kind
            for kind, value in (("label", actor.get_actor_label()), ("name", actor.get_name()))
            if fnmatch.fnmatchcase(value.lower(), wanted)
        ]
        if matched:
            found.append((actor, matched))
    return {
        "actors": [
            dict(describe(actor, bounds=True), matched=matched)
            for actor, matched in found[offset : _end(offset, limit)]
        ],
        "total": len(found),
        "kinds": _kinds([actor for actor, _ in found]) if not offset else {},
    }


def _labels() -> set[str]:
    return {actor.get_actor_label() for actor in _actors()}


def _spawn(
    what: Any,
    label: str,
    location: Sequence[float],
    rotation: Sequence[float] | None,
    scale: float | Sequence[float] | None,
    taken: set[str] | None = None,
) -> Any:
    """Spawn with a label that must be new; ``taken`` are the labels that are there, when the caller keeps them."""
    if label in (_labels() if taken is None else taken):
        raise SceneRefused(f"an actor labelled {label!r} is already there: choose another name")
    at, turned = vector(location, "location"), rotator(rotation or (0.0, 0.0, 0.0))
    sized = None if scale is None else scale_of(scale)
    subsystem = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    if isinstance(what, unreal.Class):
        actor = subsystem.spawn_actor_from_class(what, at, turned)
    else:
        actor = subsystem.spawn_actor_from_object(what, at, turned)
    if actor is None:
        raise SceneRefused(f"the engine did not spawn {label!r}")
    actor.set_actor_label(label)
    if sized is not None:
        actor.set_actor_scale3d(sized)
    return actor


def spawn_static_mesh(
    name: str,
    static_mesh: str,
    location: Sequence[float],
    rotation: Sequence[float] | None = None,
    scale: float | Sequence[float] | None = None,
    taken: set[str] | None = None,
) -> dict[str, Any]:
    """Spawn an actor with the label ``name`` from a static mesh path."""
    mesh = unreal.EditorAssetLibrary.load_asset(static_mesh)
    if mesh is None or not isinstance(mesh, unreal.StaticMesh):
        raise SceneRefused(f"{static_mesh} is not a static mesh that can be loaded")
    return describe(_spawn(mesh, name, location, rotation, scale, taken), bounds=True)


def spawn_blueprint(
    name: str,
    blueprint: str,
    location: Sequence[float],
    rotation: Sequence[float] | None = None,
    scale: float | Sequence[float] | None = None,
    taken: set[str] | None = None,
) -> dict[str, Any]:
    """Spawn an actor with the label ``name`` from a Blueprint path (asset, or generated class with ``_C``)."""
    package = blueprint.split(".", 1)[0]
    short = package.rsplit("/", 1)[-1]
    generated = unreal.load_class(None, f"{package}.{short}_C")
    if generated is None:
        raise SceneRefused(f"{blueprint} is not a Blueprint that can be loaded")
    return describe(_spawn(generated, name, location, rotation, scale, taken), bounds=True)


def spawn_many(entries: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """Spawn entries ``{name, asset, kind, location, rotation?, scale?}``; a wrong one is told and the rest go on."""
    spawned, failed = [], []
    taken = _labels()
    for entry in entries:
        try:
            spawn = spawn_blueprint if entry.get("kind") == "blueprint" else spawn_static_mesh
            told = spawn(
                entry["name"], entry["asset"], entry["location"], entry.get("rotation"), entry.get("scale"), taken
            )
            taken.add(told["label"])
            spawned.append({"label": told["label"], "name": told["name"]})
        except (SceneRefused, KeyError, TypeError, ValueError) as error:
            failed.append({"entry": str(entry.get("name")), "error": str(error)})
    return {"spawned": spawned, "failed": failed}


def set_transform(
    name: str,
    location: Sequence[float] | None = None,
    rotation: Sequence[float] | None = None,
    scale: float | Sequence[float] | None = None,
) -> dict[str, Any]:
    """Change position, rotation and/or scale of an actor; what is left out stays."""
    actor = find_one(name)
    at = None if location is None else vector(location, "location")
    turned = None if rotation is None else rotator(rotation)
    sized = None if scale is None else scale_of(scale)
    actor.modify()
    if at is not None:
        actor.set_actor_location(at, False, True)
    if turned is not None:
        actor.set_actor_rotation(turned, True)
    if sized is not None:
        actor.set_actor_scale3d(sized)
    return describe(actor, bounds=True)


def delete(name: str) -> dict[str, Any]:
    """Remove one actor; tells what it was."""
    actor = find_one(name)
    told = describe(actor)
    if not unreal.get_editor_subsystem(unreal.EditorActorSubsystem).destroy_actor(actor):
        raise SceneRefused(f"the engine did not delete {name!r}")
    return told


def delete_all_but(ids: Sequence[str]) -> list[str]:
    """Remove every actor whose id is not listed; tells the labels of the removed ones."""
    kept, removed = set(ids), []
    subsystem = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    for actor in _actors():
        if actor_id(actor) not in kept:
            label = actor.get_actor_label()
            if subsystem.destroy_actor(actor):
                removed.append(label)
    return removed


def _grounds(actors: Sequence[Any]) -> list[Any]:
    """The actors that make the ground: flat ones that are large enough together, or that tile half of the scene."""
    flat, area, low, high = [], 0.0, [math.inf, math.inf], [-math.inf, -math.inf]
    for actor in actors:
        if not _mesh_paths(actor):
            continue
        middle, extent = actor.get_actor_bounds(False)
        low = [min(low[0], middle.x - extent.x), min(low[1], middle.y - extent.y)]
        high = [max(high[0], middle.x + extent.x), max(high[1], middle.y + extent.y)]
        if extent.z <= GROUND_FLATNESS * min(extent.x, extent.y):
            flat.append(actor)
            area += 4 * extent.x * extent.y
    tiled = len(flat) >= FEWEST_TILES and area >= (high[0] - low[0]) * (high[1] - low[1]) / 2
    return flat if tiled or area >= GROUND_AREA_CM2 else []


def _standing() -> dict[str, list[Any]]:
    """The actors that make each part of the environment."""
    actors = _actors()
    stands = {part: [actor for actor in actors if isinstance(actor, cls)] for part, cls in _parts().items()}
    own = [actor for actor in actors if actor.get_actor_label() == f"{ENVIRONMENT_PREFIX}{GROUND}"]
    return {**stands, GROUND: own or _grounds(actors)}


def _parts() -> dict[str, Any]:
    return {
        "Atmosphere": unreal.SkyAtmosphere,
        SUN: unreal.DirectionalLight,
        "SkyLight": unreal.SkyLight,
        "Fog": unreal.ExponentialHeightFog,
    }


def inspect_environment() -> dict[str, Any]:
    """Which parts of an environment stand in the level, with the labels of some of their actors, and which do not."""
    stands = _standing()
    return {
        "stands": {
            part: [actor.get_actor_label() for actor in found[:MOST_SHOWN]] for part, found in stands.items() if found
        },
        "missing": [part for part, found in stands.items() if not found],
    }


def setup_environment(ground_size: float = 100.0, time_of_day: str | None = None) -> dict[str, Any]:
    """Add a sun, sky light, atmosphere, fog and ground where the level has none; existing ones are left as they are.

    ``ground_size`` is the side of the ground in metres. A ``time_of_day`` turns the sun that this added earlier; it is
    refused where the sun is another. Tells what was added, what was there, and what was turned.
    """
    stands = _standing()
    added = [f"{ENVIRONMENT_PREFIX}{part}" for part, found in stands.items() if not found]
    present = [f"{ENVIRONMENT_PREFIX}{part}" for part, found in stands.items() if found]
    turned: list[str] = []
    pitch, yaw = SUN_ANGLES[time_of_day or AFTERNOON]
    if stands[SUN] and time_of_day is not None:
        own = [sun for sun in stands[SUN] if sun.get_actor_label() == f"{ENVIRONMENT_PREFIX}{SUN}"]
        if not own:
            raise SceneRefused(
                f"the sun {stands[SUN][0].get_actor_label()!r} is not this tool's: leave time_of_day out, and turn it "
                f"with set_actor_transform ({time_of_day} is rotation [{pitch:g}, {yaw:g}, 0])"
            )
        own[0].modify()
        own[0].set_actor_rotation(rotator((pitch, yaw, 0.0)), True)
        turned = [own[0].get_actor_label()]
    for part, cls in _parts().items():
        if not stands[part]:
            high = (0.0, 0.0, SUN_HEIGHT_CM if cls in (unreal.DirectionalLight, unreal.SkyLight) else 0.0)
            rotation = (pitch, yaw, 0.0) if part == SUN else None
            _lit(part, _spawn(cls.static_class(), f"{ENVIRONMENT_PREFIX}{part}", high, rotation, None))
    if not stands[GROUND]:
        side = float(ground_size)
        plane = unreal.EditorAssetLibrary.load_asset(GROUND_MESH)
        _spawn(plane, f"{ENVIRONMENT_PREFIX}{GROUND}", (0.0, 0.0, GROUND_TOP_CM), None, (side, side, 1.0))
    return {"added": added, "already_there": present, "turned": turned}


def _lit(part: str, actor: Any) -> None:
    """Give a new part of the environment its values."""
    if part == SUN:
        light = actor.get_component_by_class(unreal.DirectionalLightComponent)
        light.set_intensity(10.0)
        light.set_atmosphere_sun_light(True)
    elif part == "SkyLight":
        actor.light_component.set_intensity(3.0)
    elif part == "Fog":
        actor.component.set_fog_density(0.002)
        actor.component.set_fog_max_opacity(0.6)


def save_scene(package: str) -> dict[str, Any]:
    """Save the open level as ``package`` and stay in it. ``doubles`` are labels of actors that share one identity."""
    if not unreal.EditorLoadingAndSavingUtils.save_map(_world(), package):
        raise SceneRefused(f"the engine did not save {package}")
    actors = _actors()
    tagged = [(actor.get_actor_label(), [str(tag) for tag in actor.tags]) for actor in actors]
    return {"package": package, "actors": len(actors), "doubles": doubles(tagged)}


def open_level(package: str) -> dict[str, Any]:
    """Open a level. Tells its package and actor count."""
    if unreal.EditorLoadingAndSavingUtils.load_map(package) is None:
        raise SceneRefused(f"the engine did not open {package}")
    return {"package": package, "actors": len(_actors())}
