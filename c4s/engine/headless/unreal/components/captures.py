"""Where reflections are captured: kept and saved; pictures here reflect by tracing, without captures."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from c4s.engine.headless.unreal.components.scene import SceneComponent
from c4s.engine.headless.unreal.core import Prop, public


@public
class ReflectionCaptureComponent(SceneComponent):
    """Base of captures."""


@public
class SphereReflectionCaptureComponent(ReflectionCaptureComponent):
    """A capture for what lies in a sphere."""

    _declares = {"influence_radius": Prop("float", 3000.0)}


@public
class BoxReflectionCaptureComponent(ReflectionCaptureComponent):
    """A capture for what lies in a box."""

    _declares = {"box_transition_distance": Prop("float", 100.0)}


@public
class PlaneReflectionCaptureComponent(ReflectionCaptureComponent):
    """A capture for what lies before a plane."""

    _declares = {"influence_radius_scale": Prop("float", 2.0)}
