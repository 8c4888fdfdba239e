"""What the kernels work in: ray packets, the state of a band, the camera, and the arrays that they write."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from llvmlite import ir
from numba import types as nb_types
from numba.extending import intrinsic
from numpy.typing import NDArray

from c4s.render.compiled import inner
from c4s.render.embree import aligned_words
from c4s.render.layout import DIRECTION, FLAGS, LANES, ORIGIN, RAY_ID, RAY_MASK, RAYHIT_WORDS, TFAR, TIME, TNEAR
from c4s.render.lighting import Lanes, new_lanes

FAR = 1e30


class ViewRays(NamedTuple):
    """The camera (eye, forward, and right and up scaled to half the picture) and Embree's entry points."""

    axes: NDArray[np.float64]
    intersect: np.uintp
    occluded: np.uintp
    scene: np.uintp
    lit: bool


class Buffers(NamedTuple):
    """What the kernels write, one row a pixel in reading order. Sums are over the samples of a pixel."""

    direct: NDArray[np.float32]
    """(n, 3) sum of the light that ambient occlusion leaves alone."""
    ambient: NDArray[np.float32]
    """(n, 3) sum of the light that it takes from."""
    open: NDArray[np.float32]
    """(n, 2): rays of ambient occlusion that got away, and all of them, by weight."""
    samples: NDArray[np.int32]
    normal: NDArray[np.float32]
    """(n, 3) geometric normal of the centre's surface; zero where nothing is seen."""
    point: NDArray[np.float32]
    """(n, 3) point of the centre's surface."""
    identity: NDArray[np.int64]
    """A number for the surfaces that the centre's ray met and the lights that reach them."""
    actor: NDArray[np.int32]
    depth: NDArray[np.float32]


class Packet(NamedTuple):
    """Eight rays: the words as floats and as integers, the valid lanes, and the addresses of both."""

    words: NDArray[np.float32]
    numbers: NDArray[np.int32]
    valid: NDArray[np.int32]
    address: np.uintp
    valid_address: np.uintp


class Scratch(NamedTuple):
    """What a band works in; each thread has its own."""

    primary: Packet
    shadow: Packet
    lanes: Lanes
    pixel: NDArray[np.int64]
    """Row of ``Buffers`` of each lane."""
    cell: NDArray[np.int64]
    """Place of each lane's pixel in its 4x4 tile."""
    through: NDArray[np.float64]
    """Share of each pixel's light that passes the layers met so far."""
    arriving: NDArray[np.float64]
    """(LANES, 4): direction to a local light, and its irradiance factor."""


def new_packet(words: int) -> Packet:
    """A packet without valid lanes."""
    rays, valid = aligned_words(words), aligned_words(LANES).view(np.int32)
    return Packet(rays, rays.view(np.int32), valid, np.uintp(rays.ctypes.data), np.uintp(valid.ctypes.data))


def new_scratch() -> Scratch:
    """Scratch for one band."""
    return Scratch(
        new_packet(RAYHIT_WORDS),
        new_packet(RAYHIT_WORDS),
        new_lanes(),
        np.zeros(LANES, dtype=np.int64),
        np.zeros(LANES, dtype=np.int64),
        np.zeros(LANES),
        np.zeros((LANES, 4)),
    )


def _query(typing_context: Any, function: Any, valid: Any, scene: Any, rays: Any) -> Any:
    """Call an Embree packet query by address, so that the compiled code holds no address and can be kept."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        word = ir.IntType(64)
        pointer = builder.inttoptr(arguments[0], ir.FunctionType(ir.VoidType(), [word] * 4).as_pointer())
        builder.call(pointer, [*arguments[1:], ir.Constant(word, 0)])
        return context.get_dummy_value()

    return nb_types.void(nb_types.uintp, nb_types.uintp, nb_types.uintp, nb_types.uintp), generate


query: Any = intrinsic(_query)


@inner
def aim(
    packet: Packet, k: int, point: NDArray[np.float64], near: float, x: float, y: float, z: float, far: float, mask: int
) -> None:
    words, numbers = packet.words, packet.numbers
    words[ORIGIN + k], words[ORIGIN + LANES + k], words[ORIGIN + 2 * LANES + k] = point[0], point[1], point[2]
    words[TNEAR + k], words[TIME + k], words[TFAR + k] = near, 0.0, far
    words[DIRECTION + k], words[DIRECTION + LANES + k], words[DIRECTION + 2 * LANES + k] = x, y, z
    numbers[RAY_MASK + k], numbers[RAY_ID + k], numbers[FLAGS + k] = mask, 0, 0
    packet.valid[k] = -1
