"""Scene editing and state inspection: the host side of the tools whose scene side is ``c4s.editor.scene_tools``."""

from __future__ import annotations

from typing import Any

from c4s.toolbox.refusal import ToolRefused
from c4s.toolbox.size import ANSWER_SIZE, AROUND, ASKED_SIZE, json_text, rows_that_fit, size
from c4s.toolbox.tool import (
    ACTOR,
    LOCATION,
    ROTATION,
    SCALE,
    Arguments,
    Tool,
    ToolResult,
    asked_page,
    label,
    paged,
    text,
)
from c4s.toolbox.workbench import Workbench

EDITING, INSPECTION = "Scene editing", "State inspection"
PAGE, MOST_PAGE = 200, 1000
"""Actors that are asked of the engine for one answer: as a rule, and at most."""
LIMIT = "limit"
KINDS_TOLD = 15
"""Classes and meshes that the sum of a long list names, the most frequent first."""


def spawn_path(bench: Workbench, key: str) -> str:
    """The path behind a catalog id; a path stays what it is (the engine decides whether it loads)."""
    return key if key.startswith("/") else bench.catalog.find(key).asset.spawn_path


def _pose(arguments: Arguments) -> dict[str, Any]:
    return {key: arguments.get(key) for key in ("location", "rotation", "scale")}


def _spawn(bench: Workbench, arguments: Arguments) -> ToolResult:
    path = spawn_path(bench, arguments["static_mesh"])
    return ToolResult(
        {"actor": bench.scene("spawn_static_mesh", name=arguments["name"], static_mesh=path, **_pose(arguments))}
    )


def _spawn_blueprint(bench: Workbench, arguments: Arguments) -> ToolResult:
    path = spawn_path(bench, arguments["blueprint_id"])
    return ToolResult(
        {"actor": bench.scene("spawn_blueprint", name=arguments["actor_name"], blueprint=path, **_pose(arguments))}
    )


def _set_transform(bench: Workbench, arguments: Arguments) -> ToolResult:
    if not any(key in arguments for key in ("location", "rotation", "scale")):
        raise ToolRefused("give at least one of location, rotation and scale")
    return ToolResult({"actor": bench.scene("set_transform", name=arguments["name"], **_pose(arguments))})


def _delete(bench: Workbench, arguments: Arguments) -> ToolResult:
    return ToolResult({"deleted": bench.scene("delete", name=arguments["name"])})


def _delete_all_spawned(bench: Workbench, _: Arguments) -> ToolResult:
    level = bench.scene("current_level")
    if level not in bench.levels:
        raise ToolRefused(
            f"the open level {level} is neither the start level nor one that this run saved: "
            "its actors were not spawned by this run"
        )
    removed = bench.scene("delete_all_but", ids=bench.given)
    return ToolResult({"deleted": rows_that_fit(removed, ANSWER_SIZE - AROUND), "count": len(removed)})


def _list(bench: Workbench, arguments: Arguments) -> ToolResult:
    return _part(bench, "list_actors", arguments)


def _find(bench: Workbench, arguments: Arguments) -> ToolResult:
    return _part(bench, "find_actors", arguments, pattern=arguments["pattern"])


def _part(bench: Workbench, function: str, arguments: Arguments, **more: str) -> ToolResult:
    offset, bound = arguments.get("offset", 0), ASKED_SIZE if LIMIT in arguments else ANSWER_SIZE
    found = bench.scene(function, offset=offset, limit=arguments.get(LIMIT, PAGE), **more)
    if offset and offset >= found["total"]:
        raise ToolRefused(f"offset {offset} is past the end: there are {found['total']} actors")
    summed = _summed(found["kinds"]) if not offset else {}
    told = paged("actors", found["actors"], found["total"], offset, bound - size(json_text(summed)))
    return ToolResult(told if told["next"] is None else summed | told)


def _summed(kinds: dict[str, dict[str, int]]) -> dict[str, Any]:
    """How many actors there are of the most frequent classes and meshes."""
    return {
        f"most_frequent_{what}": dict(sorted(counts.items(), key=lambda pair: (-pair[1], pair[0]))[:KINDS_TOLD])
        for what, counts in kinds.items()
    }


TOOLS = (
    Tool(
        "spawn_actor",
        EDITING,
        "Place an actor made from a static mesh. The name becomes its label and must be new.",
        _spawn,
        {
            "name": label("Label of the new actor."),
            "static_mesh": text("Catalog id, or path of a static mesh."),
            "location": LOCATION,
            "rotation": ROTATION,
            "scale": SCALE,
        },
        ("name", "static_mesh", "location"),
    ),
    Tool(
        "spawn_blueprint_actor",
        EDITING,
        "Place an actor made from a Blueprint. The name becomes its label.",
        _spawn_blueprint,
        {
            "actor_name": label("Label of the new actor."),
            "blueprint_id": text("Catalog id, or path of a Blueprint."),
            "location": LOCATION,
            "rotation": ROTATION,
            "scale": SCALE,
        },
        ("actor_name", "blueprint_id", "location"),
    ),
    Tool(
        "set_actor_transform",
        EDITING,
        "Change position, rotation and/or scale of an actor; what is left out stays.",
        _set_transform,
        {"name": ACTOR, "location": LOCATION, "rotation": ROTATION, "scale": SCALE},
        ("name",),
    ),
    Tool("delete_actor", EDITING, "Remove one actor.", _delete, {"name": ACTOR}, ("name",)),
    Tool(
        "delete_all_spawned",
        EDITING,
        "Remove every actor that was added in this run, by whichever tool or script. "
        "The actors of the start level stay.",
        _delete_all_spawned,
    ),
    Tool(
        "get_actors_in_level",
        INSPECTION,
        "All actors: label, object name, class, location (cm), "
        "rotation [pitch, yaw, roll] (degrees), scale, static meshes. `total` counts them; where `next` is a number, "
        "call again with it as offset. A list in parts begins with the most frequent classes and meshes.",
        _list,
        asked_page(MOST_PAGE),
        asks=LIMIT,
    ),
    Tool(
        "find_actors_by_name",
        INSPECTION,
        "Actors whose label or object name holds a text, with their bounds; says "
        "which of the two matched. Long lists come in parts, as with get_actors_in_level.",
        _find,
        {
            "pattern": text(
                "Text to look for, ignoring case; * and ? stand for any text and any character.", maxLength=500
            ),
            **asked_page(MOST_PAGE),
        },
        ("pattern",),
        asks=LIMIT,
    ),
)
