"""False penetrations in scenes that people made: what the physics verifier says against the triangles themselves.

``python -m bench.penetration FILE ... [--hulls HOW ...] [--misses] [--json]`` imports each scene file (SDF world, node
tree, placement table) with each way of making collision and prints a row for each; ``--home FOLDER`` measures the
scenes that were imported into that ``C4S_HOME``. An actor penetrates falsely when the verifier says that it sinks into
others by more than its tolerance, and its triangles truly do so into none of them (``bench/mesh_truth.py``, which knows
nothing of collision bodies). With ``--misses`` pairs are counted whose triangles do and of which it says nothing.
"""

from __future__ import annotations

import argparse
import copy
import json
import tempfile
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, get_args

import numpy as np
import shapely

from bench.mesh_truth import WorldTriangles, penetrates, world_triangles
from c4s.packs.store import PackStore
from c4s.protocol.settings import INDOOR_REPAIR
from c4s.records.level import Level
from c4s.verify.physics.verdict import verify_physics
from cases.importers.importing import import_scene
from cases.standing import ASIDE_CM, snapshot_of
from catalog.ingest.collision import How

TOLERANCE_CM = 5.0


@dataclass
class PenetrationRow:
    """One scene with one way of making collision."""

    scene: str
    hulls: str
    actors: int
    """Scored solids."""
    bodies: int
    said: int
    """Actors that the verifier says penetrate."""
    false: int
    missed: int | None
    import_s: float
    contacts_s: float
    pairs: list[dict[str, Any]] = field(default_factory=list)
    """Of each false actor: its contacts beyond the tolerance."""

    @property
    def rate(self) -> float:
        """False actors by scored solids."""
        return self.false / self.actors if self.actors else 0.0


def measured(level: Level, packs: Sequence[Path], *, misses: bool = False) -> dict[str, Any]:
    """What the verifier says of an original, held against its triangles."""
    snapshot = snapshot_of(level, packs)
    aside = copy.deepcopy(snapshot)
    for actor in aside["actors"]:
        actor["transform"]["location_cm"][0] += ASIDE_CM
    begin = time.process_time()
    leaf = verify_physics(INDOOR_REPAIR, snapshot, aside, alone=True).measurements["leaf_results"][1]
    spent = time.process_time() - begin
    names = {str(actor.get("name") or actor.get("label")): i for i, actor in enumerate(snapshot["actors"])}
    store, meshes = PackStore(packs), snapshot["c4s"]["meshes"]
    kept: dict[int, WorldTriangles | None] = {}

    def triangles(index: int) -> WorldTriangles | None:
        if index not in kept:
            kept[index] = world_triangles(snapshot["actors"][index], store, meshes)
        return kept[index]

    truth: dict[tuple[int, int], bool] = {}

    def true(i: int, j: int) -> bool:
        key = min(i, j), max(i, j)
        if key not in truth:
            a, b = triangles(key[0]), triangles(key[1])
            truth[key] = a is not None and b is not None and penetrates(a, b, TOLERANCE_CM)
        return truth[key]

    false = []
    for row in leaf["violations"]:
        found = [one for one in row["contacts"] if one["trusted"] and one["depth_cm"] > row["tolerance_cm"]]
        if not any(true(names[row["actor"]], names[one["actor"]]) for one in found):
            false.append({"actor": row["actor"], "contacts": [[one["actor"], one["depth_cm"]] for one in found]})
    said = {
        frozenset((names[row["actor"]], names[one["actor"]])) for row in leaf["violations"] for one in row["contacts"]
    }
    scored = {names[row["actor"]] for row in leaf["actors"]}
    missed = None
    if misses:
        missed = sum(true(i, j) for i, j in _near(scored, triangles) if frozenset((i, j)) not in said)
    return {
        "actors": leaf["evaluated"],
        "said": len(leaf["violations"]),
        "false": len(false),
        "missed": missed,
        "contacts_s": round(spent, 3),
        "bodies": sum(
            len(meshes.get(part.get("mesh"), {}).get("collision", []))
            for actor in snapshot["actors"]
            for part in (actor.get("c4s") or {}).get("components") or []
        ),
        "pairs": false,
    }


def _near(scored: set[int], triangles: Any) -> list[tuple[int, int]]:
    """Pairs of actors whose boxes overlap by more than the tolerance."""
    have = [(i, triangles(i)) for i in sorted(scored)]
    have = [(i, one) for i, one in have if one is not None]
    low, high = np.array([one.low for _, one in have]), np.array([one.high for _, one in have])
    boxes = shapely.box(low[:, 0], low[:, 1], high[:, 0], high[:, 1])
    a, b = shapely.STRtree(boxes).query(boxes)
    keep = (a < b) & (np.minimum(high[a] - low[b], high[b] - low[a]).min(axis=1) > TOLERANCE_CM)
    return [(have[i][0], have[j][0]) for i, j in zip(a[keep].tolist(), b[keep].tolist(), strict=True)]


def of_home(home: Path, *, misses: bool = False) -> list[PenetrationRow]:
    """The imported scenes of a ``C4S_HOME``."""
    return [
        PenetrationRow(
            scene=path.parent.name,
            hulls="as imported",
            import_s=0.0,
            **measured(Level.read(path), [home / "packs" / path.parent.name], misses=misses),
        )
        for path in sorted((home / "suites").glob("*/scene.level.json"))
    ]


def of_file(file: Path, hulls: How, *, misses: bool = False) -> PenetrationRow:
    """A scene file, imported with one way of making collision."""
    with tempfile.TemporaryDirectory(prefix="c4s-penetration-") as scratch:
        home, begin = Path(scratch), time.perf_counter()
        report = import_scene(file, "scene", suites=home / "suites", packs=home / "packs", hulls=hulls)
        spent = time.perf_counter() - begin
        found = measured(Level.read(Path(report["level"])), [home / "packs" / "scene"], misses=misses)
    return PenetrationRow(scene=file.stem, hulls=hulls, import_s=round(spent, 1), **found)


def main() -> None:
    """Command line of the benchmark."""
    parser = argparse.ArgumentParser(prog="python -m bench.penetration", description=__doc__)
    parser.add_argument("files", nargs="*", type=Path, metavar="FILE")
    parser.add_argument("--hulls", action="append", choices=get_args(How), help="repeatable; asset, piece and auto")
    parser.add_argument("--home", type=Path, help="measure the scenes imported there")
    parser.add_argument("--misses", action="store_true", help="count what the verifier misses too")
    parser.add_argument("--json", action="store_true", help="all of it, each false actor with its contacts")
    given = parser.parse_args()
    rows = of_home(given.home, misses=given.misses) if given.home else []
    for file in given.files:
        rows += [of_file(file, how, misses=given.misses) for how in given.hulls or ("asset", "piece", "auto")]
    if given.json:
        print(json.dumps([asdict(row) for row in rows], indent=1))
        return
    titles = ("actors", "bodies", "said", "false", "rate", "missed", "import s")
    print(f"{'scene':28} {'hulls':12} " + " ".join(f"{title:>{max(7, len(title))}}" for title in titles))
    for row in rows:
        missed = "-" if row.missed is None else row.missed
        print(
            f"{row.scene:28.28} {row.hulls:12} {row.actors:7} {row.bodies:7} {row.said:7} {row.false:7} "
            f"{row.rate:7.1%} {missed:>7} {row.import_s:8.1f}"
        )


if __name__ == "__main__":
    main()
