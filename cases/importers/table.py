"""A placement table (CSV) of mesh files as a scene.

Columns ``actor`` and ``asset`` (a mesh file relative to the table), and either ``x,y,z,roll,pitch,yaw`` (right-handed,
Z up, units of the table, radians about fixed axes) or ``grid_x,grid_z,yaw_degrees_about_y`` (cells, Y up).
"""

from __future__ import annotations

import csv
import io
from pathlib import Path

import numpy as np

from c4s.errors import BadInput
from c4s.files import read_plain_text
from c4s.names import file_in
from cases.importers.imported import ImportedScene, Matrix, SceneActor, SceneAsset
from cases.importers.sdf_frames import numbers, rigid
from cases.importers.sdf_shapes import to_unreal
from catalog.ingest.source import read_source

WORLD = ("x", "y", "z", "roll", "pitch", "yaw")
GRID = ("grid_x", "grid_z", "yaw_degrees_about_y")


def read_table(path: Path, *, scale: float = 1.0) -> ImportedScene:
    """Read a placement table; ``scale`` is metres per unit of the table and of its meshes.

    Raises ``BadInput`` when a column is missing; rows that cannot be placed are named in ``skipped``.
    """
    try:
        rows = list(csv.DictReader(io.StringIO(read_plain_text(path, "table"), newline="")))
    except csv.Error as error:
        raise BadInput(f"this table is not CSV: {error}", where=str(path)) from None
    columns = set(rows[0]) if rows else set()
    form = WORLD if columns.issuperset(WORLD) else GRID
    missing = [name for name in ("actor", "asset", *form) if name not in columns]
    if missing:
        raise BadInput(
            f"the table has no column {missing[0]!r}",
            where=str(path),
            todo=f"it needs actor, asset and {', '.join(WORLD)} or {', '.join(GRID)}",
        )
    scene = ImportedScene()
    for row in rows:
        try:
            place = numbers(" ".join(row[name] or "" for name in form), len(form))
            asset = row["asset"] or ""
            if asset not in scene.assets:
                source = read_source(file_in(path.parent, asset), path.parent, scale=scale)
                scene.assets[asset] = SceneAsset(Path(asset).stem, source.parts)
                for text in source.notes:
                    scene.note(asset, text)
            scene.actors.append(SceneActor(row["actor"] or "", asset, _matrix(place, form, scale)))
        except BadInput as error:
            scene.skip(row["actor"] or "", error.line())
    return scene


def _matrix(place: list[float], form: tuple[str, ...], scale: float) -> Matrix:
    matrix = (
        rigid(place[:3], place[3:]) if form == WORLD else rigid([place[0], -place[1], 0], [0, 0, np.radians(place[2])])
    )
    turned = to_unreal(matrix)
    turned[:3, 3] *= scale
    return turned
