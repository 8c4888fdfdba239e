"""Flat ground, shared by the outdoor packs."""

from __future__ import annotations

from catalog.shapes import Builder


def slab(b: Builder, material: str, x: float, y: float, thick: float = 4) -> None:
    """A slab of ground in cm whose top is at the pivot."""
    b.box(material, (x, y, thick), (0, 0, -thick))
