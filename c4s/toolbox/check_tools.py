"""Verification tools: pictures, measurements and geometric checks of the scene as it is.

The rules are those of ``c4s.verify`` and ``c4s.collision``. In a repair what the agent changed is told apart from what
stood so at the start, which is only summed.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from c4s.collision import scene_contacts
from c4s.engine.answers import ask_picture
from c4s.geometry.transform import Array
from c4s.protocol.rules import GAP_CM
from c4s.toolbox.measured import MeasuredScene
from c4s.toolbox.pictures import read_picture, within_limit
from c4s.toolbox.refusal import ToolRefused
from c4s.toolbox.size import ANSWER_SIZE, AROUND, side_by_side
from c4s.toolbox.tool import Arguments, Tool, ToolResult, names, number, text
from c4s.toolbox.workbench import Workbench
from c4s.verify.physics.support import excluded_by_name

GROUP = "Verification"
WIDTH, HEIGHT = 1280, 720
TOUCH_TOLERANCE_CM = 5.0
ROOM = ANSWER_SIZE - AROUND - 2_000
"""Bytes for the lists of an answer, beside what stood so at the start."""
EXAMPLES = 5
"""Actors or pairs that stood so at the start and are named."""
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


Row = dict[str, Any]


def _label(actor: Mapping[str, Any]) -> Row:
    return {"label": actor.get("label"), "name": actor.get("name")}


def _listed(**lists: list[Row]) -> Row:
    """The first rows of each list; a list that was cut is named with its full length under ``cut``."""
    told: Row = side_by_side(lists, ROOM)
    cut = {name: len(rows) for name, rows in lists.items() if len(rows) > len(told[name])}
    return told | ({"cut": cut, "hint": "the longest lists are cut: name actors to check fewer"} if cut else {})


def _stood(what: str, rows: list[Row]) -> Row:
    """What was so at the start and is nobody's doing: counted, with a few of them."""
    return {what: len(rows), "examples": rows[:EXAMPLES]} if rows else {what: 0}


def _chosen(actors: Sequence[Mapping[str, Any]], wanted: Sequence[str] | None) -> list[int]:
    """Positions of the wanted actors (label, then object name); all that are no infrastructure when none is named."""
    if wanted is None:
        return [i for i, actor in enumerate(actors) if not excluded_by_name(actor)]
    return [_position(actors, name) for name in wanted]


def _position(actors: Sequence[Mapping[str, Any]], name: str) -> int:
    """Where the actor of a label or object name stands, as the scene tools find it."""
    for key in (str, str.casefold):
        for field in ("label", "name"):
            found = [i for i, actor in enumerate(actors) if key(str(actor.get(field))) == key(name)]
            if len(found) > 1:
                raise ToolRefused(f"{len(found)} actors have the label or name {name!r}: use an object name")
            if found:
                return found[0]
    raise ToolRefused(f"no actors have the label or name {name!r}")


def _measure(bench: Workbench, _: Arguments) -> ToolResult:
    scene = bench.measured()
    floating, solid = scene.physics.measurements["leaf_results"]
    labels = {str(actor.get("name")): _label(actor) for actor in scene.actors}

    def labelled(name: str) -> Row:
        return labels.get(name, {"name": name})

    unsettled = [{**labelled(name), "why": "not changed, but what held it was"} for name in scene.unsettled]
    colliding = [_violation(item, labelled) for item in sorted(solid["violations"], key=_depth_cm, reverse=True)]
    told = {
        "actors": len(scene.actors),
        "floating_rate": floating["score"],
        "floating_tested": floating["evaluated"],
        "floating_unresolved": floating["unresolved"],
        "collision_rate": None if solid["score"] is None else round(1 - solid["score"], 4),
        "collision_tested": solid["evaluated"],
        "collision_unresolved": solid["unresolved"],
        "extent": None if scene.extent_cm is None else _extent(*scene.extent_cm),
        **({"not_evaluated": scene.physics.reason} if scene.physics.reason else {}),
    }
    if scene.start is not None:
        before, here = scene.start.whole_physics.measurements["leaf_results"], scene.positions
        same = {name for name, index in here.items() if index not in scene.changed}
        told |= {
            "changed_or_added": len(scene.changed),
            "removed": scene.removed,
            "stood_so_at_start": {
                **_stood("floating", [labelled(name) for name in before[0]["floating_actors"] if name in same]),
                "colliding": sum(item["actor"] in same for item in before[1]["violations"]),
            },
            "note": "rates and lists are of what was changed since the start",
        }
    return ToolResult(
        told | _listed(floating=[*map(labelled, floating["floating_actors"]), *unsettled], colliding=colliding)
    )


def _depth_cm(item: Mapping[str, Any]) -> float:
    """The deepest contact of an actor that stands in others."""
    return max((contact["depth_cm"] or 0.0 for contact in item["contacts"]), default=0.0)


