"""What of a carved thing is a thing of its own is the same whether all of its points are looked at or few."""

from __future__ import annotations

import os
import random
from pathlib import Path

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

from cases.open190.slots import VARIABLE
from cases.zeroad import things
from cases.zeroad.archive import Archive
from cases.zeroad.shapes import ActorShape, Shapes
from cases.zeroad.things import ActorPiece, split
from catalog.ingest.surface import SourcePart, Surface

INSTALLED = Path(os.environ.get(VARIABLE, "/")) / "usr/share/games/0ad/mods/public/public.zip"
Row = tuple[str, tuple[float, ...], int]


def rows(pieces: list[ActorPiece]) -> list[Row]:
    """Name, box and number of faces of each piece."""
    return [
        (piece.name, tuple(np.concatenate(piece.box).round(3).tolist()), sum(len(part.faces) for part in piece.parts))
        for piece in pieces
    ]


def read_twice(monkeypatch: pytest.MonkeyPatch, shapes: list[ActorShape]) -> tuple[list[Row], list[Row], int]:
    """The pieces by few points and by all of them, and how many points the few are fewer."""
    thinned, spared = things._thinned, []

    def counted(points: NDArray[np.float64], cell_cm: float) -> NDArray[np.float64]:
        few = thinned(points, cell_cm)
        spared.append(len(points) - len(few))
        return few

    monkeypatch.setattr(things, "_thinned", counted)
    few = rows(split("carved", shapes))
    monkeypatch.setattr(things, "_thinned", lambda points, _cell_cm: points)
    return few, rows(split("carved", shapes)), sum(spared)


def ball(radius_cm: float, *middle: float) -> SourcePart:
    """A ball of 1,280 faces, with six corners or five at each of its points."""
    mesh = trimesh.creation.icosphere(subdivisions=3, radius=radius_cm)
    points = np.asarray(mesh.vertices) + middle
    return SourcePart(
        "body", Surface("plain"), points, np.asarray(mesh.faces), np.asarray(mesh.vertex_normals), points[:, :2]
    )


def test_carved_balls_fall_into_the_pieces_that_all_their_points_tell(monkeypatch: pytest.MonkeyPatch) -> None:
    near, apart = 60.0 + 8.0, 60.0 + 8.0 + 60.0 + 24.0
    shapes = [ActorShape("ball", ball(30.0, east, 0.0, 30.0)) for east in (0.0, near, apart, apart + 500.0)]
    few, all_of_them, spared = read_twice(monkeypatch, shapes)
    assert few == all_of_them
    assert [count for _, _, count in few] == [2 * 1280, 1280, 1280]
    assert spared > 10_000


@pytest.mark.skipif(not INSTALLED.is_file(), reason="0ad-data is not installed, nor unpacked where C4S_SLOTS says")
@pytest.mark.parametrize(
    ("actor", "count"), [("props/structures/celts/market_props_1.xml", 23), ("structures/iberians/market.xml", 15)]
)
def test_a_mesh_of_the_game_falls_into_the_pieces_that_all_its_points_tell(
    actor: str, count: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    with Archive(INSTALLED) as archive:
        shapes = Shapes(archive).of(actor, random.Random(f"{actor}|0"))
    few, all_of_them, spared = read_twice(monkeypatch, shapes)
    assert few == all_of_them
    assert len(few) == count and spared > 0
