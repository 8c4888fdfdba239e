"""Material libraries of OBJ files: options of maps, glow and opacity, which trimesh's reader does not know."""

from __future__ import annotations

import re
from pathlib import Path

from catalog.ingest.resolver import FolderResolver
from catalog.ingest.surface import color_of, linear

MAP_OPTIONS = {
    "-blendu": 1,
    "-blendv": 1,
    "-bm": 1,
    "-boost": 1,
    "-cc": 1,
    "-clamp": 1,
    "-imfchan": 1,
    "-mm": 2,
    "-o": 3,
    "-s": 3,
    "-t": 3,
    "-texres": 1,
    "-type": 1,
}
"""Options of a map and how many values stand behind each (at most: ``-o``, ``-s`` and ``-t`` take one to three)."""


class ObjResolver(FolderResolver):
    """Hands trimesh material libraries whose maps are plain names, and keeps the libraries."""

    def __init__(self, source: Path, root: Path) -> None:
        super().__init__(source, root)
        self.libraries: list[str] = []

    def get(self, key: str) -> bytes:
        """Content of a file; a material library with the options of its maps taken out."""
        data = super().get(key)
        if not str(key).lower().endswith(".mtl"):
            return data
        text = data.decode("utf-8-sig", errors="replace")
        self.libraries.append(text)
        return re.sub(
            r"(?im)^([ \t]*map_kd[ \t]+)(.*)$", lambda found: found.group(1) + _map_file(found.group(2)), text
        ).encode()


def _map_file(arguments: str) -> str:
    """The file of a map: what is left when the options are gone; names may hold blanks."""
    words = arguments.split(" ")
    while words and (not words[0] or words[0].lower() in MAP_OPTIONS):
        option = words.pop(0).lower()
        for _ in range(MAP_OPTIONS.get(option, 0)):
            if words and (option not in ("-o", "-s", "-t") or re.fullmatch(r"[-+.0-9eE]+", words[0])):
                words.pop(0)
    return " ".join(words).strip()


def glow_and_opacity(resolver: ObjResolver) -> dict[str, tuple[tuple[float, float, float], float]]:
    """Linear emissive colour (``Ke``) and opacity (``d``, or one less ``Tr``) of each material."""
    found: dict[str, tuple[tuple[float, float, float], float]] = {}
    for text in resolver.libraries:
        for block in re.split(r"(?m)^[ \t]*newmtl[ \t]+", text)[1:]:
            name = block.splitlines()[0].strip()
            glow = re.search(r"(?m)^[ \t]*Ke[ \t]+([0-9.eE+-]+)[ \t]+([0-9.eE+-]+)[ \t]+([0-9.eE+-]+)", block)
            solid = re.search(r"(?m)^[ \t]*(d|Tr)[ \t]+([0-9.eE+-]+)", block)
            opacity = 1.0 if solid is None else _number(solid.group(2))
            emissive = color_of([linear(min(1.0, _number(value))) for value in glow.groups()]) if glow else (0.0,) * 3
            found[name] = (
                (emissive[0], emissive[1], emissive[2]),
                round(min(1.0, max(0.0, 1 - opacity if solid is not None and solid.group(1) == "Tr" else opacity)), 4),
            )
    return found


def _number(text: str) -> float:
    try:
        return max(0.0, float(text))
    except ValueError:
        return 0.0
