"""Small snapshots with collision bodies, built by hand."""

from __future__ import annotations

from typing import Any


def cube(half: float = 50.0) -> list[dict[str, Any]]:
    return [{"kind": "box", "center": [0, 0, 0], "half_extent": [half, half, half]}]


def actor(
    name: str, mesh: str, location: Any = (0, 0, 0), rotation: Any = (0, 0, 0), scale: Any = (1, 1, 1), **more: Any
) -> dict[str, Any]:
    transform = {"location_cm": list(location), "rotation_deg": list(rotation), "scale": list(scale)}
    return {
        "name": name,
        "label": name,
        "class": "/Script/Engine.StaticMeshActor",
        "transform": transform,
        "c4s": {
            "components": [
                {
                    "name": "StaticMeshComponent0",
                    "class": "/Script/Engine.StaticMeshComponent",
                    "mesh": mesh,
                    "collision_enabled": True,
                    "transform": transform,
                }
            ]
        },
    } | more


def scene(meshes: dict[str, list[dict[str, Any]]], *actors: dict[str, Any]) -> dict[str, Any]:
    return {
        "schema_version": "0.3.0",
        "units": "cm",
        "actors": list(actors),
        "c4s": {"engine": "headless", "meshes": {path: {"collision": bodies} for path, bodies in meshes.items()}},
    }
