"""The collision of a thing of an imported scene: what the scene states, unless that is far from what is to be seen.

A simulator's author may state a box around a table and a cylinder around a chair: in a still scene nobody notices that
they overlap. With the automatic choice bodies in which a free place lies deeper than the tolerance of contacts make
way for those that the mesh itself tells.
"""

from __future__ import annotations

from c4s.protocol.rules import FIXED_TOLERANCE_CM
from c4s.records.pack import CollisionBody
from catalog.ingest.automatic import is_tight
from catalog.ingest.collision import AssetCollision, How, made_bodies
from catalog.ingest.excess import corners_of, free_depth_cm
from catalog.ingest.hulls import joined
from catalog.ingest.surface import SourcePart
from catalog.ingest.surfaces import pieces


def scene_collision(parts: list[SourcePart], stated: list[CollisionBody], how: How) -> AssetCollision:
    """The bodies of a thing with these parts, of which its scene states ``stated``."""
    if stated and how != "auto":
        return AssetCollision(parts, stated, "authored")
    made, source, notes = made_bodies(parts, how)
    if not stated:
        return AssetCollision(parts, made, source, notes)
    mesh = joined([(part.node, part.vertices, part.faces) for part in parts])
    full = [piece.points for piece in pieces(*mesh) if piece.hull is not None and piece.volume > 0 and is_tight(piece)]
    free = free_depth_cm(stated, [*full, *(corners_of(body) for body in made)])
    if free <= FIXED_TOLERANCE_CM:
        return AssetCollision(parts, stated, "authored")
    told = f"its stated collision is {free:.0f} cm deep where nothing is to be seen: made from its triangles"
    return AssetCollision(parts, made, source, [*notes, told])
