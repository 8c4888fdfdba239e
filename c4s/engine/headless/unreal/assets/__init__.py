"""Asset classes: static meshes, materials and their instances, Blueprints."""

from __future__ import annotations

from c4s.engine.headless.unreal.assets.base import AssetObject
from c4s.engine.headless.unreal.assets.blueprints import Blueprint
from c4s.engine.headless.unreal.assets.collision import (
    BodySetup,
    KAggregateGeom,
    KBoxElem,
    KConvexElem,
    KSphereElem,
    KSphylElem,
    aggregate,
)
from c4s.engine.headless.unreal.assets.materials import (
    SCALAR_PARAMETERS,
    VECTOR_FIELDS,
    VECTOR_PARAMETERS,
    Material,
    MaterialInstance,
    MaterialInstanceConstant,
    MaterialInstanceDynamic,
    MaterialInterface,
    Texture,
    parameter_field,
)
from c4s.engine.headless.unreal.assets.meshes import StaticMaterial, StaticMesh

__all__ = [
    "SCALAR_PARAMETERS",
    "VECTOR_FIELDS",
    "VECTOR_PARAMETERS",
    "AssetObject",
    "Blueprint",
    "BodySetup",
    "KAggregateGeom",
    "KBoxElem",
    "KConvexElem",
    "KSphereElem",
    "KSphylElem",
    "Material",
    "MaterialInstance",
    "MaterialInstanceConstant",
    "MaterialInstanceDynamic",
    "MaterialInterface",
    "StaticMaterial",
    "StaticMesh",
    "Texture",
    "aggregate",
    "parameter_field",
]
