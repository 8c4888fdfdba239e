"""Pictures of a headless scene, with actor masks and depth in the same pass (see DESIGN.md)."""

from c4s.render.renderer import Renderer
from c4s.render.types import Camera, Fog, Grade, Instance, Lights, LocalLight, Picture, Sky, Sun, SurfaceMaterial

__all__ = [
    "Camera",
    "Fog",
    "Grade",
    "Instance",
    "Lights",
    "LocalLight",
    "Picture",
    "Renderer",
    "Sky",
    "Sun",
    "SurfaceMaterial",
    "masks",
    "png",
    "textures",
    "types",
]
