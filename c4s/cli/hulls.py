"""The options that choose how collision is made of meshes."""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

import typer

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
