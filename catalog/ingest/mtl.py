"""Material libraries of OBJ files: colours, opacity, and textures with their options."""

from __future__ import annotations

import io
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from c4s.errors import BadInput
from c4s.files import read_plain
from c4s.packs.pictures import open_picture
from catalog.ingest.resolver import FolderResolver
from catalog.ingest.surface import Colour, Surface, color_of, has_alpha, linear, texture_png

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
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
MAPS = {
    "map_kd": "base colour",
    "map_d": "opacity",
    "map_opacity": "opacity",
    "map_ke": "emissive",
    "map_pr": "roughness",
    "map_pm": "metallic",
    "norm": "normal",
    "map_kn": "normal",
    "map_bump": "bump",
    "bump": "bump",
}
"""The maps that are read, by their keyword in lower case."""
SOFT_SHARE = 0.02
"""A texture with more half transparent pixels than this is blended; one with less is cut out."""
PLAIN = Surface("plain", (0.5, 0.5, 0.5))


@dataclass(frozen=True)
class TextureMap:
    """A picture and how it lies: texture coordinates times ``scale`` plus ``offset`` (v up)."""

    file: str
    scale: tuple[float, float] = (1.0, 1.0)
    offset: tuple[float, float] = (0.0, 0.0)

    @property
    def frame(self) -> tuple[float, float, float, float]:
        """Scale and offset."""
        return (*self.scale, *self.offset)


@dataclass(frozen=True)
class ObjSurface:
    """A surface, and what its texture coordinates (v up) are multiplied by and moved by."""

    surface: Surface
    scale: tuple[float, float] = (1.0, 1.0)
    offset: tuple[float, float] = (0.0, 0.0)


@dataclass
class _Record:
    """One ``newmtl``: the last value of each keyword, and the file it stands in."""

    name: str
    library: Path
    values: dict[str, str] = field(default_factory=dict)


