"""The options of what comes in: how collision is made of meshes, and which file tells the licence."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any, Literal, TypeAlias

import typer

from c4s.cli.output import say

Hulls: TypeAlias = Annotated[
    Literal["auto", "asset", "node", "piece", "panels", "decompose", "none"],
    typer.Option(
        help="collision where a file brings none: what the surface tells (auto), one convex hull an asset, a node of "
        "its file or a connected piece, thin panels, convex parts (coacd; slow once), or none"
    ),
]
HullsOf: TypeAlias = Annotated[
    list[str] | None, typer.Option(help="another choice for some files, once for each: 'bench*=decompose'")
]
LicenceFile: TypeAlias = Annotated[
    Path | None,
    typer.Option(
        "--license-file",
        help="file that tells the licence; sought beside the meshes, above, and in their Debian package when left out",
    ),
]


def say_excess(rows: Sequence[dict[str, Any]]) -> None:
    """The assets whose bodies hold most beyond their mesh, in one line."""
    if rows:
        named = ", ".join(f"{row['asset']} ({row['bodies_l']:.3g} l for {row['mesh_l']:.3g} l)" for row in rows)
        say(f"collision holds more than the mesh: {named}")
