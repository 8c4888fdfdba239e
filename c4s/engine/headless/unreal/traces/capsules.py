"""Traces of a swept upright capsule."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import Object, api
from c4s.engine.headless.unreal.enums import DrawDebugTrace, TraceTypeQuery
from c4s.engine.headless.unreal.hits import casting
from c4s.engine.headless.unreal.hits.enums import ObjectTypeQuery
from c4s.engine.headless.unreal.structs import LinearColor, Vector

RED, GREEN = LinearColor(1, 0, 0, 1), LinearColor(0, 1, 0, 1)


class CapsuleTraces:
    """A swept upright capsule; nothing is drawn. Lengths in cm."""

    @classmethod
    @api
    def capsule_trace_single(
        cls,
        world_context_object: Object | None,
        start: Vector,
        end: Vector,
        radius: float,
        half_height: float,
        trace_channel: TraceTypeQuery,
        trace_complex: bool,
        actors_to_ignore: Sequence[Actor],
        draw_debug_type: DrawDebugTrace,
        ignore_self: bool = True,
        trace_color: LinearColor = RED,
        trace_hit_color: LinearColor = GREEN,
        draw_time: float = 5.0,
    ) -> Any:
        """The first thing that blocks a channel, or None."""
        seen = casting.wanted(
            casting.channel(trace_channel), world_context_object, actors_to_ignore, ignore_self, trace_complex
        )
        return casting.trace(
            "capsule_trace_single",
            world_context_object,
            start,
            end,
            seen,
            many=False,
            shape=lambda: casting.capsule(start._triple(), radius, half_height),
            sizes=(radius, half_height),
        )

    @classmethod
    @api
    def capsule_trace_single_for_objects(
        cls,
        world_context_object: Object | None,
        start: Vector,
        end: Vector,
        radius: float,
        half_height: float,
        object_types: Sequence[ObjectTypeQuery],
        trace_complex: bool,
        actors_to_ignore: Sequence[Actor],
        draw_debug_type: DrawDebugTrace,
        ignore_self: bool = True,
        trace_color: LinearColor = RED,
        trace_hit_color: LinearColor = GREEN,
        draw_time: float = 5.0,
    ) -> Any:
        """The first thing of some types of objects, or None."""
        seen = casting.wanted(
            casting.objects(object_types), world_context_object, actors_to_ignore, ignore_self, trace_complex
        )
        return casting.trace(
            "capsule_trace_single_for_objects",
            world_context_object,
            start,
            end,
            seen,
            many=False,
            shape=lambda: casting.capsule(start._triple(), radius, half_height),
            sizes=(radius, half_height),
        )

    @classmethod
    @api
    def capsule_trace_single_by_profile(
        cls,
        world_context_object: Object | None,
        start: Vector,
        end: Vector,
        radius: float,
        half_height: float,
        profile_name: Name | str,
        trace_complex: bool,
        actors_to_ignore: Sequence[Actor],
        draw_debug_type: DrawDebugTrace,
        ignore_self: bool = True,
        trace_color: LinearColor = RED,
        trace_hit_color: LinearColor = GREEN,
        draw_time: float = 5.0,
    ) -> Any:
        """The first thing that blocks a profile, or None."""
        seen = casting.wanted(
            casting.named(profile_name), world_context_object, actors_to_ignore, ignore_self, trace_complex
        )
        return casting.trace(
            "capsule_trace_single_by_profile",
            world_context_object,
            start,
            end,
            seen,
            many=False,
            shape=lambda: casting.capsule(start._triple(), radius, half_height),
            sizes=(radius, half_height),
        )

    @classmethod
    @api
    def capsule_trace_multi(
        cls,
        world_context_object: Object | None,
        start: Vector,
        end: Vector,
        radius: float,
        half_height: float,
        trace_channel: TraceTypeQuery,
        trace_complex: bool,
        actors_to_ignore: Sequence[Actor],
        draw_debug_type: DrawDebugTrace,
        ignore_self: bool = True,
        trace_color: LinearColor = RED,
        trace_hit_color: LinearColor = GREEN,
        draw_time: float = 5.0,
    ) -> Any:
        """Overlaps up to the first thing that blocks a channel, and that one."""
        seen = casting.wanted(
            casting.channel(trace_channel), world_context_object, actors_to_ignore, ignore_self, trace_complex
        )
        return casting.trace(
            "capsule_trace_multi",
            world_context_object,
            start,
            end,
            seen,
            many=True,
            shape=lambda: casting.capsule(start._triple(), radius, half_height),
            sizes=(radius, half_height),
        )

    @classmethod
    @api
    def capsule_trace_multi_for_objects(
        cls,
        world_context_object: Object | None,
        start: Vector,
        end: Vector,
        radius: float,
        half_height: float,
        object_types: Sequence[ObjectTypeQuery],
        trace_complex: bool,
        actors_to_ignore: Sequence[Actor],
        draw_debug_type: DrawDebugTrace,
        ignore_self: bool = True,
        trace_color: LinearColor = RED,
        trace_hit_color: LinearColor = GREEN,
        draw_time: float = 5.0,
    ) -> Any:
        """Everything of some types of objects, nearest first."""
        seen = casting.wanted(
            casting.objects(object_types), world_context_object, actors_to_ignore, ignore_self, trace_complex
        )
        return casting.trace(
            "capsule_trace_multi_for_objects",
            world_context_object,
            start,
            end,
            seen,
            many=True,
            all_hits=True,
            shape=lambda: casting.capsule(start._triple(), radius, half_height),
            sizes=(radius, half_height),
        )

    @classmethod
    @api
    def capsule_trace_multi_by_profile(
        cls,
        world_context_object: Object | None,
        start: Vector,
        end: Vector,
        radius: float,
        half_height: float,
        profile_name: Name | str,
        trace_complex: bool,
        actors_to_ignore: Sequence[Actor],
        draw_debug_type: DrawDebugTrace,
        ignore_self: bool = True,
        trace_color: LinearColor = RED,
        trace_hit_color: LinearColor = GREEN,
        draw_time: float = 5.0,
    ) -> Any:
        """Overlaps up to the first thing that blocks a profile, and that one."""
        seen = casting.wanted(
            casting.named(profile_name), world_context_object, actors_to_ignore, ignore_self, trace_complex
        )
        return casting.trace(
            "capsule_trace_multi_by_profile",
            world_context_object,
            start,
            end,
            seen,
            many=True,
            shape=lambda: casting.capsule(start._triple(), radius, half_height),
            sizes=(radius, half_height),
        )
