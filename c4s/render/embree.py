"""Embree's C interface by ctypes: a device, mesh scenes, and a scene of instances of them.

The library is the one in the ``embreex`` wheel, whose own Python interface has no instancing. Its structures are
addressed by offset (``layout``), so the first use in a process traces a known packet and refuses a library that
answers otherwise.
"""

from __future__ import annotations

import ctypes
import functools
import importlib.util
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from c4s.errors import MachineryFault
from c4s.render import layout
from c4s.render.holes import filter_address, user_data
from c4s.render.tables import Holes

_TRIANGLES, _INSTANCE_GEOMETRY = 0, 121
_INDEX_BUFFER, _VERTEX_BUFFER = 0, 1
_UINT3, _FLOAT3, _FLOAT3X4_ROWS = 0x5003, 0x9003, 0x9134
_ROBUST = 4
_RAY_MASK_PROPERTY = 64
_INSTRUCTION_SET = b"isa=avx2"


class Functions(NamedTuple):
    """Addresses of Embree's packet queries, for compiled kernels."""

    intersect: int
    occluded: int


@functools.cache
def library() -> ctypes.CDLL:
    """The Embree shared library with the types of the functions used here."""
    spec = importlib.util.find_spec("embreex")
    if spec is None or not spec.submodule_search_locations:
        raise MachineryFault("the package embreex is not installed", where="renderer", todo="pip install embreex")
    folder = Path(spec.submodule_search_locations[0]).parent / "embreex.libs"
    files = sorted(folder.glob("libembree4*"))
    if not files:
        raise MachineryFault("no Embree library in the embreex package", where=str(folder))
    lib = ctypes.CDLL(str(files[0]))
    pointer, uint, integer, size = ctypes.c_void_p, ctypes.c_uint, ctypes.c_int, ctypes.c_size_t
    signatures: dict[str, tuple[Any, list[Any]]] = {
        "rtcNewDevice": (pointer, [ctypes.c_char_p]),
        "rtcReleaseDevice": (None, [pointer]),
        "rtcGetDeviceError": (integer, [pointer]),
        "rtcGetDeviceProperty": (ctypes.c_ssize_t, [pointer, integer]),
        "rtcNewScene": (pointer, [pointer]),
        "rtcReleaseScene": (None, [pointer]),
        "rtcSetSceneFlags": (None, [pointer, integer]),
        "rtcJoinCommitScene": (None, [pointer]),
        "rtcNewGeometry": (pointer, [pointer, integer]),
        "rtcReleaseGeometry": (None, [pointer]),
        "rtcCommitGeometry": (None, [pointer]),
        "rtcSetSharedGeometryBuffer": (None, [pointer, integer, uint, integer, pointer, size, size, size]),
        "rtcSetGeometryInstancedScene": (None, [pointer, pointer]),
        "rtcSetGeometryTransform": (None, [pointer, uint, integer, pointer]),
        "rtcSetGeometryMask": (None, [pointer, uint]),
        "rtcSetGeometryUserData": (None, [pointer, pointer]),
        "rtcSetGeometryIntersectFilterFunction": (None, [pointer, pointer]),
        "rtcSetGeometryOccludedFilterFunction": (None, [pointer, pointer]),
        "rtcAttachGeometry": (uint, [pointer, pointer]),
        "rtcAttachGeometryByID": (None, [pointer, pointer, uint]),
        "rtcIntersect8": (None, [pointer, pointer, pointer, pointer]),
        "rtcOccluded8": (None, [pointer, pointer, pointer, pointer]),
    }
    for name, (result, arguments) in signatures.items():
        function = getattr(lib, name)
        function.restype, function.argtypes = result, arguments
    return lib


@functools.cache
def functions() -> Functions:
    """Addresses of the packet queries, after the library has proved its layout."""
    _prove_layout()
    lib = library()

    def address(name: str) -> int:
        return ctypes.cast(getattr(lib, name), ctypes.c_void_p).value or 0

    return Functions(address("rtcIntersect8"), address("rtcOccluded8"))


