"""Small scenes of known answer, as snapshots: boxes that collide, in cm."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

MESH = "/Game/Test/SM_Block.SM_Block"
RAMP = "/Game/Test/SM_Ramp.SM_Ramp"
MESHES: dict[str, Any] = {
    MESH: {"collision": [{"kind": "box", "center": [0, 0, 0], "half_extent": [50, 50, 50]}]},
    RAMP: {
        "collision": [
            {
                "kind": "hull",
                "vertices": [[0, y, z] for y in (-50, 50) for z in (0, -10)]
                + [[100, y, z] for y in (-50, 50) for z in (100, -10)],
            }
        ]
    },
}


def actor(
    label: str,
    low: Sequence[float],
    high: Sequence[float],
    *,
    mesh: str = MESH,
    yaw: float = 0.0,
    collides: bool = True,
    hidden: bool = False,
    class_path: str = "/Script/Engine.StaticMeshActor",
    **own: Any,
) -> dict[str, Any]:
    """An actor whose box reaches from ``low`` to ``high``; a ramp rises along x from the first to the second."""
    size = [b - a for a, b in zip(low, high, strict=True)]
    middle = [(a + b) / 2 for a, b in zip(low, high, strict=True)]
    place = middle if mesh == MESH else [low[0], middle[1], low[2]]
    transform = {"location_cm": place, "rotation_deg": [0.0, yaw, 0.0], "scale": [part / 100 for part in size]}
    component = {
        "name": "Mesh",
        "class": "/Script/Engine.StaticMeshComponent",
        "mesh": mesh,
        "collision_enabled": collides,
        "transform": transform,
    }
    return {
        "name": label.replace(" ", ""),
        "label": label,
        "class": class_path,
        "asset_path": mesh,
        "component_asset_paths": [mesh],
        "collision": {"collision_enabled": collides},
        "bounds": {"origin_cm": middle, "extent_cm": [part / 2 for part in size]},
        "transform": transform,
        "c4s": {"components": [component], "hidden": hidden},
        **own,
    }


def scene(*actors: dict[str, Any]) -> dict[str, Any]:
    """A snapshot of the headless engine."""
    return {"actors": list(actors), "c4s": {"engine": "headless", "engine_version": "1", "meshes": MESHES}}


def floor(width: float = 2000.0, depth: float = 2000.0, top: float = 0.0, label: str = "Floor") -> dict[str, Any]:
    """A plate around the origin whose upper side is at ``top``."""
    return actor(label, (-width / 2, -depth / 2, top - 20), (width / 2, depth / 2, top))


def crates(count: int, *, y: float, start: float = -900.0, step: float = 120.0, size: float = 40.0) -> list[Any]:
    """A row of small crates along x."""
    return [
        actor(f"Crate {y:.0f} {n}", (start + n * step, y, 0), (start + n * step + size, y + size, size))
        for n in range(count)
    ]
