"""Parametric geometry: parts with materials and collision bodies, joined to meshes."""

from catalog.shapes.builder import Builder, Shape
from catalog.shapes.spec import AssetSpec, BlueprintSpec, Kit, MaterialSpec, PackSpec, Part

__all__ = ["AssetSpec", "BlueprintSpec", "Builder", "Kit", "MaterialSpec", "PackSpec", "Part", "Shape"]