class MtlLibraries:
    """The materials of an OBJ file. Missing files and faults of textures become ``notes``.

    Args:
        source: the OBJ file.
        root: the only folder whose files may be read.
        named: what stands behind each ``mtllib``; names may hold blanks, or a line several files.
    """

    def __init__(self, source: Path, root: Path, named: list[str]) -> None:
        self.source, self.root = source, root
        self.notes: list[str] = []
        self._records: dict[str, _Record] = {}
        self._surfaces: dict[str, ObjSurface] = {}
        self._pictures: dict[Path, Image.Image | None] = {}
        resolver = FolderResolver(source, root)
        for line in named:
            for path in self._found(resolver, line):
                self._read(path)

    def _found(self, resolver: FolderResolver, line: str) -> list[Path]:
        whole = resolver.locate(line)
        if whole is not None:
            return [whole]
        words = re.findall(r".+?\.mtl\b", line, re.IGNORECASE) or line.split()
        found = [(word.strip(), resolver.locate(word.strip())) for word in words]
        for word, path in found:
            if path is None:
                own = resolver.locate(f"{self.source.stem}.mtl")
                instead = f": {own.name} is read" if own else ""
                self._note(f"file {word!r} is missing{instead or ': its materials are plain grey'}")
                return [path for _, path in found if path is not None] + ([own] if own else [])
        return [path for _, path in found if path is not None]

    def _read(self, path: Path) -> None:
        record: _Record | None = None
        for line in read_plain(path).decode("utf-8-sig", errors="replace").splitlines():
            key, _, rest = line.strip().replace("\t", " ").partition(" ")
            if key.lower() == "newmtl":
                record = _Record(rest.strip(), path)
                self._records.setdefault(record.name, record)
            elif record is not None and key and not key.startswith("#"):
                record.values[key.lower()] = rest.strip()

    def surface(self, name: str) -> ObjSurface:
        """The surface of a material; plain grey, with a note, where no library has it."""
        if name not in self._surfaces:
            record = self._records.get(name)
            if record is None:
                if self._records:
                    self._note(f"material {name!r} is in no library: it is plain grey")
                self._surfaces[name] = ObjSurface(Surface(name or "plain", PLAIN.color))
            else:
                self._surfaces[name] = self._made(record)
        return self._surfaces[name]

    def _made(self, record: _Record) -> ObjSurface:
        pictures, frame = self._maps(record)
        base, cover = pictures.get("base colour"), pictures.get("opacity")
        values = record.values
        opacity = self._number(values.get("d", ""), None)
        if opacity is None:
            opacity = 1 - (self._number(values.get("tr", ""), None) or 0.0)
        opacity = min(1.0, max(0.0, opacity))
        if opacity == 0:
            self._note(f"material {record.name!r} is wholly transparent")
        if cover is not None:
            base = _covered(base, cover)
        cut = base is not None and _shows(base)
        glow = self._color(values.get("ke"), (0.0, 0.0, 0.0))
        if "emissive" in pictures and not any(glow):
            glow = (1.0, 1.0, 1.0)
        surface = Surface(
            record.name,
            (1.0, 1.0, 1.0) if "base colour" in pictures else self._color(values.get("kd"), (0.5, 0.5, 0.5)),
            round(min(1.0, self._number(values.get("pr", ""), 1.0 if "roughness" in pictures else 0.8) or 0.0), 4),
            round(min(1.0, self._number(values.get("pm", ""), 1.0 if "metallic" in pictures else 0.0) or 0.0), 4),
            glow,
            round(opacity, 4),
            texture_png(base, alpha=cut) if base is not None else None,
            _cut_or_blend(base) if cut and base is not None else "opaque",
            normal_texture=texture_png(pictures["normal"]) if "normal" in pictures else None,
            roughness_metal_texture=_packed(pictures.get("roughness"), pictures.get("metallic")),
            emissive_texture=texture_png(pictures["emissive"]) if "emissive" in pictures else None,
        )
        return ObjSurface(surface, frame[:2], frame[2:])

    def _maps(self, record: _Record) -> tuple[dict[str, Image.Image], tuple[float, float, float, float]]:
        """The pictures of a material, and the frame of the first: others that lie differently are left out."""
        pictures: dict[str, Image.Image] = {}
        frame: tuple[float, float, float, float] | None = None
        for key, kind in MAPS.items():
            if key not in record.values or kind in pictures:
                continue
            resolver = FolderResolver(record.library, self.root)
            one = texture_map(record.values[key], resolver)
            image = self._picture(one.file, resolver)
            if image is None:
                continue
            if kind == "bump":
                if not _is_normal_map(image):
                    self._note(f"material {record.name!r}: its bump map is left out")
                    continue
                kind = "normal"
                if kind in pictures:
                    continue
            if frame is not None and one.frame != frame:
                self._note(
                    f"material {record.name!r}: its {kind} texture lies differently from the others and is left out"
                )
                continue
            frame = one.frame
            pictures[kind] = image
        return pictures, frame or (1.0, 1.0, 0.0, 0.0)

    def _picture(self, name: str, resolver: FolderResolver) -> Image.Image | None:
        path = resolver.locate(name) or FolderResolver(self.source, self.root).locate(name)
        if path is None:
            self._note(f"file {name!r} is missing: the plain colour is used")
            return None
        if path not in self._pictures:
            try:
                image = open_picture(io.BytesIO(read_plain(path)), where=path.name)
                image.load()
            except (OSError, ValueError, SyntaxError, BadInput) as error:
                self._note(f"texture {path.name!r} cannot be decoded and is left out: {str(error).split(' <')[0]}")
                self._pictures[path] = None
            else:
                self._pictures[path] = image
        return self._pictures[path]

    def _color(self, text: str | None, default: Colour) -> Colour:
        """Linear colour of one display value or three; the default for what is no number (a spectrum, CIE values)."""
        values = [self._number(word, None) for word in (text or "").split()[:3]]
        if not values or any(value is None for value in values):
            return default
        numbers = [min(1.0, value or 0.0) for value in values]
        return color_of([linear(value) for value in (numbers * 3)[:3]])

    @staticmethod
    def _number(text: str, default: float | None) -> float | None:
        """The last number of a value, at least 0."""
        words = text.split()
        try:
            value = float(words[-1]) if words else default
        except ValueError:
            return default
        return default if value is None or not np.isfinite(value) else max(0.0, value)

    def _note(self, text: str) -> None:
        if text not in self.notes:
            self.notes.append(text)


