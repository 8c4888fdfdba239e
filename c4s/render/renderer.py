"""The renderer: a scene built once, pictures taken from any camera."""

from __future__ import annotations

import math
import os
import weakref
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import NDArray

from c4s.errors import BadInput
from c4s.geometry.transform import rotation_matrix
from c4s.packs.meshes import Mesh
from c4s.render.types import Camera, Grade, Instance, Lights, Mode, Picture

PLAIN = Grade()
_PIXELS = 4096
_ROWS = 16


def default_threads() -> int:
    """Threads of a renderer: ``C4S_RENDER_THREADS``, else one a processor that this process may use."""
    named = os.environ.get("C4S_RENDER_THREADS", "")
    if named and (not named.isdigit() or int(named) < 1):
        raise BadInput(f"C4S_RENDER_THREADS is {named!r}, not a positive whole number", where="renderer")
    return int(named) if named else len(os.sched_getaffinity(0))


class Renderer:
    """Takes pictures of instanced meshes by ray tracing on the processor.

    The same scene, lights and camera give the same bytes, whatever the number of threads.

    Args:
        meshes: local geometry, cm.
        instances: placements; one with a determinant of zero is not drawn.
        lights: all light of the scene.
        threads: threads to build and trace with; default ``default_threads()``.

    Raises:
        BadInput: geometry, a matrix or a material that cannot be drawn.
        MachineryFault: no usable Embree library or processor.
    """

    def __init__(
        self, meshes: Sequence[Mesh], instances: Sequence[Instance], lights: Lights, threads: int | None = None
    ) -> None:
        from c4s.render.embree import RayScene, functions
        from c4s.render.lighting import light_tables
        from c4s.render.tables import build_tables

        self._threads = threads if threads is not None else default_threads()
        self._functions = functions()
        self._lights = lights
        self._tables, geometry, self._textures, self._origin = build_tables(meshes, instances)
        self._light_tables = light_tables(lights, self._origin)
        self._scene = RayScene(
            geometry.vertices,
            geometry.faces,
            geometry.piece_of,
            geometry.matrices,
            geometry.masks,
            geometry.holes,
            self._threads,
        )
        self._release = weakref.finalize(self, self._scene.close)

    def close(self) -> None:
        """Give the scene's memory back."""
        self._release()

    def render(
        self,
        camera: Camera,
        *,
        mode: Mode = "lit",
        samples: int = 4,
        exposure_bias_ev: float = 0.0,
        grade: Grade = PLAIN,
    ) -> Picture:
        """Take a picture.

        Args:
            camera: where from.
            mode: ``lit``; or ``base_color``: the surfaces' own colour without light, black where there is none.
            samples: rays a pixel where surfaces or shadows meet, the first through its centre; elsewhere one. 4 is
                twice the resolution each way.
            exposure_bias_ev: stops added to the exposure of a lit picture.
            grade: exposure and colours of a lit picture.
        """
        from c4s.render.develop import BINS, combine_rows, develop_pixels, exposure_for, grade_table, mark_edges
        from c4s.render.kernels import trace_pixels
        from c4s.render.packets import Buffers, ViewRays, new_scratch
        from c4s.render.sampling import patterns_for, tile_order
        from c4s.render.textures import encode_table

        if mode not in ("lit", "base_color"):
            raise BadInput(f"mode {mode!r} is neither lit nor base_color", where="renderer")
        if not 1 <= samples <= 64:
            raise BadInput(f"{samples} samples a pixel is not within 1..64", where="renderer")
        if not self._release.alive:
            raise BadInput("the renderer has been closed", where="renderer")
        height, width, lit = camera.height, camera.width, mode == "lit"
        pixels = height * width

        def plane(*channels: int) -> NDArray[np.float32]:
            return np.zeros((pixels, *channels), dtype=np.float32)

        buffers = Buffers(
            plane(3),
            plane(3),
            plane(2),
            np.zeros(pixels, dtype=np.int32),
            plane(3),
            plane(3),
            np.zeros(pixels, dtype=np.int64),
            np.full(pixels, -1, dtype=np.int32),
            np.full(pixels, np.inf, dtype=np.float32),
        )
        view = ViewRays(
            _axes(camera, self._origin),
            np.uintp(self._functions.intersect),
            np.uintp(self._functions.occluded),
            np.uintp(self._scene.handle),
            lit,
        )
        patterns = patterns_for(samples)
        light, rgb = plane(3), np.zeros((pixels, 3), dtype=np.uint8)
        edge, order = np.zeros(pixels, dtype=np.bool_), tile_order(width, height)
        histograms = np.zeros((height // _ROWS + 1, BINS), dtype=np.int64)

        def trace(chosen: NDArray[np.int64], first: int, last: int) -> None:
            _in_bands(
                pool,
                len(chosen),
                _PIXELS,
                lambda low, high: trace_pixels(
                    chosen[low:high],
                    width,
                    height,
                    first,
                    last,
                    view,
                    self._tables,
                    self._textures,
                    self._light_tables,
                    patterns,
                    buffers,
                    new_scratch(),
                ),
            )

        with ThreadPoolExecutor(self._threads) as pool:
            trace(order, 0, 1)
            if samples > 1:
                _in_bands(
                    pool, height, _ROWS, lambda first, last: mark_edges(first, last, width, height, buffers, edge)
                )
                trace(order[edge[order]], 1, samples)
            _in_bands(
                pool,
                height,
                _ROWS,
                lambda first, last: combine_rows(
                    first, last, width, height, buffers, light, histograms[first // _ROWS]
                ),
            )
            exposure = self._lights.exposure_ev if grade.exposure_ev is None else grade.exposure_ev
            if exposure is None:
                exposure = exposure_for(histograms.sum(axis=0), grade.lowest_ev, grade.highest_ev)
            gain = 2.0 ** min(max(exposure + exposure_bias_ev + grade.bias_ev, -60.0), 60.0) if lit else 1.0
            colors = grade_table(grade)
            _in_bands(
                pool,
                pixels,
                16 * _PIXELS,
                lambda first, last: develop_pixels(first, last, light, gain, lit, colors, encode_table(), rgb),
            )
        return Picture(
            rgb.reshape(height, width, 3), buffers.actor.reshape(height, width), buffers.depth.reshape(height, width)
        )


def _axes(camera: Camera, origin: NDArray[np.float64]) -> NDArray[np.float64]:
    """Eye relative to ``origin``, forward, and right and up scaled to half the picture's extent at distance 1."""
    turn = rotation_matrix(camera.rotation_deg)
    half = math.tan(math.radians(camera.hfov_deg) / 2)
    return np.ascontiguousarray(
        np.stack(
            [
                np.asarray(camera.location_cm, dtype=np.float64) - origin,
                turn[:, 0],
                turn[:, 1] * half,
                turn[:, 2] * half * camera.height / camera.width,
            ]
        )
    )


def _in_bands(pool: ThreadPoolExecutor, rows: int, band: int, work: Callable[[int, int], None]) -> None:
    jobs = [pool.submit(work, first, min(first + band, rows)) for first in range(0, rows, band)]
    for job in jobs:
        job.result()
