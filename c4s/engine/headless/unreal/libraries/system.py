"""System functions."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from c4s.engine.headless.state import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.components import SceneComponent
from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Object, api, public
from c4s.engine.headless.unreal.enums import DrawDebugTrace, TraceTypeQuery
from c4s.engine.headless.unreal.paths import Paths
from c4s.engine.headless.unreal.structs import LinearColor, Vector
from c4s.engine.headless.unreal.traces import HitResult, line_hits

ENGINE_VERSION = "5.6.0-c4s.headless"


@public
class SystemLibrary(Object):
    """System functions."""

    @classmethod
    @api
    def get_engine_version(cls) -> str:
        """Version of the API that this engine follows."""
        return ENGINE_VERSION

    @classmethod
    @api
    def execute_console_command(cls, world_context_object: Object | None, command: str,
                                specific_player: Object | None = None) -> None:
        """Console commands are logged and have no effect here."""
        world().log.display(f"Cmd: {command} (console commands have no effect in the headless engine)")

    @classmethod
    @api
    def collect_garbage(cls) -> None:
        """Memory is freed by itself."""

    @classmethod
    @api
    def get_object_name(cls, object: Object | None) -> str:
        """Object name."""
        return object.get_name() if object is not None else ""

    @classmethod
    @api
    def get_display_name(cls, object: Object | None) -> str:
        """Label of an actor, name of anything else."""
        if isinstance(object, Actor):
            return object.get_actor_label()
        return object.get_name() if object is not None else ""

    @classmethod
    @api
    def get_path_name(cls, object: Object | None) -> str:  # type: ignore[override]
        """Object path."""
        return object.get_path_name() if object is not None else ""

    @classmethod
    @api
    def is_valid(cls, object: Any) -> bool:
        """Whether an object exists and was not destroyed."""
        return isinstance(object, Object) and not object._dead

    @classmethod
    @api
    def get_component_bounds(cls, component: SceneComponent) -> tuple[Vector, Vector, float]:
        """World AABB of a component (centre, half extent) and its sphere's radius, in cm."""
        local = component._local_bounds()
        if local is None:
            return component.get_world_location(), Vector(), 0.0
        origin, extent = component._world_pose().box(*local)
        return Vector(*origin), Vector(*extent), math.hypot(*extent)

    @classmethod
    @api
    def line_trace_single(cls, world_context_object: Object | None, start: Vector, end: Vector,
                          trace_channel: TraceTypeQuery, trace_complex: bool, actors_to_ignore: Sequence[Actor],
                          draw_debug_type: DrawDebugTrace, ignore_self: bool = True,
                          trace_color: LinearColor = LinearColor(1, 0, 0, 1),  # noqa: B008
                          trace_hit_color: LinearColor = LinearColor(0, 1, 0, 1),  # noqa: B008
                          draw_time: float = 5.0) -> HitResult | None:
        """First hit along a line on the triangles of meshes with collision, or None. Nothing is drawn."""
        hits = line_hits(start, end, list(actors_to_ignore))
        return hits[0] if hits else None

    @classmethod
    @api
    def line_trace_multi(cls, world_context_object: Object | None, start: Vector, end: Vector,
                         trace_channel: TraceTypeQuery, trace_complex: bool, actors_to_ignore: Sequence[Actor],
                         draw_debug_type: DrawDebugTrace, ignore_self: bool = True,
                         trace_color: LinearColor = LinearColor(1, 0, 0, 1),  # noqa: B008
                         trace_hit_color: LinearColor = LinearColor(0, 1, 0, 1),  # noqa: B008
                         draw_time: float = 5.0) -> Array | None:
        """Hits along a line up to the first that blocks (every mesh blocks), or None."""
        hits = line_hits(start, end, list(actors_to_ignore))
        return Array._of("HitResult", hits[:1]) if hits else None

    @classmethod
    @api
    def quit_editor(cls) -> None:
        """Refused: the engine is ended by whoever started it."""
        world().log.error("QuitEditor: the headless engine is ended by the harness, not by a script")

    @classmethod
    @api
    def get_project_directory(cls) -> str:
        """Folder of the project."""
        return Paths.project_dir()

    @classmethod
    @api
    def get_project_content_directory(cls) -> str:
        """Folder of the content."""
        return Paths.project_content_dir()
