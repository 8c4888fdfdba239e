"""Triggers and reflection captures."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from c4s.engine.headless.unreal.actors.base import Actor
from c4s.engine.headless.unreal.components.captures import (
    BoxReflectionCaptureComponent,
    PlaneReflectionCaptureComponent,
    SphereReflectionCaptureComponent,
)
from c4s.engine.headless.unreal.components.shapes import BoxComponent, CapsuleComponent, SphereComponent, shape
from c4s.engine.headless.unreal.core import Prop, public
from c4s.engine.headless.unreal.structs import Vector


@public
class TriggerBase(Actor):
    """An actor that notices what is in its shape, in play."""

    _declares = {"collision_component": Prop("ShapeComponent", get="_get_root", writable=False, saved=False)}


@public
class TriggerBox(TriggerBase):
    """A trigger that is a box, 80 cm on a side before scaling."""

    _parts = (("CollisionComp", shape(BoxComponent, box_extent=lambda: Vector(40, 40, 40))),)


@public
class TriggerSphere(TriggerBase):
    """A trigger that is a sphere, 80 cm across before scaling."""

    _parts = (("CollisionComp", shape(SphereComponent, sphere_radius=40.0)),)


@public
class TriggerCapsule(TriggerBase):
    """A trigger that is a capsule, 80 cm across and 160 cm high before scaling."""

    _parts = (("CollisionComp", shape(CapsuleComponent, capsule_radius=40.0, capsule_half_height=80.0)),)


@public
class ReflectionCapture(Actor):
    """Where reflections are captured."""

    _declares = {"capture_component": Prop("ReflectionCaptureComponent", get="_get_root", writable=False, saved=False)}


@public
class SphereReflectionCapture(ReflectionCapture):
    """A capture for what lies in a sphere."""

    _parts = (("NewReflectionComponent", SphereReflectionCaptureComponent),)


@public
class BoxReflectionCapture(ReflectionCapture):
    """A capture for what lies in a box."""

    _parts = (("NewReflectionComponent", BoxReflectionCaptureComponent),)


@public
class PlaneReflectionCapture(ReflectionCapture):
    """A capture for what lies before a plane."""

    _parts = (("NewReflectionComponent", PlaneReflectionCaptureComponent),)
