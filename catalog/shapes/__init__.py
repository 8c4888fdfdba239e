"""Parametric geometry: parts with materials and collision bodies, joined to meshes."""

from catalog.shapes.builder import Builder, BuiltShape
from catalog.shapes.spec import AssetSpec, BlueprintPartSpec, BlueprintSpec, Kit, MaterialSpec, PackSpec

__all__ = [
    "AssetSpec",
    "BlueprintPartSpec",
    "BlueprintSpec",
    "Builder",
    "BuiltShape",
    "Kit",
    "MaterialSpec",
    "PackSpec",
]
