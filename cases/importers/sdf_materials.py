"""Materials of SDF visuals: plain colours, PBR maps, Ogre scripts, transparency."""

from __future__ import annotations

import os
import re
from dataclasses import replace
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np
from PIL import UnidentifiedImageError

from c4s.bounds import BOUNDS
from c4s.files import read_plain
from c4s.packs.pictures import open_picture
from cases.importers.sdf_frames import numbers
from cases.importers.sdf_library import SdfFiles
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
    "Residential": (0.25, 0.25, 0.25),
    "Motorway": (0.25, 0.25, 0.25),
    "Primary": (0.25, 0.25, 0.25),
    "Lanes_6": (0.25, 0.25, 0.25),
    "Trunk": (0.25, 0.25, 0.25),
    "Lanes_2": (0.25, 0.25, 0.25),
    "Pedestrian": (0.62, 0.6, 0.56),
    "WoodPallet": (0.6, 0.45, 0.28),
    "CeilingTiled": (0.82, 0.82, 0.8),
    "PaintedWall": (0.8, 0.78, 0.72),
}
"""Display (sRGB) colours for the scripts that every Gazebo brings along; a plain colour stands for a picture."""

SCRIPT = re.compile(
    r"^\s*material\s+(?P<name>\S+)(?:\s*:\s*(?P<parent>\S+))?(?P<body>.*?)(?=^\s*material\s|\Z)",
    re.MULTILINE | re.DOTALL,
)


class SdfMaterials:
    """Reads the material of a visual; scripts and pictures are looked for in the scene's folders alone."""

    def __init__(self, files: SdfFiles) -> None:
        self.files = files
        self._scripts: dict[str, tuple[str, str]] | None = None
        """Names and bodies of the scripts' materials, by name; ``None`` until one is asked for."""
        self._read: dict[str, tuple[Surface, float, list[str]]] = {}

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
        scripted = self._script(name, notes) if name else None
        if scripted is not None:
            return scripted
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

    def texture(self, name: str, size_notes: list[str]) -> Surface | None:
        """The surface of a picture alone, ``None`` where there is none."""
        data = self._picture(name, size_notes) if name else None
        return None if data is None else Surface(Path(name).stem, (1.0, 1.0, 1.0), roughness=1.0, texture=data)

    def _picture(self, name: str, notes: list[str]) -> bytes | None:
        file = self.files.locate(name)
        if file is None:
            notes.append(f"file {name!r} is missing: the plain colour is used")
            return None
        try:
            return texture_png(open_picture(file, where=str(file)))
        except (UnidentifiedImageError, OSError, ValueError, SyntaxError) as error:
            notes.append(f"texture {name!r} cannot be read and is left out: {error}")
            return None

    def _script(self, name: str, notes: list[str]) -> tuple[Surface, float] | None:
        """The surface and the repeats of a material of the scene's scripts, ``None`` for a name that none has."""
        if self._scripts is None:
            self._scripts = self._all_scripts()
        if name not in self._scripts:
            return None
        if name not in self._read:
            told = list[str]()
            self._read[name] = (*self._scripted(name, told), told)
        surface, repeat, told = self._read[name]
        notes += told
        return surface, repeat

    def _all_scripts(self) -> dict[str, tuple[str, str]]:
        found: dict[str, tuple[str, str]] = {}
        for root in self.files.folders:
            for path in sorted(root.rglob("*.material")):
                if not (path.is_file() and Path(os.path.realpath(path)).is_relative_to(root)):
                    continue
                text = re.sub(
                    r"//[^\n]*", "", read_plain(path, bound=BOUNDS["markup_bytes"]).decode("utf-8", "replace")
                )
                for match in SCRIPT.finditer(text):
                    found[match["name"]] = (match["parent"] or "", match["body"])
        return found

    def _scripted(self, name: str, notes: list[str]) -> tuple[Surface, float]:
        body, above, seen = "", name, set[str]()
        while self._scripts is not None and above in self._scripts and above not in seen:
            seen.add(above)
            above, own = self._scripts[above]
            body += own
        picture = re.search(r"\btexture\s+(\S+)", body)
        values = {key: _first(rf"\b{key}\s+([^\n}}]*)", body) for key in ("diffuse", "ambient", "emissive", "scale")}
        color = [linear(min(1.0, max(0.0, value))) for value in values["diffuse"][:3] or values["ambient"][:3]]
        glow = [linear(min(1.0, max(0.0, value))) for value in values["emissive"][:3]]
        opacity = values["diffuse"][3] if "alpha_blend" in body and len(values["diffuse"]) > 3 else 1.0
        surface = Surface(
            name.rsplit("/", 1)[-1],
            color_of(color if len(color) == 3 else [1.0] * 3),
            emissive=color_of(glow if len(glow) == 3 else [0.0] * 3),
            opacity=round(min(1.0, max(0.0, opacity)), 4),
            texture=self._picture(picture.group(1), notes) if picture else None,
        )
        repeat = values["scale"][0] if values["scale"] else 1.0
        return surface, 1 / repeat if abs(repeat) > 1e-6 else 1.0


def _first(pattern: str, text: str) -> list[float]:
    """The numbers that follow a word of a script, as far as they are numbers."""
    found, values = re.search(pattern, text), list[float]()
    for word in found.group(1).split() if found else []:
        try:
            values.append(float(word))
        except ValueError:
            break
    return values if np.isfinite(values).all() else []
