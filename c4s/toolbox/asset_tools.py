"""Asset discovery: search, categories, metadata and previews of the case's catalog."""

from __future__ import annotations

from c4s.toolbox.pictures import within_limit
from c4s.toolbox.refusal import ToolRefused
from c4s.toolbox.size import ANSWER_SIZE, AROUND, rows_that_fit, side_by_side
from c4s.toolbox.tool import Arguments, Tool, ToolResult, names, page, paged, text
from c4s.toolbox.workbench import Workbench

GROUP = "Asset discovery"
DEFAULT_RESULTS, MOST_RESULTS = 10, 100


def _search(bench: Workbench, arguments: Arguments) -> ToolResult:
    category = arguments.get("category")
    known = [entry["category"] for entry in bench.catalog.categories()]
    if category is not None and category.casefold() not in map(str.casefold, known):
        raise ToolRefused(f"no category {category!r}; the catalog has {', '.join(known)}")
    ranked = bench.catalog.ranked(arguments["query"], category=category)
    offset = arguments.get("offset", 0)
    rows = [
        entry.metadata() | {"score": round(score, 3)}
        for entry, score in ranked[offset : offset + arguments.get("k", DEFAULT_RESULTS)]
    ]
    told = paged("assets", rows, len(ranked), offset)
    hint = {} if ranked else {"hint": "nothing fits: try other words, or see get_categories"}
    return ToolResult(told | hint)


def _categories(bench: Workbench, _: Arguments) -> ToolResult:
    """All categories; the largest ones without their texts, where an answer does not hold them all."""
    found = bench.catalog.categories()
    kept = rows_that_fit(found, ANSWER_SIZE - AROUND)
    if len(kept) == len(found):
        return ToolResult({"categories": kept})
    brief = [{"category": row["category"], "count": row["count"]} for row in found]
    kept = rows_that_fit(sorted(brief, key=lambda row: -row["count"]), ANSWER_SIZE - AROUND)
    return ToolResult({"categories": kept, "total": len(found), "hint": "the largest; search_assets finds in all"})


def _metadata(bench: Workbench, arguments: Arguments) -> ToolResult:
    found, missing = [], []
    for key in arguments["ids"]:
        try:
            found.append(bench.catalog.find(key).metadata())
        except ToolRefused as refusal:
            missing.append({"id": key, "error": refusal.line()})
    if not found:
        raise ToolRefused("; ".join(item["error"] for item in missing))
    kept = side_by_side({"assets": found, "missing": missing}, ANSWER_SIZE - AROUND)
    left = len(found) - len(kept["assets"])
    hint = {"left_out": left, "hint": f"ask again for the last {left} ids that were found"} if left else {}
    return ToolResult(kept | hint)


def _preview(bench: Workbench, arguments: Arguments) -> ToolResult:
    entry = bench.catalog.find(arguments["id"])
    picture = entry.preview()
    if picture is None:
        raise ToolRefused(
            f"{entry.asset.id} has no preview picture", todo="its size and description are in get_asset_metadata"
        )
    return ToolResult({"id": entry.asset.id, "name": entry.asset.name}, image=within_limit(picture))


TOOLS = (
    Tool(
        "search_assets",
        GROUP,
        "Search this case's asset catalog by meaning, in plain words: what a thing is called, "
        "what kind it is, or what it is for. Gives matching assets, best first, with id, description, tags, size in "
        "metres and the path to spawn by.",
        _search,
        {
            "query": text("What to look for, in plain words: `red chair`, `something to sit on`.", maxLength=500),
            "category": text("Only assets of this category."),
            "k": {
                "type": "integer",
                "minimum": 1,
                "maximum": MOST_RESULTS,
                "description": f"How many results at most (default {DEFAULT_RESULTS}).",
            },
            "offset": page(DEFAULT_RESULTS, MOST_RESULTS)["offset"],
        },
        ("query",),
    ),
    Tool(
        "get_categories",
        GROUP,
        "List the categories of this case's catalog with their size and a short text.",
        _categories,
        instant=True,
    ),
    Tool(
        "get_asset_metadata",
        GROUP,
        "Category, description, tags, size in metres and spawn path of assets.",
        _metadata,
        {"ids": {**names("Asset ids or paths."), "minItems": 1, "maxItems": 200}},
        ("ids",),
    ),
    Tool(
        "get_asset_preview",
        GROUP,
        "A preview picture of one asset, where there is one.",
        _preview,
        {"id": text("Asset id or path.")},
        ("id",),
    ),
)
