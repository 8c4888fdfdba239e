"""Verification tools: pictures, measurements and geometric checks of the scene as it is.

The rules are those of ``c4s.verify`` and ``c4s.collision``; here they are applied to all actors, since there is no
input scene to compare with.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from c4s.collision import scene_contacts
from c4s.engine.answers import ask_picture
from c4s.geometry.transform import Array
from c4s.protocol.rules import GAP_CM
from c4s.toolbox.pictures import read_picture, within_limit
from c4s.toolbox.refusal import ToolRefused
from c4s.toolbox.size import ANSWER_SIZE, AROUND, side_by_side
from c4s.toolbox.tool import Arguments, Tool, ToolResult, names, number, text
from c4s.toolbox.workbench import Workbench
from c4s.verify.physics.support import excluded_by_name

GROUP = "Verification"
WIDTH, HEIGHT = 1280, 720
TOUCH_TOLERANCE_CM = 5.0
_FILE = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.-]{0,99}")


def _screenshot(bench: Workbench, arguments: Arguments) -> ToolResult:
    wanted = arguments.get("filename") or Path(arguments.get("filepath", "")).name
    wanted = wanted or f"screenshot_{bench.next_picture()}"
    name = wanted if wanted.endswith(".png") else f"{wanted}.png"
    if not _FILE.fullmatch(name):
        raise ToolRefused("the file name may have letters, digits, _, - and . only")
    bench.wait_for_editor()
    reply = ask_picture(bench.engine, {"filepath": name, "width": WIDTH, "height": HEIGHT}, timeout_s=300.0)
    if reply.status not in ("ok", "success"):
        bench.blame_disk(reply.error or "")
        reason = (reply.error or str(reply.missing)).strip().rpartition("\n")[2]
        raise ToolRefused(f"no picture was taken: {reason}")
    png = read_picture(Path(reply.filepath), bench.scratch)
    return ToolResult({"filename": name, "width": WIDTH, "height": HEIGHT}, image=within_limit(png))


def _label(actor: Mapping[str, Any]) -> dict[str, Any]:
    return {"label": actor.get("label"), "name": actor.get("name")}


def _listed(**lists: list[dict[str, Any]]) -> dict[str, Any]:
    """The first rows of each list; a list that was cut is named with its full length under ``cut``."""
    told: dict[str, Any] = side_by_side(lists, ANSWER_SIZE - AROUND)
    cut = {name: len(rows) for name, rows in lists.items() if len(rows) > len(told[name])}
    return told | ({"cut": cut, "hint": "the longest lists are cut: name actors to check fewer"} if cut else {})


def _chosen(actors: Sequence[Mapping[str, Any]], wanted: Sequence[str] | None) -> list[int]:
    """Positions of the wanted actors (label, then object name); all that are no infrastructure when none is named."""
    if wanted is None:
        return [i for i, actor in enumerate(actors) if not excluded_by_name(actor)]
    chosen = []
    for name in wanted:
        found = [i for i, actor in enumerate(actors) if actor.get("label") == name] or [
            i for i, actor in enumerate(actors) if actor.get("name") == name
        ]
        if len(found) != 1:
            raise ToolRefused(
                f"{len(found) or 'no'} actors have the label or name {name!r}"
                + (": use an object name" if found else "")
            )
        chosen.append(found[0])
    return chosen


def _measure(bench: Workbench, _: Arguments) -> ToolResult:
    scene = bench.measured()
    actors = scene.actors
    floating, solid = scene.whole_physics.measurements["leaf_results"]
    by_name = {actor.get("name"): _label(actor) for actor in actors}
    return ToolResult(
        {
            "actors": len(actors),
            "floating_rate": floating["score"],
            "floating_tested": floating["evaluated"],
            "floating_unresolved": floating["unresolved"],
            "collision_rate": None if solid["score"] is None else round(1 - solid["score"], 4),
            "collision_tested": solid["evaluated"],
            "collision_unresolved": solid["unresolved"],
            "extent": None if scene.extent_cm is None else _extent(*scene.extent_cm),
            **_listed(
                floating=[by_name.get(name, {"name": name}) for name in floating["floating_actors"]],
                colliding=[
                    {
                        **by_name.get(item["actor"], {"name": item["actor"]}),
                        "tolerance_cm": item["tolerance_cm"],
                        "contacts": item["contacts"],
                    }
                    for item in solid["violations"]
                ],
            ),
            **({"not_evaluated": scene.whole_physics.reason} if scene.whole_physics.reason else {}),
        }
    )


def _extent(low: Array, high: Array) -> dict[str, Any]:
    return {
        "min_cm": low.round(2).tolist(),
        "max_cm": high.round(2).tolist(),
        "size_m": ((high - low) / 100).round(3).tolist(),
    }


def _check_floating(bench: Workbench, arguments: Arguments) -> ToolResult:
    threshold = float(arguments.get("threshold_cm", GAP_CM))
    scene = bench.measured()
    actors = scene.actors
    chosen = _chosen(actors, arguments.get("actor_names"))
    gaps = scene.gaps_cm(chosen) if "actor_names" in arguments else scene.all_gaps_cm
    floating = [
        {**_label(actors[i]), "gap_cm": None if gaps[i] is None else round(gaps[i] or 0.0, 2)}
        for i in chosen
        if i in gaps and (gaps[i] is None or (gaps[i] or 0.0) > threshold)
    ]
    counted = scene.scored_as_floating
    return ToolResult(
        {
            "count": len(floating),
            "checked": sum(i in gaps for i in chosen),
            "threshold_cm": threshold,
            **_listed(
                floating=floating,
                scored_as_floating=[_label(actors[i]) for i in chosen if actors[i].get("name") in counted],
                without_collision=[_label(actors[i]) for i in chosen if i not in gaps],
            ),
        }
    )


def _check_collisions(bench: Workbench, arguments: Arguments) -> ToolResult:
    tolerance = float(arguments.get("touch_tolerance_cm", TOUCH_TOLERANCE_CM))
    scene = bench.measured()
    actors = scene.actors
    wanted = arguments.get("actor_names")
    chosen = None if wanted is None else _chosen(actors, wanted)
    found = [
        {
            "a": _label(actors[contact.a_index]),
            "b": _label(actors[contact.b_index]),
            "depth_cm": round(contact.depth_cm, 2),
            "trusted": contact.trusted,
        }
        for contact in scene_contacts(scene.snapshot, scene.bodies, minimum_depth_cm=tolerance, actors=chosen)
    ]
    return ToolResult({"count": len(found), "touch_tolerance_cm": tolerance, **_listed(pairs=found)})


ACTORS = names("Labels or object names (default: all actors).") | {"minItems": 1, "maxItems": 5000}

TOOLS = (
    Tool(
        "take_screenshot",
        GROUP,
        f"A {WIDTH} x {HEIGHT} picture of the viewport. Its camera is set in Python "
        "(unreal.UnrealEditorSubsystem.set_level_viewport_camera_info).",
        _screenshot,
        {
            "filename": text("File name in the run's screenshot folder."),
            "filepath": text("Like filename; folders are ignored."),
        },
    ),
    Tool(
        "measure_scene",
        GROUP,
        "Number of actors, shares of floating and of colliding actors with the "
        "actors at fault, and the extent of the scene.",
        _measure,
    ),
    Tool(
        "check_floating",
        GROUP,
        "Actors that hang further above the next surface than a threshold, with the "
        "gap; and those that the physics score counts as floating by its own rule.",
        _check_floating,
        {
            "actor_names": ACTORS,
            "threshold_cm": number(f"Largest gap that counts as standing (default {GAP_CM:g} cm).", minimum=0),
        },
    ),
    Tool(
        "check_collisions",
        GROUP,
        "Pairs of actors that overlap, with the depth.",
        _check_collisions,
        {
            "actor_names": ACTORS,
            "touch_tolerance_cm": number(
                f"Overlap that still counts as touching (default {TOUCH_TOLERANCE_CM:g} cm).", minimum=0
            ),
        },
    ),
)
