"""Overlaps of shapes and components with the collision bodies of the level."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from c4s.collision.shapes import Body
from c4s.engine.headless.queries import cast
from c4s.engine.headless.queries.filters import Wanted
from c4s.engine.headless.queries.index import current
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.components import PrimitiveComponent
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Class, Object, api
from c4s.engine.headless.unreal.hits import casting
from c4s.engine.headless.unreal.hits.enums import ObjectTypeQuery
from c4s.engine.headless.unreal.hits.results import returned
from c4s.engine.headless.unreal.structs import Rotator, Transform, Vector

LEVEL = Rotator()


def _components(bodies: list[Body], types: Sequence[Any], ignored: Sequence[Any], own: Any = None) -> list[Any]:
    """Components that the bodies overlap, each once, without ``own``."""
    found = cast.overlaps(bodies, Wanted(casting.objects(types), list(ignored)))
    return list(dict.fromkeys(target.component for target in found if target.component is not own))


def _as_components(found: list[Any], kind: Class | type | None) -> Any:
    kept = [component for component in found if casting.is_of(component, kind)]
    return returned(bool(kept), Array._of("PrimitiveComponent", kept))


def _as_actors(found: list[Any], kind: Class | type | None) -> Any:
    kept = [actor for actor in dict.fromkeys(component._outer for component in found) if casting.is_of(actor, kind)]
    return returned(bool(kept), Array._of("Actor", kept))


def _shape(what: str, context: Any, body: Any, *numbers: float) -> list[Body]:
    """The queried shape as bodies: none when the query is unusable or the shape a point."""
    made = body() if casting.usable(what, context, *numbers) else None
    return [] if made is None else [made]


def _placed(what: str, component: Any, transform: Transform) -> list[Body]:
    """A component's own bodies under another transform."""
    pose = transform._pose()
    return (
        current().of_component(component, pose)
        if casting.usable(what, component, *pose.location, *pose.quat, *pose.scale)
        else []
    )


