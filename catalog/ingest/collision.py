"""The collision of an asset: what its file brings, else what is made of its triangles in the way that was chosen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fnmatch import fnmatch
from pathlib import Path
from typing import Literal, get_args

from c4s.errors import BadInput
from c4s.records.pack import CollisionBody
from catalog.ingest.authored import split_authored
from catalog.ingest.automatic import automatic
from catalog.ingest.decompose import decompose
from catalog.ingest.hulls import HullPer, bodies, hull, joined
from catalog.ingest.merging import merged
from catalog.ingest.panels import panels
from catalog.ingest.physics_nodes import stated_bodies
from catalog.ingest.surface import SourcePart
from catalog.ingest.surfaces import pieces

How = Literal["auto", "asset", "node", "piece", "panels", "decompose", "none"]
"""What its surface tells, one hull for an asset, one a node, one a connected piece, thin panels, convex parts, or no
collision."""
Source = Literal["authored", "hull", "decomposition", "none"]


@dataclass(frozen=True)
class HullChoice:
    """How collision is made where a file brings none.

    ``of`` are (pattern, how) pairs: the last whose pattern fits a file's path under the folder, or its name, wins.
    """

    default: How = "auto"
    of: tuple[tuple[str, How], ...] = ()

    @classmethod
    def parse(cls, default: How, rules: Sequence[str]) -> HullChoice:
        """From rules as ``bench*=decompose``; ``BadInput`` for one that is none."""
        pairs: list[tuple[str, How]] = []
        for rule in rules:
            pattern, _, how = rule.rpartition("=")
            found = next((one for one in get_args(How) if one == how), None)
            if not pattern or found is None:
                raise BadInput(
                    "not a rule like bench*=decompose",
                    where=f"--hulls-of {rule}",
                    todo=f"write PATTERN=HOW with HOW one of {', '.join(get_args(How))}",
                )
            pairs.append((pattern, found))
        return cls(default, tuple(pairs))

    def plain(self) -> list[object]:
        """As plain data: what a pack was built with."""
        return [self.default, *([pattern, how] for pattern, how in self.of)]

    def how(self, relative: str) -> How:
        """The choice for a file of the folder."""
        fitting = [
            how
            for pattern, how in self.of
            if fnmatch(relative.lower(), pattern.lower()) or fnmatch(Path(relative).stem.lower(), pattern.lower())
        ]
        return fitting[-1] if fitting else self.default


@dataclass(frozen=True)
class AssetCollision:
    """What is shown of a file, its bodies, where they come from, and notes."""

    shown: list[SourcePart]
    bodies: list[CollisionBody]
    source: Source
    notes: list[str] = field(default_factory=list)


def collision_of(path: Path, root: Path, parts: list[SourcePart], how: How, *, scale: float = 1.0) -> AssetCollision:
    """The collision of a read file; ``BadInput`` when it holds collision nodes only, which are never shown."""
    shown, own, notes = split_authored(parts)
    if not shown:
        raise BadInput("the file holds nothing but collision nodes", where=str(path))
    stated, more = stated_bodies(path, root, scale=scale)
    notes += more
    if own or stated:
        return AssetCollision(shown, own + stated, "authored", notes)
    made, source, more = made_bodies(shown, how)
    return AssetCollision(shown, made, source, notes + more)


def made_bodies(parts: list[SourcePart], how: How) -> tuple[list[CollisionBody], Source, list[str]]:
    """Bodies made of triangles, where they come from, and notes."""
    if how == "none":
        return [], "none", []
    triples = [(part.node, part.vertices, part.faces) for part in parts]
    if how == "auto":
        found = automatic(*joined(triples))
        return [hull(points) for points in found.bodies], "decomposition" if found.parts else "hull", found.notes
    if how == "panels":
        thin = [panel for piece in pieces(*joined(triples)) for panel in panels(piece)]
        return [hull(points) for points in merged(thin or [joined(triples)[0]])], "decomposition", []
    if how == "decompose":
        cut, notes = decompose(*joined(triples))
        return [hull(points) for points in cut], "decomposition", notes
    per: HullPer = how
    return list(bodies(triples, per)), "hull", []
