"""Planning: the deterministic scene-graph planner as tools. The last solution is kept, so it need not be sent again."""

from __future__ import annotations

from types import ModuleType
from typing import Any

from c4s.toolbox.pictures import within_limit
from c4s.toolbox.refusal import ToolRefused
from c4s.toolbox.scene_tools import spawn_path
from c4s.toolbox.size import ANSWER_SIZE, AROUND, side_by_side
from c4s.toolbox.tool import LOCATION, ROTATION, SCALE, Arguments, Schema, Tool, ToolResult, label, number, text
from c4s.toolbox.workbench import Workbench

GROUP = "Planning"
DEFAULT_HALF_EXTENT_M = 100.0
MOST_ENTRIES = 5000
BATCH = 500
"""Entries that one engine call spawns."""
ROOM = ANSWER_SIZE - AROUND


def _planner() -> ModuleType:
    from c4s import planner

    return planner


def _half_extent(bench: Workbench, arguments: Arguments) -> float:
    plate = bench.case.plate_m
    return float(arguments.get("half_extent_m", plate / 2 if plate else DEFAULT_HALF_EXTENT_M))


def _validate(bench: Workbench, arguments: Arguments) -> ToolResult:
    report = _planner().validate(arguments["graph"], bench.catalog.assets, _half_extent(bench, arguments))
    counts = {"problem_count": len(report["problems"]), "dropped_count": len(report["dropped"])}
    return ToolResult(report | counts | side_by_side({key: report[key] for key in ("dropped", "problems")}, ROOM))


def _solve(bench: Workbench, arguments: Arguments) -> ToolResult:
    try:
        solved = _planner().solve(
            arguments["graph"],
            bench.catalog.assets,
            mode=arguments.get("mode", "separate"),
            half_extent_m=_half_extent(bench, arguments),
        )
    except ValueError as error:
        raise ToolRefused(str(error)) from error
    bench.solved = solved
    lists = {key: value for key, value in solved.items() if isinstance(value, list)}
    shown = solved | side_by_side(lists, ROOM)
    told: dict[str, Any] = {"solved": shown, "total": len(solved["entries"]), "shown": len(shown["entries"])}
    if told["shown"] < told["total"]:
        told["hint"] = "the whole solution is kept: leave `solved` out of render_plan, tier_derivation and build_tier"
    return ToolResult(told)


def _solved(bench: Workbench, arguments: Arguments) -> dict[str, Any]:
    solved = arguments.get("solved", bench.solved)
    if solved is None:
        raise ToolRefused("no solved plan yet", todo="call solve_scene_graph first, or give `solved`")
    if not isinstance(solved.get("entries"), list):
        raise ToolRefused("`solved` has no list of entries", todo="give what solve_scene_graph gave")
    return dict(solved)


def _with_solved(bench: Workbench, arguments: Arguments, function: str) -> Any:
    solved = _solved(bench, arguments)
    try:
        return getattr(_planner(), function)(solved)
    except (AttributeError, LookupError, ArithmeticError, TypeError, ValueError) as error:
        raise ToolRefused(f"`solved` is not what solve_scene_graph gives: {error!r}") from error


def _render(bench: Workbench, arguments: Arguments) -> ToolResult:
    return ToolResult(
        {"entries": len(_solved(bench, arguments)["entries"])}, image=_with_solved(bench, arguments, "render_plan")
    )


def _tiers(bench: Workbench, arguments: Arguments) -> ToolResult:
    named = _with_solved(bench, arguments, "tiers")
    counts = {tier: len(members) for tier, members in named["tiers"].items()}
    return ToolResult(named | {"counts": counts, "tiers": side_by_side(named["tiers"], ROOM)})


def _ground(bench: Workbench, arguments: Arguments) -> ToolResult:
    from c4s.toolbox.ground import choose_ground

    chosen = choose_ground(arguments["scene_text"], bench.catalog.entries)
    asset = chosen.entry.asset
    tiles = _planner().ground_tiles(asset, _half_extent(bench, arguments))
    built = _spawn_entries(bench, tiles)
    laid = {
        "id": asset.id,
        "name": asset.name,
        "description": asset.description,
        "spawn_path": asset.spawn_path,
        "tile_m": [round(tiles[0]["scale"][0] * side, 3) for side in asset.size_m[:2]],
        "why": chosen.why,
        "other_grounds": chosen.others,
    }
    picture = chosen.entry.preview()
    return ToolResult({"laid": laid} | built.data, image=None if picture is None else within_limit(picture))


