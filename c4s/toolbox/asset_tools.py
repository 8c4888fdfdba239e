"""Asset discovery: search, categories, metadata and previews of the case's catalog."""

from __future__ import annotations

from c4s.toolbox.tool import Arguments, Tool, ToolRefused, ToolResult, names, text
from c4s.toolbox.workbench import Workbench

GROUP = "Asset discovery"
DEFAULT_RESULTS, MOST_RESULTS = 10, 100


def _search(bench: Workbench, arguments: Arguments) -> ToolResult:
    category = arguments.get("category")
    known = [entry["category"] for entry in bench.catalog.categories()]
    if category is not None and category.casefold() not in map(str.casefold, known):
        raise ToolRefused(f"no category {category!r}; the catalog has {', '.join(known)}")
    found = bench.catalog.search(arguments["query"], category=category, limit=arguments.get("k", DEFAULT_RESULTS))
    return ToolResult({"assets": found, "count": len(found)})


def _categories(bench: Workbench, _: Arguments) -> ToolResult:
    return ToolResult({"categories": bench.catalog.categories()})


def _metadata(bench: Workbench, arguments: Arguments) -> ToolResult:
    found, missing = [], []
    for key in arguments["ids"]:
        try:
            found.append(bench.catalog.find(key).metadata())
        except ToolRefused as refusal:
            missing.append({"id": key, "error": refusal.line()})
    if not found:
        raise ToolRefused("; ".join(item["error"] for item in missing))
    return ToolResult({"assets": found, "missing": missing})


def _preview(bench: Workbench, arguments: Arguments) -> ToolResult:
    entry = bench.catalog.find(arguments["id"])
    if entry.asset.preview is None:
        raise ToolRefused(f"{entry.asset.id} has no preview picture")
    return ToolResult({"id": entry.asset.id, "name": entry.asset.name},
                      image=(entry.folder / entry.asset.preview).read_bytes())


TOOLS = (
    Tool("search_assets", GROUP, "Search this case's asset catalog in plain words. Gives matching assets, best first, "
         "with id, description, tags, size in metres and the path to spawn by.", _search,
         {"query": text("What to look for, in plain words."), "category": text("Only assets of this category."),
          "k": {"type": "integer", "minimum": 1, "maximum": MOST_RESULTS,
                "description": f"How many results at most (default {DEFAULT_RESULTS})."}}, ("query",)),
    Tool("get_categories", GROUP, "List the categories of this case's catalog with their size and a short text.",
         _categories),
    Tool("get_asset_metadata", GROUP, "Category, description, tags, size in metres and spawn path of assets.",
         _metadata, {"ids": {**names("Asset ids or paths."), "minItems": 1, "maxItems": 200}}, ("ids",)),
    Tool("get_asset_preview", GROUP, "A preview picture of one asset, where there is one.", _preview,
         {"id": text("Asset id or path.")}, ("id",)),
)
