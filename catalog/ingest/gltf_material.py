"""Surfaces of glTF materials: colours, the five textures that a pack knows, and notes of what cannot be shown."""

from __future__ import annotations

import io
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from c4s.errors import BadInput
from c4s.packs.pictures import open_picture
from catalog.ingest.gltf_file import GltfFile
from catalog.ingest.surface import Surface, color_of, has_alpha, texture_png

GLASS_OPACITY = 0.25
"""What stays of a surface that lets all light through (KHR_materials_transmission)."""
COMPRESSED = "KHR_texture_basisu"
OTHER_FORMATS = ("EXT_texture_webp", "EXT_texture_avif")


@dataclass(frozen=True)
class GltfSurface:
    """A surface, the set of texture coordinates that it uses, and their (3, 3) transform."""

    surface: Surface
    uv_set: int = 0
    uv_transform: NDArray[np.float64] | None = None


class GltfMaterials:
    """Reads materials of a file, each once. Faults of textures become notes of the file."""

    def __init__(self, file: GltfFile) -> None:
        self.file = file
        self._read: dict[int | None, GltfSurface] = {}
        self._pictures: dict[int, Image.Image | None] = {}

    def surface(self, index: Any) -> GltfSurface:
        """The surface of a material; glTF's default material for ``None``."""
        if index not in self._read:
            record = {} if index is None else self.file.item("materials", index)
            try:
                self._read[index] = self._surface(record, "default" if index is None else f"material_{index}")
            except (TypeError, ValueError, AttributeError) as error:
                raise self.file.bad(f"material {record.get('name') or index!r} is malformed: {error}") from None
        return self._read[index]

    def _surface(self, record: dict[str, Any], fallback: str) -> GltfSurface:
        name, extensions = str(record.get("name") or fallback), record.get("extensions", {})
        pbr = record.get("pbrMetallicRoughness", {})
        factor = [float(value) for value in pbr.get("baseColorFactor", (1, 1, 1, 1))]
        roughness, metallic = float(pbr.get("roughnessFactor", 1)), float(pbr.get("metallicFactor", 1))
        base, shine = pbr.get("baseColorTexture"), pbr.get("metallicRoughnessTexture")
        gloss = extensions.get("KHR_materials_pbrSpecularGlossiness")
        if gloss is not None:
            factor = [float(value) for value in gloss.get("diffuseFactor", (1, 1, 1, 1))]
            roughness, metallic = 1 - float(gloss.get("glossinessFactor", 1)), 0.0
            base, shine = gloss.get("diffuseTexture", base), None
        if "KHR_materials_unlit" in extensions:
            roughness, metallic, shine = 1.0, 0.0, None
        mode = record.get("alphaMode", "OPAQUE")
        glass = min(1.0, max(0.0, float(extensions.get("KHR_materials_transmission", {}).get("transmissionFactor", 0))))
        opacity = (factor[3] if mode == "BLEND" else 1.0) * (1 - (1 - GLASS_OPACITY) * glass)
        frame, pictures = self._frame(
            name,
            {
                "base colour": base,
                "roughness": shine,
                "normal": record.get("normalTexture"),
                "emissive": record.get("emissiveTexture"),
            },
        )
        image = pictures.get("base colour")
        cut = image is not None and mode in ("MASK", "BLEND") and has_alpha(image)
        strength = float(extensions.get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1))
        glow = np.asarray(record.get("emissiveFactor", (0, 0, 0)), dtype=float)[:3] * strength

        def png(kind: str) -> bytes | None:
            return texture_png(pictures[kind]) if kind in pictures else None

        surface = Surface(
            name,
            color_of(factor),
            _unit(roughness),
            _unit(metallic),
            _glow(glow),
            _unit(opacity),
            texture_png(image, alpha=cut) if image is not None else None,
            ("mask" if mode == "MASK" else "blend") if cut else "opaque",
            _unit(record.get("alphaCutoff", 0.5)),
            png("normal"),
            png("roughness"),
            png("emissive") if glow.any() else None,
        )
        return GltfSurface(surface, *frame)

    def _frame(
        self, name: str, references: dict[str, Any]
    ) -> tuple[tuple[int, NDArray[np.float64] | None], dict[str, Image.Image]]:
        """The texture coordinates of the first texture, and the pictures of all that share them."""
        frame: tuple[int, NDArray[np.float64] | None] | None = None
        pictures: dict[str, Image.Image] = {}
        for kind, reference in references.items():
            picture = self._picture(reference)
            if picture is None:
                continue
            own = _coordinates(reference)
            frame = frame or own
            if own[0] == frame[0] and np.array_equal(
                np.eye(3) if own[1] is None else own[1], np.eye(3) if frame[1] is None else frame[1]
            ):
                pictures[kind] = picture
            else:
                self._note(f"material {name!r}: its {kind} texture lies differently from the others and is left out")
        return frame or (0, None), pictures

    def _picture(self, reference: Any) -> Image.Image | None:
        """The decoded picture that a texture reference names, or ``None`` with a note."""
        if reference is None:
            return None
        texture = self.file.item("textures", reference.get("index"))
        extensions = texture.get("extensions", {})
        source = next(
            (extensions[name].get("source") for name in OTHER_FORMATS if name in extensions), texture.get("source")
        )
        if source is None:
            if COMPRESSED in extensions:
                self._note(
                    f"a texture is compressed with {COMPRESSED} (KTX2), which is not read: the plain colour is used"
                )
            return None
        if source not in self._pictures:
            self._pictures[source] = self._decoded(source)
        return self._pictures[source]

    def _decoded(self, index: Any) -> Image.Image | None:
        record = self.file.item("images", index)
        named = str(record.get("uri") or record.get("name") or f"image {index}")[:80]
        try:
            data = (
                bytes(self.file.view(record["bufferView"]))
                if "bufferView" in record
                else self.file.bytes_of(record.get("uri"))
            )
        except BadInput:
            self._note(f"file {named!r} is missing: the plain colour is used")
            return None
        try:
            image = open_picture(io.BytesIO(data), where=named)
            image.load()
        except (OSError, ValueError, SyntaxError, BadInput) as error:
            self._note(f"texture {named!r} cannot be decoded and is left out: {str(error).split(' <')[0]}")
            return None
        return image

    def _note(self, text: str) -> None:
        if text not in self.file.notes:
            self.file.notes.append(text)


def tinted(surface: Surface, color: NDArray[np.float64]) -> Surface:
    """A surface whose base colour is multiplied by a linear colour."""
    return replace(surface, color=color_of(np.asarray(surface.color) * color))


def _glow(values: NDArray[np.float64]) -> tuple[float, float, float]:
    """Emissive colour, which may be brighter than white."""
    r, g, b = (round(max(0.0, float(value)), 4) for value in values)
    return r, g, b


def _coordinates(reference: dict[str, Any]) -> tuple[int, NDArray[np.float64] | None]:
    uv_set = int(reference.get("texCoord", 0))
    record = reference.get("extensions", {}).get("KHR_texture_transform")
    if record is None:
        return uv_set, None
    u, v = (float(value) for value in record.get("offset", (0, 0)))
    wide, high = (float(value) for value in record.get("scale", (1, 1)))
    turn = float(record.get("rotation", 0))
    cos, sin = np.cos(turn), np.sin(turn)
    matrix = np.array([[cos * wide, sin * high, u], [-sin * wide, cos * high, v], [0, 0, 1]])
    return int(record.get("texCoord", uv_set)), matrix


def _unit(value: Any) -> float:
    return round(min(1.0, max(0.0, float(value))), 4)