def _spawn_entries(bench: Workbench, entries: list[dict[str, Any]]) -> ToolResult:
    resolved, failed = [], []
    for entry in entries:
        try:
            path = spawn_path(bench, str(entry["asset"]))
        except ToolRefused as refusal:
            failed.append({"entry": str(entry["name"]), "error": refusal.line()})
            continue
        kind = entry.get("kind") or ("blueprint" if path.endswith("_C") else "static_mesh")
        resolved.append({**entry, "asset": path, "kind": kind})
    spawned: list[str] = []
    for start in range(0, len(resolved), BATCH):
        outcome = bench.scene("spawn_many", entries=resolved[start : start + BATCH])
        spawned += [item["label"] for item in outcome["spawned"]]
        failed += outcome["failed"]
    if failed and not spawned:
        raise ToolRefused(f"none of {len(entries)} entries was spawned; the first: {failed[0]['error']}")
    return ToolResult(
        {
            "count": len(spawned),
            "failed_count": len(failed),
            **side_by_side({"failed": failed, "spawned": spawned}, ROOM),
        }
    )


def _build(bench: Workbench, arguments: Arguments) -> ToolResult:
    if "entries" in arguments:
        return _spawn_entries(bench, list(arguments["entries"]))
    if "tier" not in arguments:
        raise ToolRefused("give a tier of the solved plan, or entries")
    solved, tier = _solved(bench, {}), arguments["tier"]
    named = _with_solved(bench, {}, "tiers")
    order = named["order"]
    wanted = order[tier] if isinstance(tier, int) and 0 <= tier < len(order) else tier
    if wanted not in named["tiers"]:
        raise ToolRefused(f"no tier {tier!r}; the tiers are {', '.join(order)} (or 0 to {len(order) - 1})")
    members = set(named["tiers"][wanted])
    return _spawn_entries(bench, [entry for entry in solved["entries"] if entry["name"] in members])


SOLVED: Schema = {"type": "object", "description": "What solve_scene_graph gave; left out: the last solution."}
HALF_EXTENT = number(
    "Half the side of the square build area in metres (default: half the case's plate).",
    exclusiveMinimum=0,
    maximum=10_000,
)
GRAPH: Schema = {
    "type": "object",
    "description": (
        '{"nodes": [node, ...]}. A node: id, asset (catalog id or path); at [x, y] or [x, y, z of the bottom] in '
        "metres from the plate's centre; yaw_deg; scale; count with layout {kind: row|grid|ring|scatter, spacing_m, "
        "radius_m, yaw_deg, facing: same|centre}; on (id of an earlier node that it stands on); relation {kind: "
        "next_to|left_of|right_of|in_front_of|behind|around, of, distance_m}."
    ),
}
ENTRY: Schema = {
    "type": "object",
    "required": ["name", "asset", "location"],
    "properties": {
        "name": label("Label."),
        "asset": text("Catalog id or path."),
        "location": LOCATION,
        "rotation": ROTATION,
        "scale": SCALE,
    },
}

TOOLS = (
    Tool(
        "validate_scene_graph",
        GROUP,
        "Check a scene graph against the catalog: whether it can be solved whole, and "
        "every entry that would be dropped with the reason.",
        _validate,
        {"graph": GRAPH},
        ("graph",),
    ),
    Tool(
        "solve_scene_graph",
        GROUP,
        "World transforms for a scene graph; overlapping footprints are pushed apart. "
        "Equal input gives equal output. The solution is kept for the other planning tools.",
        _solve,
        {
            "graph": GRAPH,
            "mode": {
                "enum": ["separate", "exact"],
                "description": "separate (default): push overlaps apart. exact: keep them.",
            },
            "half_extent_m": HALF_EXTENT,
        },
        ("graph",),
    ),
    Tool("render_plan", GROUP, "A picture of the solved plan seen from above.", _render, {"solved": SOLVED}),
    Tool("tier_derivation", GROUP, "The build tier of every placed entry.", _tiers, {"solved": SOLVED}),
    Tool(
        "ground_pass",
        GROUP,
        "Lay tiles of the catalog's ground that fits the scene best over the build area, tops at z = 0. Tells what was "
        "laid, why, and the other grounds, with a picture of the tile; refused where no ground fits.",
        _ground,
        {
            "scene_text": text("The scene in words: decides which ground fits.", maxLength=20_000),
            "half_extent_m": HALF_EXTENT,
        },
        ("scene_text",),
    ),
    Tool(
        "build_tier",
        GROUP,
        "Spawn one tier of the solved plan, or a list of entries, in one call. Entries that fail "
        "are reported and the rest are built.",
        _build,
        {
            "tier": {
                "type": ["string", "integer"],
                "description": "Tier name, or its number in building order from 0.",
            },
            "entries": {
                "type": "array",
                "items": ENTRY,
                "minItems": 1,
                "maxItems": MOST_ENTRIES,
                "description": "Entries {name, asset, location, rotation, scale} in place of a tier.",
            },
        },
    ),
)
