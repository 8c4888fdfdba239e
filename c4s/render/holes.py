"""Holes that a texture's alpha cuts: a filter that Embree asks about every hit of a piece with holes (compiled).

Because Embree asks during the search, whatever a ray is for (a picture, a shadow, occlusion) it passes through a hole.
"""

from __future__ import annotations

import functools
import math
from typing import Any

import numpy as np
from llvmlite import ir
from numba import types as nb_types
from numba.extending import intrinsic
from numpy.typing import NDArray

from c4s.render.compiled import callback
from c4s.render.tables import Holes

_VALID, _DATA, _HIT, _COUNT = 0, 1, 4, 5
"""Fields of ``RTCFilterFunctionNArguments`` in 8-byte words; the count is in the lower half of its word."""
_U, _V, _PRIMITIVE = 3, 4, 5
"""Fields of a hit packet, each of ``count`` 4-byte words."""
_FACES, _UVS, _ALPHA, _WIDTH, _HEIGHT, _CUTOFF, _WORDS = 0, 1, 2, 3, 4, 5, 6


def _loader(kind: Any, width: int, real: bool = False) -> Any:
    def load(typing_context: Any, address: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            word = ir.FloatType() if real else ir.IntType(width)
            return builder.load(builder.inttoptr(arguments[0], word.as_pointer()))

        return kind(nb_types.int64), generate

    return intrinsic(load)


_int64: Any = _loader(nb_types.int64, 64)
_int32: Any = _loader(nb_types.int32, 32)
_byte: Any = _loader(nb_types.uint8, 8)
_float32: Any = _loader(nb_types.float32, 32, real=True)


def _clear(typing_context: Any, address: Any) -> Any:
    """Write a 32-bit zero to an address."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        word = ir.IntType(32)
        builder.store(ir.Constant(word, 0), builder.inttoptr(arguments[0], word.as_pointer()))
        return context.get_dummy_value()

    return nb_types.void(nb_types.int64), generate


_zero: Any = intrinsic(_clear)


def _filter(arguments: int) -> None:
    """Take back the hits of a packet whose point has an alpha below the cutoff (nearest texel, the texture repeats)."""
    valid, data, hit = (_int64(arguments + 8 * _VALID), _int64(arguments + 8 * _DATA), _int64(arguments + 8 * _HIT))
    count = _int32(arguments + 8 * _COUNT)
    faces, uvs, alpha = _int64(data + 8 * _FACES), _int64(data + 8 * _UVS), _int64(data + 8 * _ALPHA)
    width, height, cutoff = _int64(data + 8 * _WIDTH), _int64(data + 8 * _HEIGHT), _int64(data + 8 * _CUTOFF)
    for lane in range(count):
        if _int32(valid + 4 * lane) == 0:
            continue
        u = _float32(hit + 4 * (_U * count + lane))
        v = _float32(hit + 4 * (_V * count + lane))
        face = faces + 12 * np.int64(_int32(hit + 4 * (_PRIMITIVE * count + lane)))
        a, b, c = np.int64(_int32(face)), np.int64(_int32(face + 4)), np.int64(_int32(face + 8))
        w = 1.0 - u - v
        x = _float32(uvs + 8 * a) * w + _float32(uvs + 8 * b) * u + _float32(uvs + 8 * c) * v
        y = _float32(uvs + 8 * a + 4) * w + _float32(uvs + 8 * b + 4) * u + _float32(uvs + 8 * c + 4) * v
        column = min(np.int64((x - math.floor(x)) * width), width - 1)
        row = min(np.int64((y - math.floor(y)) * height), height - 1)
        if _byte(alpha + row * width + column) < cutoff:
            _zero(valid + 4 * lane)


@functools.cache
def filter_address() -> int:
    """Address of the compiled filter."""
    return int(callback(nb_types.void(nb_types.int64), _filter).address)


def user_data(holes: Holes, faces: NDArray[np.uint32]) -> NDArray[np.int64]:
    """What Embree hands to the filter with each hit; ``holes`` and ``faces`` must outlive it."""
    height, width = holes.alpha.shape
    data = np.zeros(_WORDS, dtype=np.int64)
    data[:] = (faces.ctypes.data, holes.uvs.ctypes.data, holes.alpha.ctypes.data, width, height, holes.cutoff)
    return data
