"""Environment and persistence: missing lights and ground, and saving the scene."""

from __future__ import annotations

from typing import Any

from c4s.protocol.settings import is_construction
from c4s.toolbox.tool import Arguments, Tool, ToolResult, number, text
from c4s.toolbox.workbench import Workbench

GROUP = "Environment and persistence"
SAVED_FOLDER = "/Game/SavedScenes"
DEFAULT_GROUND_M = 100.0
DOUBLES = (
    "these actors share an identity tag, as duplicates do, so the scene cannot be judged: {labels}. "
    "Remove the tags that begin with simcodearena. from the copies and save again"
)


UNUSED = ("ground_size", "time_of_day")


def _setup(bench: Workbench, arguments: Arguments) -> ToolResult:
    if not is_construction(bench.case.setting):
        return ToolResult(_inspected(bench, arguments))
    size = float(arguments.get("ground_size", bench.case.plate_m or DEFAULT_GROUND_M))
    return ToolResult(bench.scene("setup_environment", ground_size=size, time_of_day=arguments.get("time_of_day")))


def _inspected(bench: Workbench, arguments: Arguments) -> dict[str, Any]:
    """What stands in a repair: whatever was added there would count as a wrong change."""
    told = bench.scene("inspect_environment")
    unused = [name for name in UNUSED if name in arguments]
    note = "this is a repair: light, sky, fog and ground stay as they are, nothing was added or changed"
    return {"added": [], **told, "note": f"{note}; {' and '.join(unused)} not used" if unused else note}


def _save(bench: Workbench, arguments: Arguments) -> ToolResult:
    saved = bench.scene("save_scene", package=f"{SAVED_FOLDER}/{arguments['name']}")
    bench.levels.add(saved["package"])
    if doubles := saved.pop("doubles"):
        saved["warning"] = DOUBLES.format(labels=", ".join(doubles))
    if arguments.get("revert_to_original", False):
        saved = saved | {"open_level": bench.scene("open_level", package=bench.case.start_map)["package"]}
        bench.given = list(bench.scene("actor_ids"))
    return ToolResult(saved)


TOOLS = (
    Tool(
        "setup_environment",
        GROUP,
        "Add sun, sky light, atmosphere, fog and ground where the level has none. What is "
        "there stays as it is. In a repair nothing is added or changed: it tells what stands. Call it first and last.",
        _setup,
        {
            "ground_size": number(
                "Side of the ground in metres (default: the case's plate, else 100).",
                exclusiveMinimum=0,
                maximum=10_000,
            ),
            "time_of_day": {
                "enum": ["morning", "noon", "afternoon", "sunset", "night"],
                "description": "Where a sun that is added stands (default afternoon); a later call turns it.",
            },
        },
    ),
    Tool(
        "save_scene_as",
        GROUP,
        f"Save the scene as {SAVED_FOLDER}/<name>. The last saved scene is the submission.",
        _save,
        {
            "name": text("Letters, digits, _ and -.", pattern="^[A-Za-z0-9_-]+$", maxLength=100),
            "revert_to_original": {
                "type": "boolean",
                "description": "Open the start level again afterwards (default false: the saved level stays open).",
            },
        },
        ("name",),
    ),
)
