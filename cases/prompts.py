"""The prompts that agents read: the fixed wording of repair cases, and the parts of a text-to-scene prompt."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from c4s.records.pack import Asset
from c4s.records.suite import Budget


def repair_prompt(environment: Literal["indoor", "outdoor"], views: int) -> str:
    """The instruction of an image-to-scene case with ``views`` reference pictures."""
    evidence = "the reference picture" if views == 1 else f"the {views} reference pictures"
    return (
        f"This {environment} level was changed from its original. Restore it to what {evidence} "
        f"{'shows' if views == 1 else 'show'}. Change as little as you can: actors and properties that already "
        "agree with the original must stay exactly as they are."
    )


def palette_line(asset: Asset) -> str:
    """``- id | name | category | WxDxH m | spawn path``: sizes in metres, at most two decimals."""
    size = "x".join(str(round(side, 2)) for side in asset.size_m)
    return f"- {asset.id} | {asset.name} | {asset.category} | {size} m | {asset.spawn_path}"


def ground_block(tiles: Sequence[Asset], plate_m: float) -> str:
    """The optional ground part: which flat tiles can carpet the plate."""
    lines = [
        f"The plate is bare: without a floor everything hangs over nothing. Call `ground_pass` before anything "
        f"else to carpet the whole {plate_m:g} m plate,",
        "or lay these flat tiles edge to edge yourself:",
        "",
    ]
    for tile in tiles:
        width, depth, height = tile.size_m
        name = tile.path.rsplit(".", 1)[-1]
        lines.append(f"  - {name} | {width:.1f}x{depth:.1f}x{height:.2f} m | {tile.spawn_path}")
    return "\n".join(["    === GROUND ===", *(f"    {line}".rstrip() for line in lines)])


def palette_block(assets: Sequence[Asset]) -> str:
    """The catalog of a text-to-scene case, sorted by category, then id."""
    rows = [palette_line(asset) for asset in sorted(assets, key=lambda a: (a.category, a.id))]
    return "\n".join(
        [
            "=== ASSET PALETTE ===",
            "These assets are the whole library of this case; there is no search beyond them. Use any of them as",
            "often as you like and leave out what you do not need. Scene graphs name an asset by its id, the engine",
            "by its spawn path. A line reads",
            "",
            "  id | name | category | width x depth x height (m) | spawn path",
            "",
            *rows,
        ]
    )


def task_block(plate_m: float, budget: Budget) -> str:
    """What to do, and with how much."""
    return "\n".join(
        [
            "=== THE TASK ===",
            f"Build the described place on the {plate_m:g} m x {plate_m:g} m plate, as dense and as ordered as the "
            "text",
            f"says, and save it. You have {budget.tool_calls} tool calls and {budget.wall_minutes:g} minutes; every "
            "tool",
            "result says how much is left. You need not use it all: stop when the scene is what the text describes.",
        ]
    )


def text_prompt(
    description: str, ground: Sequence[Asset], assets: Sequence[Asset], plate_m: float, budget: Budget
) -> str:
    """A whole text-to-scene prompt; it starts with ``description``."""
    parts = [description] + ([ground_block(ground, plate_m)] if ground else [])
    return "\n\n".join([*parts, palette_block(assets), task_block(plate_m, budget)])