class Overlaps:
    """What overlaps a sphere, box, capsule or placed component. Touching is no overlap. Lengths in cm."""

    @classmethod
    @api
    def sphere_overlap_actors(
        cls,
        world_context_object: Object | None,
        sphere_pos: Vector,
        sphere_radius: float,
        object_types: Sequence[ObjectTypeQuery],
        actor_class_filter: Class | type | None,
        actors_to_ignore: Sequence[Actor],
    ) -> Any:
        """Actors of some object types that overlap a sphere, or None."""
        bodies = _shape(
            "sphere_overlap_actors",
            world_context_object,
            lambda: casting.sphere(sphere_pos._triple(), sphere_radius),
            *sphere_pos._triple(),
            sphere_radius,
        )
        return _as_actors(_components(bodies, object_types, actors_to_ignore), actor_class_filter)

    @classmethod
    @api
    def sphere_overlap_components(
        cls,
        world_context_object: Object | None,
        sphere_pos: Vector,
        sphere_radius: float,
        object_types: Sequence[ObjectTypeQuery],
        component_class_filter: Class | type | None,
        actors_to_ignore: Sequence[Actor],
    ) -> Any:
        """Components of some object types that overlap a sphere, or None."""
        bodies = _shape(
            "sphere_overlap_components",
            world_context_object,
            lambda: casting.sphere(sphere_pos._triple(), sphere_radius),
            *sphere_pos._triple(),
            sphere_radius,
        )
        return _as_components(_components(bodies, object_types, actors_to_ignore), component_class_filter)

    @classmethod
    @api
    def box_overlap_actors(
        cls,
        world_context_object: Object | None,
        box_pos: Vector,
        box_extent: Vector,
        object_types: Sequence[ObjectTypeQuery],
        actor_class_filter: Class | type | None,
        actors_to_ignore: Sequence[Actor],
    ) -> Any:
        """Actors of some object types that overlap an upright box, or None."""
        bodies = _shape(
            "box_overlap_actors",
            world_context_object,
            lambda: casting.box(box_pos._triple(), box_extent, LEVEL),
            *box_pos._triple(),
            *box_extent._triple(),
        )
        return _as_actors(_components(bodies, object_types, actors_to_ignore), actor_class_filter)

    @classmethod
    @api
    def box_overlap_components(
        cls,
        world_context_object: Object | None,
        box_pos: Vector,
        extent: Vector,
        object_types: Sequence[ObjectTypeQuery],
        component_class_filter: Class | type | None,
        actors_to_ignore: Sequence[Actor],
    ) -> Any:
        """Components of some object types that overlap an upright box, or None."""
        bodies = _shape(
            "box_overlap_components",
            world_context_object,
            lambda: casting.box(box_pos._triple(), extent, LEVEL),
            *box_pos._triple(),
            *extent._triple(),
        )
        return _as_components(_components(bodies, object_types, actors_to_ignore), component_class_filter)

    @classmethod
    @api
    def box_overlap_actors_with_orientation(
        cls,
        world_context_object: Object | None,
        box_pos: Vector,
        box_extent: Vector,
        orientation: Rotator,
        object_types: Sequence[ObjectTypeQuery],
        actor_class_filter: Class | type | None,
        actors_to_ignore: Sequence[Actor],
    ) -> Any:
        """Actors of some object types that overlap a turned box, or None."""
        bodies = _shape(
            "box_overlap_actors_with_orientation",
            world_context_object,
            lambda: casting.box(box_pos._triple(), box_extent, orientation),
            *box_pos._triple(),
            *box_extent._triple(),
            *orientation._triple(),
        )
        return _as_actors(_components(bodies, object_types, actors_to_ignore), actor_class_filter)

    @classmethod
    @api
    def box_overlap_components_with_orientation(
        cls,
        world_context_object: Object | None,
        box_pos: Vector,
        extent: Vector,
        orientation: Rotator,
        object_types: Sequence[ObjectTypeQuery],
        component_class_filter: Class | type | None,
        actors_to_ignore: Sequence[Actor],
    ) -> Any:
        """Components of some object types that overlap a turned box, or None."""
        bodies = _shape(
            "box_overlap_components_with_orientation",
            world_context_object,
            lambda: casting.box(box_pos._triple(), extent, orientation),
            *box_pos._triple(),
            *extent._triple(),
            *orientation._triple(),
        )
        return _as_components(_components(bodies, object_types, actors_to_ignore), component_class_filter)

    @classmethod
    @api
    def capsule_overlap_actors(
        cls,
        world_context_object: Object | None,
        capsule_pos: Vector,
        radius: float,
        half_height: float,
        object_types: Sequence[ObjectTypeQuery],
        actor_class_filter: Class | type | None,
        actors_to_ignore: Sequence[Actor],
    ) -> Any:
        """Actors of some object types that overlap an upright capsule, or None."""
        bodies = _shape(
            "capsule_overlap_actors",
            world_context_object,
            lambda: casting.capsule(capsule_pos._triple(), radius, half_height),
            *capsule_pos._triple(),
            radius,
            half_height,
        )
        return _as_actors(_components(bodies, object_types, actors_to_ignore), actor_class_filter)

    @classmethod
    @api
    def capsule_overlap_components(
        cls,
        world_context_object: Object | None,
        capsule_pos: Vector,
        radius: float,
        half_height: float,
        object_types: Sequence[ObjectTypeQuery],
        component_class_filter: Class | type | None,
        actors_to_ignore: Sequence[Actor],
    ) -> Any:
        """Components of some object types that overlap an upright capsule, or None."""
        bodies = _shape(
            "capsule_overlap_components",
            world_context_object,
            lambda: casting.capsule(capsule_pos._triple(), radius, half_height),
            *capsule_pos._triple(),
            radius,
            half_height,
        )
        return _as_components(_components(bodies, object_types, actors_to_ignore), component_class_filter)

    @classmethod
    @api
    def capsule_overlap_actors_with_orientation(
        cls,
        world_context_object: Object | None,
        capsule_pos: Vector,
        radius: float,
        half_height: float,
        orientation: Rotator,
        object_types: Sequence[ObjectTypeQuery],
        actor_class_filter: Class | type | None,
        actors_to_ignore: Sequence[Actor],
    ) -> Any:
        """Actors of some object types that overlap a turned capsule, or None."""
        bodies = _shape(
            "capsule_overlap_actors_with_orientation",
            world_context_object,
            lambda: casting.capsule(capsule_pos._triple(), radius, half_height, orientation),
            *capsule_pos._triple(),
            radius,
            half_height,
            *orientation._triple(),
        )
        return _as_actors(_components(bodies, object_types, actors_to_ignore), actor_class_filter)

    @classmethod
    @api
    def capsule_overlap_components_with_orientation(
        cls,
        world_context_object: Object | None,
        capsule_pos: Vector,
        radius: float,
        half_height: float,
        orientation: Rotator,
        object_types: Sequence[ObjectTypeQuery],
        component_class_filter: Class | type | None,
        actors_to_ignore: Sequence[Actor],
    ) -> Any:
        """Components of some object types that overlap a turned capsule, or None."""
        bodies = _shape(
            "capsule_overlap_components_with_orientation",
            world_context_object,
            lambda: casting.capsule(capsule_pos._triple(), radius, half_height, orientation),
            *capsule_pos._triple(),
            radius,
            half_height,
            *orientation._triple(),
        )
        return _as_components(_components(bodies, object_types, actors_to_ignore), component_class_filter)

    @classmethod
    @api
    def component_overlap_actors(
        cls,
        component: PrimitiveComponent,
        component_transform: Transform,
        object_types: Sequence[ObjectTypeQuery],
        actor_class_filter: Class | type | None,
        actors_to_ignore: Sequence[Actor],
    ) -> Any:
        """Actors of some object types that a component would overlap if it were placed so, or None."""
        bodies = _placed("component_overlap_actors", component, component_transform)
        return _as_actors(_components(bodies, object_types, actors_to_ignore, component), actor_class_filter)

    @classmethod
    @api
    def component_overlap_components(
        cls,
        component: PrimitiveComponent,
        component_transform: Transform,
        object_types: Sequence[ObjectTypeQuery],
        component_class_filter: Class | type | None,
        actors_to_ignore: Sequence[Actor],
    ) -> Any:
        """Components of some object types that a component would overlap if it were placed so, or None."""
        bodies = _placed("component_overlap_components", component, component_transform)
        return _as_components(_components(bodies, object_types, actors_to_ignore, component), component_class_filter)
