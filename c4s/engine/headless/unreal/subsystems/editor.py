"""The editor's world and viewport."""

from __future__ import annotations

from c4s.engine.headless.editor import world
from c4s.engine.headless.pose import Pose
from c4s.engine.headless.unreal.core import api, public
from c4s.engine.headless.unreal.levels import World
from c4s.engine.headless.unreal.structs import Rotator, Vector
from c4s.engine.headless.unreal.subsystems.base import EditorSubsystem


@public
class UnrealEditorSubsystem(EditorSubsystem):
    """The editor's world and viewport."""

    _class_module = "UnrealEd"

    @api
    def get_editor_world(self) -> World:
        """The open map."""
        return world().map  # type: ignore[no-any-return]

    @api
    def get_game_world(self) -> World | None:
        """No game is played here: None."""
        return None

    @api
    def set_level_viewport_camera_info(self, camera_location: Vector, camera_rotation: Rotator) -> None:
        """Place the viewport's camera."""
        world().camera = Pose.from_rotator(camera_location._triple(), camera_rotation._triple())

    @api
    def get_level_viewport_camera_info(self) -> tuple[Vector, Rotator]:
        """Place of the viewport's camera."""
        return Vector(*world().camera.location), Rotator._of(world().camera.rotation_deg)
