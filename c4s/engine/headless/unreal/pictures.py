"""Screenshots from scripts. Pictures are taken at once, where Unreal takes them on a later frame."""

from __future__ import annotations

from pathlib import Path

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.actors import CameraActor
from c4s.engine.headless.unreal.core import Object, api, public
from c4s.engine.headless.unreal.enums import ComparisonTolerance

_FOV_DEG = 90.0
_MAX_SIDE = 4096


@public
class AutomationEditorTask(Object):
    """A picture under way: always done."""

    _class_module = "FunctionalTesting"

    @api
    def is_valid_task(self) -> bool:
        """Whether it was started."""
        return True

    @api
    def is_task_done(self) -> bool:
        """Whether the file is written."""
        return True


@public
class AutomationLibrary(Object):
    """Pictures of the open level."""

    _class_module = "FunctionalTesting"

    @classmethod
    @api
    def take_high_res_screenshot(
        cls,
        res_x: int,
        res_y: int,
        filename: str,
        camera: CameraActor | None = None,
        mask_enabled: bool = False,
        capture_hdr: bool = False,
        comparison_tolerance: ComparisonTolerance = ComparisonTolerance.LOW,
        comparison_notes: str = "",
        delay: float = 0.0,
        force_game_view: bool = True,
    ) -> AutomationEditorTask | None:
        """Write a PNG from a camera, or from the viewport; a bare file name lies in the ``Saved`` folder."""
        if not (0 < res_x <= _MAX_SIDE and 0 < res_y <= _MAX_SIDE):
            raise Exception(f"take_high_res_screenshot: the size must be 1 to {_MAX_SIDE}")
        pose = camera.camera_component._world_pose() if camera is not None else world().camera
        fov = camera.camera_component.get_editor_property("field_of_view") if camera is not None else _FOV_DEG
        path = Path(str(filename))
        if not path.is_absolute():
            path = world().scratch / "Screenshots" / path
        path.parent.mkdir(parents=True, exist_ok=True)
        view = {
            "location_cm": pose.location,
            "rotation_deg": pose.rotation_deg,
            "fov_deg": fov,
            "width": res_x,
            "height": res_y,
        }
        world().take_pictures([view], [str(path)], "lit", False)
        made: AutomationEditorTask = AutomationEditorTask._make("AutomationEditorTask_0", None)
        return made

    @classmethod
    @api
    def finish_loading_before_screenshot(cls) -> None:
        """Everything is loaded already."""
