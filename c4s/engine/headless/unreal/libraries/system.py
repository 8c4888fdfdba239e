"""System functions."""

from __future__ import annotations

import math
from typing import Any

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.components import SceneComponent
from c4s.engine.headless.unreal.core import Object, api, public
from c4s.engine.headless.unreal.libraries.editing import Editing
from c4s.engine.headless.unreal.navigation import rebuild
from c4s.engine.headless.unreal.paths import Paths
from c4s.engine.headless.unreal.structs import Vector
from c4s.engine.headless.unreal.traces.boxes import BoxTraces
from c4s.engine.headless.unreal.traces.capsules import CapsuleTraces
from c4s.engine.headless.unreal.traces.lines import LineTraces
from c4s.engine.headless.unreal.traces.overlaps import Overlaps
from c4s.engine.headless.unreal.traces.spheres import SphereTraces
from c4s.engine.headless.version import ENGINE_VERSION


@public
class SystemLibrary(LineTraces, SphereTraces, BoxTraces, CapsuleTraces, Overlaps, Editing, Object):
    """System functions."""

    @classmethod
    @api
    def get_engine_version(cls) -> str:
        """Version of the API that this engine follows."""
        return ENGINE_VERSION

    @classmethod
    @api
    def execute_console_command(
        cls, world_context_object: Object | None, command: str, specific_player: Object | None = None
    ) -> None:
        """``RebuildNavigation`` builds the navigation mesh; other commands are logged and have no effect here."""
        if command.strip().lower() == "rebuildnavigation":
            rebuild()
            return
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