class RayScene:
    """Meshes and their instances, ready for rays.

    The caller's thread joins the build: handed over instead, one thread's build is done by a worker that never sleeps
    again.

    Args:
        vertices: a (n, 3) float32 array a mesh, cm.
        faces: a (m, 3) int32 array a mesh.
        mesh_of: mesh index of each instance.
        matrices: (k, 3, 4) float32 rows of the instances' matrices.
        masks: geometry mask of each instance.
        holes: what cuts holes into each mesh, if anything does.
        threads: threads that build.
    """

    def __init__(
        self,
        vertices: Sequence[NDArray[np.float32]],
        faces: Sequence[NDArray[np.int32]],
        mesh_of: NDArray[np.int32],
        matrices: NDArray[np.float32],
        masks: NDArray[np.int32],
        holes: Sequence[Holes | None],
        threads: int,
    ) -> None:
        lib = library()
        self._device = lib.rtcNewDevice(_INSTRUCTION_SET + b",threads=%d" % max(1, threads))
        if not self._device:
            raise MachineryFault("Embree needs a processor with AVX2", where="renderer")
        self._scenes: list[int] = []
        self._buffers: list[NDArray[Any]] = []
        for mesh_vertices, mesh_faces, mesh_holes in zip(vertices, faces, holes, strict=True):
            self._scenes.append(self._mesh_scene(mesh_vertices, mesh_faces, mesh_holes))
        self.handle: int = lib.rtcNewScene(self._device)
        lib.rtcSetSceneFlags(self.handle, _ROBUST)
        rows = np.ascontiguousarray(matrices, dtype=np.float32)
        base, stride = rows.ctypes.data, 48
        for number, (mesh, mask) in enumerate(zip(mesh_of.tolist(), masks.tolist(), strict=True)):
            geometry = lib.rtcNewGeometry(self._device, _INSTANCE_GEOMETRY)
            lib.rtcSetGeometryInstancedScene(geometry, self._scenes[mesh])
            lib.rtcSetGeometryTransform(geometry, 0, _FLOAT3X4_ROWS, base + number * stride)
            lib.rtcSetGeometryMask(geometry, mask)
            lib.rtcCommitGeometry(geometry)
            lib.rtcAttachGeometryByID(self.handle, geometry, number)
            lib.rtcReleaseGeometry(geometry)
        lib.rtcJoinCommitScene(self.handle)
        code = lib.rtcGetDeviceError(self._device)
        if code:
            raise MachineryFault(f"Embree could not build the scene (error {code})", where="renderer")

    def _mesh_scene(self, vertices: NDArray[np.float32], faces: NDArray[np.int32], holes: Holes | None) -> int:
        lib = library()
        padded = np.zeros((len(vertices) + 1, 3), dtype=np.float32)
        padded[:-1] = vertices
        indices = np.ascontiguousarray(faces, dtype=np.uint32)
        self._buffers += [padded, indices]
        scene: int = lib.rtcNewScene(self._device)
        geometry = lib.rtcNewGeometry(self._device, _TRIANGLES)
        share = lib.rtcSetSharedGeometryBuffer
        share(geometry, _INDEX_BUFFER, 0, _UINT3, indices.ctypes.data, 0, 12, len(indices))
        share(geometry, _VERTEX_BUFFER, 0, _FLOAT3, padded.ctypes.data, 0, 12, len(vertices))
        lib.rtcSetGeometryMask(geometry, layout.OPAQUE_MASK | layout.TRANSLUCENT_MASK)
        if holes is not None:
            data = user_data(holes, indices)
            self._buffers += [data, holes.uvs, holes.alpha]
            lib.rtcSetGeometryUserData(geometry, data.ctypes.data)
            lib.rtcSetGeometryIntersectFilterFunction(geometry, filter_address())
            lib.rtcSetGeometryOccludedFilterFunction(geometry, filter_address())
        lib.rtcCommitGeometry(geometry)
        lib.rtcAttachGeometry(scene, geometry)
        lib.rtcReleaseGeometry(geometry)
        lib.rtcSetSceneFlags(scene, _ROBUST)
        lib.rtcJoinCommitScene(scene)
        return scene

    @property
    def masks_work(self) -> bool:
        """Whether the library was built with ray masks."""
        return bool(library().rtcGetDeviceProperty(self._device, _RAY_MASK_PROPERTY))

    def close(self) -> None:
        """Give the memory back. The scene cannot be used afterwards; closing twice is allowed."""
        if not self._device:
            return
        lib = library()
        for scene in (self.handle, *self._scenes):
            lib.rtcReleaseScene(scene)
        lib.rtcReleaseDevice(self._device)
        self._device = None
        self._scenes, self._buffers = [], []


