"""Queries against one component alone, and what a component or actor overlaps."""

from __future__ import annotations

from typing import Any

import numpy as np

from c4s.engine.headless.queries import cast
from c4s.engine.headless.queries.channels import Response
from c4s.engine.headless.queries.filters import Wanted
from c4s.engine.headless.queries.index import current
from c4s.engine.headless.unreal.components.sweeping import SweptMoves
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Class, api
from c4s.engine.headless.unreal.hits import casting
from c4s.engine.headless.unreal.hits.results import HitResult, returned
from c4s.engine.headless.unreal.structs import Rotator, Vector


def overlapped(component: Any) -> list[Any]:
    """Components that notice each other: they overlap, and neither side ignores, nor do both block."""

    def answer(other: Any) -> Response:
        mutual = Response(min(other._answers(component._channel()), component._answers(other._channel())))
        return (
            Response.OVERLAP if mutual is Response.OVERLAP and other._outer is not component._outer else Response.IGNORE
        )

    if not component._queries():
        return []
    bodies = current().of_component(component, component._world_pose())
    return list(dict.fromkeys(target.component for target in cast.overlaps(bodies, Wanted(answer))))


class ComponentQueries(SweptMoves):
    """Queries against a component's own geometry. Lengths in cm."""

    def _alone(self, triangles: bool) -> Wanted:
        return Wanted(lambda _: Response.BLOCK, triangles=bool(triangles), only=self)

    def _single(
        self, what: str, start: Vector, end: Vector, triangles: bool, shape: Any = None, sizes: tuple[float, ...] = ()
    ) -> Any:
        numbers = (*start._triple(), *end._triple(), *sizes)
        usable = casting.usable(what, self, *numbers)
        moving = shape() if usable and shape is not None else None
        seen = self._alone(triangles)
        hits = (
            []
            if not usable or (shape is not None and moving is None)
            else (
                cast.ray(casting.row(start), casting.row(end), seen)
                if moving is None
                else cast.sweep(moving, casting.row(end) - casting.row(start), seen)
            )
        )
        hit = HitResult._of(hits[0], start, end) if hits else HitResult()
        fields = hit.to_dict()
        found = (fields["location"], fields["normal"], Name(), hit)
        return returned(bool(hits), found) if hits or returned(False, 0) is None else (False, *found)

    @api
    def line_trace_component(
        self,
        trace_start: Vector,
        trace_end: Vector,
        trace_complex: bool = True,
        show_trace: bool = False,
        persistent_show_trace: bool = False,
    ) -> Any:
        """Where a line meets this component, as (location, normal, bone, hit), or None."""
        return self._single("line_trace_component", trace_start, trace_end, trace_complex)

    @api
    def sphere_trace_component(
        self,
        trace_start: Vector,
        trace_end: Vector,
        sphere_radius: float,
        trace_complex: bool = True,
        show_trace: bool = False,
        persistent_show_trace: bool = False,
    ) -> Any:
        """Where a moved sphere meets this component, as (location, normal, bone, hit), or None."""
        return self._single(
            "sphere_trace_component",
            trace_start,
            trace_end,
            trace_complex,
            lambda: casting.sphere(trace_start._triple(), sphere_radius),
            (sphere_radius,),
        )

    @api
    def sphere_overlap_component(
        self,
        sphere_centre: Vector,
        sphere_radius: float,
        trace_complex: bool = True,
        show_trace: bool = False,
        persistent_show_trace: bool = False,
    ) -> Any:
        """How a sphere overlaps this component, as (location, normal, bone, hit), or None."""
        return self._single(
            "sphere_overlap_component",
            sphere_centre,
            sphere_centre,
            trace_complex,
            lambda: casting.sphere(sphere_centre._triple(), sphere_radius),
            (sphere_radius,),
        )

    @api
    def box_overlap_component(
        self,
        box_centre: Vector,
        box: Any,
        trace_complex: bool = True,
        show_trace: bool = False,
        persistent_show_trace: bool = False,
    ) -> Any:
        """How a box (corners relative to the centre) overlaps this component, as (location, normal, bone, hit)."""
        low, high = box.min, box.max
        middle = box_centre + (low + high) / 2.0
        half = (high - low) / 2.0
        return self._single(
            "box_overlap_component",
            middle,
            middle,
            trace_complex,
            lambda: casting.box(middle._triple(), half, Rotator()),
            half._triple(),
        )

    @api
    def get_closest_point_on_collision(self, point: Vector, bone_name: Name | str = "None") -> tuple[float, Vector]:
        """Distance (cm) and nearest point of the collision bodies: 0 inside them, below 0 when there are none."""
        bodies = current().of_component(self, self._world_pose()) if self._queries() else []
        probe = casting.sphere(point._triple(), 2 * casting.NOTHING_CM)
        if not bodies or probe is None or not casting.usable("get_closest_point_on_collision", self, *point._triple()):
            return -1.0, Vector()
        gaps = [cast.gap(probe, body) for body in bodies]
        distance, nearest = gaps[int(np.argmin([gap for gap, _ in gaps]))]
        distance += probe.form.radius
        return (0.0, point.copy()) if distance <= casting.NOTHING_CM else (distance, Vector(*nearest.tolist()))

    @api
    def get_overlapping_components(self) -> Array:
        """Components that overlap it and notice that (blocking ones do not, as in Unreal)."""
        return Array._of("PrimitiveComponent", overlapped(self))

    @api
    def get_overlapping_actors(self, class_filter: Class | type | None = None) -> Array:
        """Actors of a class whose components overlap it and notice that."""
        found = dict.fromkeys(component._outer for component in overlapped(self))
        return Array._of("Actor", [actor for actor in found if casting.is_of(actor, class_filter)])
