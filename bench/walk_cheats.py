"""``python -m bench.walk_cheats RUN``: ways to a higher Embodied Utility Score, tried on shipped scenes.

RUN is a run folder in which ``oracle`` played; of each of its scenes one truth is taken. Every cheat changes its
snapshot as an agent could, and the verdict is made of it. Printed is a row a scene and cheat: A and EUS before and
after, and the advisory that names the cheat. Exit 1 where A or EUS rises and no advisory does.
"""

from __future__ import annotations

import argparse
import copy
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Final

from c4s.files import read_json
from c4s.navigation import measure_snapshot
from c4s.protocol.baselines import ORACLE
from c4s.records.folder import RunFolder
from c4s.records.navigation import LETTERS, NavigationEvidence
from c4s.records.plan import Plan
from c4s.records.verdict import Verdict
from c4s.verify.navigation.verdict import verify_navigation

BLOCK: Final = "/Game/Cheat/Block.Block"
BODY: Final = [{"kind": "box", "center": [0, 0, 0], "half_extent": [50, 50, 50]}]
Scene = dict[str, Any]


def block(name: str, low: Sequence[float], high: Sequence[float], *, hidden: bool = False) -> dict[str, Any]:
    """An actor that is a box between two corners (cm)."""
    middle = [(a + b) / 2 for a, b in zip(low, high, strict=True)]
    size = [b - a for a, b in zip(low, high, strict=True)]
    transform = {"location_cm": middle, "rotation_deg": [0.0, 0.0, 0.0], "scale": [part / 100 for part in size]}
    kind = "/Script/Engine.StaticMeshComponent"
    part = {"name": "Mesh", "class": kind, "mesh": BLOCK, "collision_enabled": True, "transform": transform}
    return {
        "name": name.replace(" ", ""),
        "label": name,
        "class": "/Script/Engine.StaticMeshActor",
        "asset_path": BLOCK,
        "component_asset_paths": [BLOCK],
        "collision": {"collision_enabled": True},
        "bounds": {"origin_cm": middle, "extent_cm": [part / 2 for part in size]},
        "transform": transform,
        "c4s": {"components": [part], "hidden": hidden},
    }


class CheatGround:
    """A truth, and what its cheats are built around."""

    def __init__(self, snapshot: Mapping[str, Any]) -> None:
        self.snapshot = {
            **snapshot,
            "c4s": {**snapshot["c4s"], "meshes": {**snapshot["c4s"]["meshes"], BLOCK: {"collision": BODY}}},
        }
        self.evidence: NavigationEvidence = measure_snapshot(snapshot)
        pool = [target for target in self.evidence.targets if not target.left]
        falls = [LETTERS[letter] for letter in self.evidence.builds[-1].falls]
        self.lost = {
            target.index for target, fall in zip(pool, falls, strict=True) if fall in ("unreached", "unconnected")
        }
        self.boxes = [target for target in pool if target.index in self.lost]
        end = self.evidence.walks[0].route_cm[0]
        self.x, self.y, self.z = end

    def changed(self, change: Callable[[dict[str, Any]], None], *more: dict[str, Any]) -> Scene:
        """The scene with each actor that is not reached changed, and more actors."""
        actors = copy.deepcopy(list(self.snapshot["actors"]))
        for index in self.lost:
            change(actors[index])
        return {**self.snapshot, "actors": [*actors, *more]}


def _off(actor: dict[str, Any]) -> None:
    actor["collision"]["collision_enabled"] = False
    for part in actor["c4s"]["components"]:
        part["collision_enabled"] = False


def _sky(actor: dict[str, Any]) -> None:
    actor["label"] = f"Sky {actor['label']}"


def _nothing(_: dict[str, Any]) -> None:
    return None


