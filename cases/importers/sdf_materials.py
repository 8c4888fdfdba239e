"""Materials of SDF visuals: plain colours, PBR maps, Ogre scripts, transparency."""

from __future__ import annotations

import os
import re
from dataclasses import replace
from pathlib import Path
from xml.etree.ElementTree import Element

from PIL import UnidentifiedImageError

from c4s.errors import BadInput
from c4s.packs.pictures import open_picture
from cases.importers.sdf_frames import numbers
from catalog.ingest.resolver import FolderResolver
from catalog.ingest.surface import Colour, Surface, color_of, linear, texture_png

GAZEBO_COLOURS: dict[str, Colour] = {
    "Black": (0, 0, 0),
    "Blue": (0, 0, 1),
    "Green": (0, 1, 0),
    "Red": (1, 0, 0),
    "White": (1, 1, 1),
    "Yellow": (1, 1, 0),
    "Purple": (1, 0, 1),
    "Turquoise": (0, 1, 1),
    "Grey": (0.7, 0.7, 0.7),
    "Gray": (0.7, 0.7, 0.7),
    "DarkGrey": (0.175, 0.175, 0.175),
    "DarkGray": (0.175, 0.175, 0.175),
    "Orange": (1, 0.5088, 0.0468),
    "Gold": (0.8, 0.6487, 0.1204),
    "Wood": (0.48, 0.3, 0.16),
    "WoodFloor": (0.48, 0.3, 0.16),
    "ZincYellow": (0.9725, 0.9529, 0.2078),
    "FlatBlack": (0.1, 0.1, 0.1),
    "SkyBlue": (0.13, 0.44, 0.7),
    "Bricks": (0.55, 0.27, 0.2),
    "Grass": (0.2, 0.4, 0.12),
    "Road": (0.25, 0.25, 0.25),
}
"""Display (sRGB) colours for the scripts that every Gazebo brings along; a plain colour stands for a picture."""


class SdfMaterials:
    """Reads the material of a visual; scripts and pictures are looked for under ``root`` alone."""

    def __init__(self, files: FolderResolver, root: Path) -> None:
        self.files = files
        self._scripts: dict[str, tuple[Surface, float]] = {}
        for path in sorted(root.rglob("*.material")):
            if path.is_file() and Path(os.path.realpath(path)).is_relative_to(Path(os.path.realpath(root))):
                self._read_script(path)

    def read(self, visual: Element, notes: list[str]) -> tuple[Surface | None, float]:
        """The surface that a visual asks for (``None``: its mesh's own) and the repeats of its texture."""
        surface, repeat = self._material(visual.find("material"), notes)
        clear = numbers(visual.findtext("transparency"), 1)[0]
        if clear > 0:
            surface = replace(surface or Surface("plain", (0.6, 0.6, 0.6)), opacity=round(1 - min(1.0, clear), 4))
        return surface, repeat

    def _material(self, material: Element | None, notes: list[str]) -> tuple[Surface | None, float]:
        if material is None:
            return None, 1.0
        name = (material.findtext("script/name") or "").strip()
        if name in self._scripts:
            return self._scripts[name]
        diffuse = material.findtext("diffuse")
        color = diffuse or material.findtext("ambient")
        metal = material.find("pbr/metal")
        if metal is not None:
            return self._pbr(metal, color, notes), 1.0
        if name.startswith("Gazebo/") and name[7:] in GAZEBO_COLOURS:
            return Surface(name[7:], color_of([linear(value) for value in GAZEBO_COLOURS[name[7:]]])), 1.0
        if name:
            notes.append(f"material script {name!r} is missing" + ("" if color else ": a plain grey is used"))
        if not color:
            return (Surface("plain", (0.6, 0.6, 0.6)) if name else None), 1.0
        values = numbers(color, min(4, max(3, len(color.split()))))
        shown = [linear(min(1.0, max(0.0, value))) for value in values[:3]]
        glow = numbers(material.findtext("emissive"), 3)
        return Surface(
            name.rsplit("/", 1)[-1] or "plain",
            color_of(shown),
            emissive=color_of([linear(min(1.0, max(0.0, value))) for value in glow]),
            opacity=round(min(1.0, max(0.0, values[3])), 4) if len(values) > 3 else 1.0,
        ), 1.0

    def _pbr(self, metal: Element, color: str | None, notes: list[str]) -> Surface:
        picture = (metal.findtext("albedo_map") or "").strip()
        data = self._picture(picture, notes) if picture else None
        shown = [linear(min(1.0, max(0.0, value))) for value in numbers(color, 3)] if color else [1.0, 1.0, 1.0]
        return Surface(
            Path(picture).stem or "pbr",
            color_of(shown),
            round(numbers(metal.findtext("roughness"), 1, 0.5)[0], 4),
            round(numbers(metal.findtext("metalness"), 1, 0.5)[0], 4),
            texture=data,
        )

    def _picture(self, name: str, notes: list[str]) -> bytes | None:
        file = self.files.locate(name)
        if file is None:
            notes.append(f"file {name!r} is missing: the plain colour is used")
            return None
        return _png(file)

    def _read_script(self, path: Path) -> None:
        text = path.read_text(encoding="utf-8", errors="replace")
        for match in re.finditer(r"^\s*material\s+(\S+)(.*?)(?=^\s*material\s|\Z)", text, re.MULTILINE | re.DOTALL):
            name, body = match.groups()
            picture = re.search(r"\btexture\s+(\S+)", body)
            scale = re.search(r"\bscale\s+([0-9.eE+-]+)", body)
            diffuse = re.search(r"\bdiffuse\s+([0-9.]+)\s+([0-9.]+)\s+([0-9.]+)", body)
            color = [linear(min(1.0, float(value))) for value in diffuse.groups()] if diffuse else [1.0] * 3
            file = self.files.locate(picture.group(1)) if picture else None
            self._scripts[name] = (
                Surface(name.rsplit("/", 1)[-1], color_of(color), texture=_png(file) if file is not None else None),
                1 / float(scale.group(1)) if scale and float(scale.group(1)) else 1.0,
            )


def _png(file: Path) -> bytes:
    try:
        return texture_png(open_picture(file, where=str(file)))
    except (UnidentifiedImageError, OSError) as error:
        raise BadInput(f"this texture cannot be read: {error}", where=str(file)) from None
