"""Pictures from scripts' own cameras: render targets, written as PNG files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image

from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import Object, api, public
from c4s.engine.headless.unreal.scene_capture import MAX_SIDE, TextureRenderTarget2D, TextureRenderTargetFormat
from c4s.engine.headless.unreal.structs import Color, LinearColor

_BLACK: LinearColor = (0.0, 0.0, 0.0, 1.0)  # type: ignore[assignment]


@public
class RenderingLibrary(Object):
    """Render targets."""

    @classmethod
    @api
    def create_render_target2d(
        cls,
        world_context_object: Object | None,
        width: int = 256,
        height: int = 256,
        format: TextureRenderTargetFormat = TextureRenderTargetFormat.RTF_RGBA16F,
        clear_color: LinearColor = _BLACK,
        auto_generate_mip_maps: bool = False,
        support_ua_vs: bool = False,
    ) -> TextureRenderTarget2D | None:
        """An empty picture of 1 to 4096 pixels a side; None for other sizes. It keeps bytes, whatever the format."""
        if not (0 < width <= MAX_SIDE and 0 < height <= MAX_SIDE):
            return None
        made: TextureRenderTarget2D = TextureRenderTarget2D._transient(width, height, format)
        made._fill(LinearColor.cast(clear_color))
        return made

    @classmethod
    @api
    def release_render_target2d(cls, texture_render_target: TextureRenderTarget2D) -> None:
        """Forget the pixels."""
        texture_render_target._fill(LinearColor(0, 0, 0, 1))

    @classmethod
    @api
    def clear_render_target2d(
        cls,
        world_context_object: Object | None,
        texture_render_target: TextureRenderTarget2D,
        clear_color: LinearColor = _BLACK,
    ) -> None:
        """Fill with one colour."""
        texture_render_target._fill(LinearColor.cast(clear_color))

    @classmethod
    @api
    def resize_render_target2d(
        cls, texture_render_target: TextureRenderTarget2D, width: int = 256, height: int = 256
    ) -> None:
        """Change the size; the pixels become black."""
        if 0 < width <= MAX_SIDE and 0 < height <= MAX_SIDE:
            texture_render_target._pixels = np.zeros((height, width, 3), dtype=np.uint8)

    @classmethod
    @api
    def export_render_target(
        cls,
        world_context_object: Object | None,
        texture_render_target: TextureRenderTarget2D,
        file_path: str,
        file_name: str,
    ) -> None:
        """Write the pixels as a PNG file; ``.png`` is put behind a name without an ending."""
        name = str(file_name)
        path = Path(str(file_path)) / (name if Path(name).suffix else f"{name}.png")
        path.parent.mkdir(parents=True, exist_ok=True)
        Image.fromarray(texture_render_target._pixels).save(path, format="PNG")

    @classmethod
    @api
    def read_render_target_pixel(
        cls, world_context_object: Object | None, texture_render_target: TextureRenderTarget2D, x: int, y: int
    ) -> Color:
        """Bytes of a pixel, counted from the upper left; red outside the picture."""
        pixels = texture_render_target._pixels
        if not (0 <= y < pixels.shape[0] and 0 <= x < pixels.shape[1]):
            return Color(b=0, g=0, r=255, a=255)
        return _color(pixels[y, x])

    @classmethod
    @api
    def read_render_target_uv(
        cls, world_context_object: Object | None, texture_render_target: TextureRenderTarget2D, u: float, v: float
    ) -> Color:
        """Bytes of the pixel at a part of the width and height."""
        height, width = texture_render_target._pixels.shape[:2]
        x, y = (int(max(0.0, min(1.0, f)) * (n - 1) + 0.5) for f, n in ((u, width), (v, height)))
        return cls.read_render_target_pixel(world_context_object, texture_render_target, x, y)

    @classmethod
    @api
    def read_render_target_raw_pixel(
        cls,
        world_context_object: Object | None,
        texture_render_target: TextureRenderTarget2D,
        x: int,
        y: int,
        normalize: bool = True,
    ) -> LinearColor:
        """A pixel as fractions of 255."""
        found = cls.read_render_target_pixel(world_context_object, texture_render_target, x, y)
        return LinearColor(found.r / 255, found.g / 255, found.b / 255, found.a / 255)

    @classmethod
    @api
    def read_render_target(
        cls, world_context_object: Object | None, texture_render_target: TextureRenderTarget2D, normalize: bool = True
    ) -> Array | None:
        """Bytes of all pixels, row by row."""
        return Array._of("Color", [_color(pixel) for pixel in texture_render_target._pixels.reshape(-1, 3)])


def _color(pixel: np.ndarray[tuple[int, ...], np.dtype[np.uint8]]) -> Color:
    r, g, b = map(int, pixel)
    return Color(b=b, g=g, r=r, a=255)