def texture_map(arguments: str, resolver: FolderResolver) -> TextureMap:
    """The file of a map with its ``-o`` and ``-s``; options stand before or behind the name, which may hold blanks."""
    words = arguments.split(" ")
    found: dict[str, list[float]] = {}
    _options(words, found)
    name = " ".join(words).strip()
    behind = next((at for at, word in enumerate(words) if at and word.lower() in MAP_OPTIONS), None)
    if behind is not None and resolver.locate(name) is None:
        _options(words[behind:], found)
        name = " ".join(words[:behind]).strip()
    scale, offset = [*found.get("-s", []), 1.0, 1.0], [*found.get("-o", []), 0.0, 0.0]
    if len(found.get("-s", [])) == 1:
        scale = [scale[0], 1.0]
    return TextureMap(name, (scale[0], scale[1]), (offset[0], offset[1]))


def _options(words: list[str], found: dict[str, list[float]]) -> None:
    """Take the options off the front of ``words``."""
    while words and (not words[0] or words[0].lower() in MAP_OPTIONS):
        option = words.pop(0).lower()
        for taken in range(MAP_OPTIONS.get(option, 0)):
            number = NUMBER.fullmatch(words[0]) if words else None
            if not words or (option in ("-o", "-s", "-t") and (number is None or (taken and len(words) == 1))):
                break
            word = words.pop(0)
            if option in ("-o", "-s") and np.isfinite(float(word)):
                found.setdefault(option, []).append(float(word))


def _covered(base: Image.Image | None, cover: Image.Image) -> Image.Image:
    """A picture whose alpha is an opacity map: the map's own alpha where it has one, else its brightness."""
    alpha = cover.convert("RGBA").getchannel("A") if has_alpha(cover) else cover.convert("L")
    image = Image.new("RGB", cover.size, (255, 255, 255)) if base is None else base.convert("RGB")
    if alpha.size != image.size:
        alpha = alpha.resize(image.size, Image.Resampling.BILINEAR)
    image.putalpha(alpha)
    return image


def _alpha(image: Image.Image) -> NDArray[np.uint8]:
    return np.asarray(image.convert("RGBA").getchannel("A"))


def _shows(image: Image.Image) -> bool:
    """Whether a picture is transparent in a part: one that is so everywhere holds something else in its alpha."""
    return has_alpha(image) and bool(_alpha(image).max() > 127)


def _cut_or_blend(image: Image.Image) -> Literal["mask", "blend"]:
    alpha = _alpha(image)
    return "blend" if float(((alpha > 16) & (alpha < 239)).mean()) > SOFT_SHARE else "mask"


def _is_normal_map(image: Image.Image) -> bool:
    """Whether a picture holds normals: blue above all, and grey nowhere. A height map has one value a pixel."""
    if len(image.getbands()) < 3:
        return False
    small = np.asarray(image.convert("RGB").resize((32, 32)), float) / 255
    mean = small.reshape(-1, 3).mean(axis=0)
    return bool(mean[2] > 0.75 and abs(mean[0] - 0.5) < 0.12 and abs(mean[1] - 0.5) < 0.12)


def _packed(roughness: Image.Image | None, metallic: Image.Image | None) -> bytes | None:
    """Roughness in green and metalness in blue, as glTF packs them."""
    if roughness is None and metallic is None:
        return None
    size = roughness.size if roughness is not None else metallic.size if metallic is not None else (1, 1)
    full = Image.new("L", size, 255)
    green = full if roughness is None else roughness.convert("L")
    blue = full if metallic is None else metallic.convert("L").resize(size)
    return texture_png(Image.merge("RGB", (full, green, blue)))