def _violation(item: Mapping[str, Any], labelled: Callable[[str], Row]) -> Row:
    """An actor that stands in others, with their labels."""
    found = {key: item[key] for key in ("tolerance_cm", "contacts_found") if key in item}
    contacts = [{"label": labelled(contact["actor"]).get("label"), **contact} for contact in item["contacts"]]
    return {**labelled(item["actor"]), **found, "contacts": contacts}


def _extent(low: Array, high: Array) -> Row:
    return {
        "min_cm": low.round(2).tolist(),
        "max_cm": high.round(2).tolist(),
        "size_m": ((high - low) / 100).round(3).tolist(),
    }


def _floats(gap_cm: float | None, threshold_cm: float) -> bool:
    return gap_cm is None or gap_cm > threshold_cm


def _check_floating(bench: Workbench, arguments: Arguments) -> ToolResult:
    threshold = float(arguments.get("threshold_cm", GAP_CM))
    scene = bench.measured()
    actors, wanted = scene.actors, arguments.get("actor_names")
    chosen = _chosen(actors, wanted)
    gaps = scene.all_gaps_cm if wanted is None else scene.gaps_cm(chosen)
    found = [i for i in chosen if i in gaps and _floats(gaps[i], threshold)]
    found.sort(key=lambda i: -math.inf if (gap := gaps[i]) is None else -gap)
    stood = _floated_before(scene, found, threshold)
    rows = {i: {**_label(actors[i]), "gap_cm": None if (gap := gaps[i]) is None else round(gap, 2)} for i in found}
    counted = scene.scored_as_floating
    shown = chosen if wanted is not None else [i for i in chosen if i in scene.changed]
    told: Row = {"count": len(found) - len(stood), "checked": sum(i in gaps for i in chosen), "threshold_cm": threshold}
    if scene.start is not None:
        told["stood_so_at_start"] = _stood("floating", [rows[i] for i in found if i in stood])
    return ToolResult(
        told
        | _listed(
            floating=[row for i, row in rows.items() if i not in stood],
            scored_as_floating=[_label(actors[i]) for i in chosen if actors[i].get("name") in counted],
            without_collision=[_label(actors[i]) for i in shown if i not in gaps],
        )
    )


def _floated_before(scene: MeasuredScene, found: Sequence[int], threshold_cm: float) -> set[int]:
    """Which of the actors that float now were not changed and floated at the start."""
    before = {i: old for i in found if (old := scene.before(i)) is not None}
    if scene.start is None or not before:
        return set()
    gaps = scene.start.gaps_cm(set(before.values()))
    return {i for i, old in before.items() if old in gaps and _floats(gaps[old], threshold_cm)}


def _check_collisions(bench: Workbench, arguments: Arguments) -> ToolResult:
    tolerance = float(arguments.get("touch_tolerance_cm", TOUCH_TOLERANCE_CM))
    scene = bench.measured()
    actors = scene.actors
    wanted = arguments.get("actor_names")
    chosen = None if wanted is None else _chosen(actors, wanted)
    pairs: list[Row] = []
    stood: list[Row] = []
    contacts = scene_contacts(scene.snapshot, scene.bodies, minimum_depth_cm=tolerance, actors=chosen)
    for contact in sorted(contacts, key=lambda contact: -contact.depth_cm):
        row = {
            "a": _label(actors[contact.a_index]),
            "b": _label(actors[contact.b_index]),
            "depth_cm": round(contact.depth_cm, 2),
            "trusted": contact.trusted,
        }
        (pairs if {contact.a_index, contact.b_index} & scene.changed else stood).append(row)
    told: Row = {"count": len(pairs), "touch_tolerance_cm": tolerance}
    if scene.start is not None:
        told["stood_so_at_start"] = _stood("pairs", stood)
    return ToolResult(told | _listed(pairs=pairs))


ACTORS = names("Labels or object names (default: all actors).") | {"minItems": 1, "maxItems": 5000}

TOOLS = (
    Tool(
        "take_screenshot",
        GROUP,
        f"A {WIDTH} x {HEIGHT} picture of the viewport. Its camera is set in Python: "
        "`unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem)"
        ".set_level_viewport_camera_info(location, rotation)`.",
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
        "actors at fault, and the extent of the scene. In a repair the rates and lists are of what was changed; what "
        "stood so at the start is summed.",
        _measure,
    ),
    Tool(
        "check_floating",
        GROUP,
        "Actors that hang further above the next surface than a threshold, with the "
        "gap; and those that the physics score counts as floating by its own rule. In a repair what was not changed "
        "and floated at the start is summed apart.",
        _check_floating,
        {
            "actor_names": ACTORS,
            "threshold_cm": number(f"Largest gap that counts as standing (default {GAP_CM:g} cm).", minimum=0),
        },
    ),
    Tool(
        "check_collisions",
        GROUP,
        "Pairs of actors that overlap, with the depth. In a repair pairs that were not changed are summed apart.",
        _check_collisions,
        {
            "actor_names": ACTORS,
            "touch_tolerance_cm": number(
                f"Overlap that still counts as touching (default {TOUCH_TOLERANCE_CM:g} cm).", minimum=0
            ),
        },
    ),
)
