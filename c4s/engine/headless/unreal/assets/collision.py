"""Collision of meshes in Unreal's structs."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from typing import Any, ClassVar

from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Object, Prop, public
from c4s.engine.headless.unreal.enums import CollisionTraceFlag
from c4s.engine.headless.unreal.structs import ClosedStruct, Rotator, Vector
from c4s.records import pack
from c4s.records.pack import Asset


def _unseen(kind: str, default: Any) -> Prop:
    return Prop(kind, default, attribute=False)


@public
class KBoxElem(ClosedStruct):
    """A box of simple collision; x, y, z are full lengths in cm."""

    _takes = 0
    _fields = {
        "center": _unseen("Vector", Vector),
        "rotation": _unseen("Rotator", Rotator),
        "x": _unseen("float", 0.0),
        "y": _unseen("float", 0.0),
        "z": _unseen("float", 0.0),
    }


@public
class KSphereElem(ClosedStruct):
    """A sphere of simple collision."""

    _takes = 0
    _fields = {"center": _unseen("Vector", Vector), "radius": _unseen("float", 0.0)}


@public
class KSphylElem(ClosedStruct):
    """A capsule of simple collision; ``length`` is the cylinder part."""

    _takes = 0
    _fields = {
        "center": _unseen("Vector", Vector),
        "rotation": _unseen("Rotator", Rotator),
        "radius": _unseen("float", 0.0),
        "length": _unseen("float", 0.0),
    }


@public
class KConvexElem(ClosedStruct):
    """A convex hull of simple collision; its vertices are not readable from Python."""

    _takes = 0
    _fields: ClassVar[dict[str, Prop]] = {"name": _unseen("Name", Name)}


@public
class KAggregateGeom(ClosedStruct):
    """All simple collision of a body."""

    _takes = 0
    _fields = {
        name: _unseen(f"Sequence[{kind}]", lambda kind=kind: Array._of(kind, []))
        for name, kind in (
            ("box_elems", "KBoxElem"),
            ("sphere_elems", "KSphereElem"),
            ("sphyl_elems", "KSphylElem"),
            ("convex_elems", "KConvexElem"),
        )
    }


@public
class BodySetup(Object):
    """Collision of a mesh."""

    _declares = {
        "agg_geom": Prop("KAggregateGeom", KAggregateGeom, attribute=False, writable=False),
        "collision_trace_flag": Prop("CollisionTraceFlag", CollisionTraceFlag.CTF_USE_DEFAULT, attribute=False),
    }


def aggregate(asset: Asset) -> KAggregateGeom:
    """An asset's collision bodies in Unreal's structs."""
    boxes: list[KBoxElem] = []
    spheres: list[KSphereElem] = []
    capsules: list[KSphylElem] = []
    hulls: list[KConvexElem] = []
    for body in asset.collision:
        if isinstance(body, pack.BoxBody):
            x, y, z = (2 * h for h in body.half_extent)
            boxes.append(KBoxElem._of_fields(Vector(*body.center), Rotator._of(body.rotation_deg), x, y, z))
        elif isinstance(body, pack.SphereBody):
            spheres.append(KSphereElem._of_fields(Vector(*body.center), body.radius))
        elif isinstance(body, pack.CapsuleBody):
            capsules.append(
                KSphylElem._of_fields(Vector(*body.center), Rotator._of(body.rotation_deg), body.radius, body.length)
            )
        else:
            hulls.append(KConvexElem._of_fields(Name(f"Hull_{len(hulls)}")))
    geom: KAggregateGeom = KAggregateGeom._of_fields(boxes, spheres, capsules, hulls)
    return geom