def _small(
    ground: CheatGround, count: int, side: float, step: float, name: str, *, hidden: bool = False
) -> list[Scene]:
    places = [(ground.x + step * (n % 8 - 4), ground.y + step * (n // 8 - count // 16)) for n in range(count)]
    return [
        block(f"{name} {n}", (x, y, ground.z), (x + side, y + side, ground.z + side), hidden=hidden)
        for n, (x, y) in enumerate(places)
    ]


def _slabs(ground: CheatGround, drop: float, thick: float, name: str) -> list[Scene]:
    """Floors over (or, dropped, under) each thing that is not reached."""
    made = []
    for number, box in enumerate(ground.boxes):
        (x0, y0, z0), (x1, y1, z1) = box.low_cm, box.high_cm
        top = z1 + 60 if drop == 0 else z0 - drop
        made.append(block(f"{name} {number}", (x0 - 150, y0 - 150, top - thick), (x1 + 150, y1 + 150, top)))
    return made


CHEATS: Final[dict[str, Callable[[CheatGround], Scene]]] = {
    "collision off": lambda ground: ground.changed(_off),
    "called sky": lambda ground: ground.changed(_sky),
    "floors over them": lambda ground: ground.changed(_nothing, *_slabs(ground, 0, 10, "Cover floor")),
    "floors under them": lambda ground: ground.changed(_nothing, *_slabs(ground, 300, 10, "Cellar floor")),
    "dust": lambda ground: ground.changed(_nothing, *_small(ground, 64, 4, 12, "Dust")),
    "hidden crates": lambda ground: ground.changed(_nothing, *_small(ground, 64, 20, 25, "Unseen", hidden=True)),
    "one thing 400 times": lambda ground: ground.changed(
        _nothing,
        *[
            block(f"Same {n}", (ground.x + 60, ground.y, ground.z), (ground.x + 90, ground.y + 30, ground.z + 30))
            for n in range(400)
        ],
    ),
    "a wall of 40 m": lambda ground: ground.changed(
        _nothing,
        block("Long wall", (ground.x - 2000, ground.y + 40, ground.z), (ground.x + 2000, ground.y + 50, ground.z + 40)),
    ),
}


def rows(run: Path) -> Iterator[tuple[str, str, Verdict, Verdict, list[str]]]:
    """Scene, cheat, the verdict of the truth and of the cheated scene, and the advisories that only the latter has."""
    folder = RunFolder(run)
    plan = Plan.read(folder.plan)
    seen: set[str] = set()
    for case in sorted(plan.cases, key=lambda one: one.case_id):
        if case.scene_id in seen:
            continue
        seen.add(case.scene_id)
        snapshot = read_json(folder.trial(ORACLE, case.alias, 1).evidence.snapshot)
        ground = CheatGround(snapshot)
        honest = verify_navigation(ground.evidence, snapshot)
        known = {note["code"]: len(note["actors"]) for note in honest.advisories}
        for name, cheat in CHEATS.items():
            scene = cheat(ground)
            found = verify_navigation(measure_snapshot(scene), scene)
            more = [note["code"] for note in found.advisories if len(note["actors"]) > known.get(note["code"], 0)]
            yield case.scene_id, name, honest, found, more


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("run", type=Path)
    print("| Scene | Cheat | A | A then | EUS | EUS then | Told by |\n|---|---|---|---|---|---|---|")
    unseen = 0
    for scene, name, honest, found, more in rows(parser.parse_args().run):
        before, after = (one.measurements.get("approachability") or 0.0 for one in (honest, found))
        rises = after > before + 1e-9 or (found.score or 0.0) > (honest.score or 0.0) + 1e-9
        unseen += rises and not more
        told = ", ".join(f"`{code}`" for code in more) or ("**nothing**" if rises else "it does not help")
        scores = [("–" if one.score is None else f"{one.score:.3f}") for one in (honest, found)]
        print(f"| {scene} | {name} | {before:.3f} | {after:.3f} | {scores[0]} | {scores[1]} | {told} |", flush=True)
    return int(unseen > 0)


if __name__ == "__main__":
    sys.exit(main())
