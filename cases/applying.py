"""Applying recipes: the corrupted copy of a level, operation by operation (``cases.recipe`` has the format)."""

from __future__ import annotations

import math
from collections.abc import Sequence

from c4s.editor.identity import ORIGIN_TAG
from c4s.errors import BadInput
from c4s.records.level import Level, LevelActor, LevelComponent, Transform, Vector
from cases.corruption import SOURCE_TAG, STABLE_ID_TAG, STATIC_MESH_ACTOR, STATIC_MESH_COMPONENT, guid_of, id_of, meshes
from cases.recipe import Expected, Operation, Recipe, RemoveActor, SetStaticMesh, SetTransform, SpawnActor


def _index(actors: Sequence[LevelActor], target: str) -> int:
    for position, actor in enumerate(actors):
        if id_of(actor) == target:
            return position
    raise BadInput("no actor has this stable id", where=target, todo="is it removed by an earlier operation?")


def apply(level: Level, operations: Sequence[Operation], package: str) -> Level:
    """The corrupted copy of ``level`` as package ``package``.

    ``BadInput`` that names the operation where a target or a component is missing, or its result is not as expected.
    """
    actors = list(level.actors)
    for number, operation in enumerate(operations):
        try:
            _apply(actors, operation)
        except BadInput as error:
            where = f"operations.{number} ({operation.op}): {error.where}"
            raise BadInput(error.what, where=where, todo=error.todo) from None
    return Level(package=package, actors=actors)


def apply_recipe(level: Level, recipe: Recipe, *, where: str = "") -> Level:
    """The corrupted copy that a recipe makes of its original, ``recipe.ground_truth_map``.

    A level document holds the actors of its streamed levels as its own, so retargeting one of these changes what names
    its package: every text of an actor that begins with it.
    ``BadInput`` names the file ``where``, the operation and the field.
    """
    if level.package != recipe.ground_truth_map:
        raise BadInput(
            f"this recipe is for the level {recipe.ground_truth_map}, not {level.package}", where=where or level.package
        )
    for change in recipe.level_structure:
        level = _retargeted(level, change.source, change.target)
    try:
        return apply(level, recipe.operations, recipe.input_map)
    except BadInput as error:
        raise BadInput(error.what, where=f"{where or recipe.case_id}: {error.where}", todo=error.todo) from None


def _retargeted(level: Level, source: str, target: str) -> Level:
    """The level with another package in the place of one that it names."""

    def renamed(value: object) -> object:
        if isinstance(value, str):
            same = value == source or value.startswith((f"{source}.", f"{source}:", f"{source}/"))
            return target + value.removeprefix(source) if same else value
        if isinstance(value, list):
            return [renamed(item) for item in value]
        return {key: renamed(item) for key, item in value.items()} if isinstance(value, dict) else value

    return Level(package=level.package, actors=[LevelActor.parse(renamed(actor.plain())) for actor in level.actors])


def _apply(actors: list[LevelActor], operation: Operation) -> None:
    """Apply one operation to the actors of a level."""
    match operation:
        case RemoveActor(target=target):
            gone = actors.pop(_index(actors, target))
            if any(actor.parent == gone.name for actor in actors):
                raise BadInput("an actor with attached children cannot be removed", where=gone.name)
        case SetTransform(target=target):
            at = _index(actors, target)
            changes = {
                key: value
                for key in ("location_cm", "rotation_deg", "scale")
                if (value := getattr(operation, key)) is not None
            }
            moved = actors[at].transform.model_copy(update=changes)
            actors[at] = actors[at].model_copy(update={"transform": moved})
        case SetStaticMesh(target=target):
            at = _index(actors, target)
            like = _nearest(actors, actors[at].transform.location_cm, operation.static_mesh)
            actors[at] = _with_mesh(actors[at], operation, like)
        case SpawnActor():
            actors.append(_spawned(actors, operation))


def _with_mesh(actor: LevelActor, operation: SetStaticMesh, like: LevelActor | None) -> LevelActor:
    """The actor with another mesh, painted as expected, else as the nearest actor of that mesh is."""
    components = []
    for component in actor.components:
        if component.name == operation.component:
            if component.static_mesh != operation.replaces:
                raise BadInput(
                    f"the component shows {component.static_mesh}, not {operation.replaces}",
                    where=f"replaces, actor {actor.name}",
                )
            materials = like.components[0].materials if like else {}
            component = component.model_copy(update={"static_mesh": operation.static_mesh, "materials": materials})
        components.append(component)
    if components == actor.components:
        raise BadInput(
            f"no component {operation.component!r} to change",
            where=f"component, actor {actor.name}",
            todo=f"it has {', '.join(repr(component.name) for component in actor.components) or 'none'}",
        )
    return _as_expected(actor.model_copy(update={"components": components}), operation.expect)