def aligned_words(count: int) -> NDArray[np.float32]:
    """A float32 array whose first word lies on a 64-byte boundary, as packet queries need."""
    raw = np.zeros(count + 16, dtype=np.float32)
    start = (-raw.ctypes.data % 64) // 4
    return raw[start : start + count]


def _prove_layout() -> None:
    """Trace a triangle 5 cm away through a shifted, mirrored instance; compare every field that the kernels read."""
    triangle = np.array([[0, -1, -1], [0, 3, -1], [0, -1, 3]], dtype=np.float32)
    other = triangle + np.array([100, 0, 0], dtype=np.float32)
    matrices = np.zeros((3, 3, 4), dtype=np.float32)
    matrices[:, [0, 1, 2], [0, 1, 2]] = (1, -1, 1)
    matrices[:, 0, 3] = (50, 5, 3)
    scene = RayScene(
        [other, triangle],
        [np.array([[0, 1, 2]], dtype=np.int32)] * 2,
        np.array([0, 1, 1], dtype=np.int32),
        matrices,
        np.array([layout.OPAQUE_MASK, layout.OPAQUE_MASK, layout.TRANSLUCENT_MASK], dtype=np.int32),
        [None, None],
        1,
    )
    try:
        rays, valid = aligned_words(layout.RAYHIT_WORDS), aligned_words(layout.LANES).view(np.int32)
        numbers = rays.view(np.int32)
        valid[3] = -1
        rays[layout.DIRECTION + 3], rays[layout.TFAR + 3] = 1.0, 1e30
        numbers[layout.RAY_MASK + 3] = layout.OPAQUE_MASK
        for start in (layout.PRIMITIVE, layout.GEOMETRY, layout.INSTANCE):
            numbers[start : start + layout.LANES] = -1
        lib = library()
        lib.rtcIntersect8(valid.ctypes.data, scene.handle, rays.ctypes.data, None)
        normal = rays[layout.NORMAL + 3 : layout.PRIMITIVE - 2 * layout.LANES : layout.LANES]
        found = (
            round(float(rays[layout.TFAR + 3]), 4),
            int(numbers[layout.INSTANCE + 3]),
            int(numbers[layout.PRIMITIVE + 3]),
            int(numbers[layout.GEOMETRY + 3]),
            round(float(rays[layout.HIT_U + 3]), 4),
            round(float(rays[layout.HIT_V + 3]), 4),
            np.flatnonzero(normal).tolist(),
            int(numbers[layout.INSTANCE + 2]),
        )
        shadow = aligned_words(layout.RAY_WORDS)
        shadow[:] = rays[: layout.RAY_WORDS]
        shadow[layout.TFAR + 3] = 1e30
        lib.rtcOccluded8(valid.ctypes.data, scene.handle, shadow.ctypes.data, None)
        hidden = bool(shadow[layout.TFAR + 3] < 0)
        masks_work = scene.masks_work
    finally:
        scene.close()
    expected = (5.0, 1, 0, 0, 0.25, 0.25, [0], -1)
    if found != expected or not hidden or not masks_work:
        raise MachineryFault(
            f"the Embree library answers {found}, not {expected}", where="renderer", todo="install embreex 4.4.0.post1"
        )