def _as_expected(actor: LevelActor, expect: Expected | None) -> LevelActor:
    """The actor with the materials, tags and properties that are expected of it.

    ``BadInput`` where it shows other meshes than expected, or a slot is of a component that it lacks. Dynamic
    materials are made while an engine runs, so a level says nothing of them.
    """
    if expect is None:
        return actor
    if expect.component_asset_paths is not None and sorted(expect.component_asset_paths) != sorted(meshes(actor)):
        raise BadInput(
            f"the actor shows {', '.join(meshes(actor)) or 'nothing'}, not {', '.join(expect.component_asset_paths)}",
            where=f"expect.component_asset_paths, actor {actor.name}",
        )
    parts = {component.name: component for component in actor.components}
    for number, slot in enumerate(expect.material_slots or ()):
        if slot.component not in parts:
            raise BadInput(
                f"the actor has no component {slot.component!r}",
                where=f"expect.material_slots.{number}.component_identity, actor {actor.name}",
            )
        if not slot.is_dynamic:
            part = parts[slot.component]
            painted = {**part.materials, slot.slot_index: slot.material_path}
            parts[slot.component] = part.model_copy(update={"materials": painted})
    changes: dict[str, object] = {"components": list(parts.values())}
    if expect.tags is not None:
        own = [tag for tag in actor.tags if tag.startswith((STABLE_ID_TAG, ORIGIN_TAG)) and tag not in expect.tags]
        changes["tags"] = [*expect.tags, *own]
    if expect.properties is not None:
        changes["properties"] = expect.properties
    return actor.model_copy(update=changes)


def _spawned(actors: Sequence[LevelActor], operation: SpawnActor) -> LevelActor:
    """The new actor. What it shows comes from the operation; all else it has like those that it stands among.

    Its tags, flags and properties are those of the actor that it is made like, or of the nearest one of its mesh, or
    of the nearest static mesh actor; an override of a material is taken from one of its mesh alone. A Blueprint is
    like the nearest actor of its class.
    """
    if any(actor.name == operation.object_name for actor in actors):
        raise BadInput("an actor of this object name exists", where=f"object_name {operation.object_name}")
    mesh, kind = operation.source.get("static_mesh"), operation.source.get("class", STATIC_MESH_ACTOR)
    model = _model_of(actors, operation)
    components = list(model.components) if model else []
    if mesh is not None and operation.like is None:
        components = [_component(model, mesh)]
    elif model is not None and mesh is not None and mesh not in meshes(model):
        raise BadInput(
            f"the actor {model.name} that it is like does not show {mesh}", where=f"from, actor {operation.object_name}"
        )
    elif model is not None and model.class_path != kind:
        raise BadInput(
            f"the actor {model.name} that it is like is a {model.class_path}, not a {kind}",
            where=f"from, actor {operation.object_name}",
        )
    tags = [STABLE_ID_TAG + operation.stable_id, SOURCE_TAG] if operation.identity_tag else []
    spawned = LevelActor(
        name=operation.object_name,
        label=operation.label,
        guid=guid_of(operation.stable_id),
        class_path=kind,
        components=components,
        tags=[*_other_tags(model), *tags],
        hidden=model is not None and model.hidden,
        properties=dict(model.properties) if model else {},
        transform=Transform(
            location_cm=operation.location_cm, rotation_deg=operation.rotation_deg, scale=operation.scale
        ),
    )
    return _as_expected(spawned, operation.expect)


def _model_of(actors: Sequence[LevelActor], operation: SpawnActor) -> LevelActor | None:
    """The actor that a new one is made like; None where the level has nothing of the kind."""
    place, kind = operation.location_cm, operation.source.get("class")
    if operation.like is not None:
        return actors[_index(actors, operation.like)]
    if kind is None:
        return _nearest(actors, place, operation.source["static_mesh"]) or _nearest(actors, place)
    same = [actor for actor in actors if actor.class_path == kind]
    if not same:
        raise BadInput(
            f"a Blueprint is spawned like an existing actor only, and none is a {kind}",
            where=f"from, actor {operation.object_name}",
        )
    return min(same, key=lambda actor: math.dist(actor.transform.location_cm, place))


def _component(model: LevelActor | None, mesh: str | None) -> LevelComponent:
    """A component that shows a mesh, like the one of a static mesh actor."""
    if model is None:
        return LevelComponent(name="StaticMeshComponent0", class_path=STATIC_MESH_COMPONENT, static_mesh=mesh)
    like = model.components[0]
    return like.model_copy(
        update={"static_mesh": mesh, "materials": like.materials if like.static_mesh == mesh else {}}
    )


def _other_tags(actor: LevelActor | None) -> list[str]:
    return [tag for tag in (actor.tags if actor else ()) if not tag.startswith((STABLE_ID_TAG, ORIGIN_TAG))]


def _nearest(actors: Sequence[LevelActor], place: Vector, mesh: str | None = None) -> LevelActor | None:
    """The nearest static mesh actor of a single component, of a mesh or of any; None where there is none."""
    found = [
        actor
        for actor in actors
        if actor.class_path == STATIC_MESH_ACTOR and len(actor.components) == 1 and mesh in (None, *meshes(actor))
    ]
    return min(found, key=lambda actor: math.dist(actor.transform.location_cm, place), default=None)
