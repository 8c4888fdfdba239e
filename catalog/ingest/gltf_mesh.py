"""Triangles of glTF meshes: every primitive mode, Draco, morph weights, skins, missing normals, colours of vertices."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from c4s.errors import BadInput
from c4s.packs.gltf_bounds import hold_draco
from catalog.ingest.gltf_file import GltfFile, scaled
from catalog.ingest.gltf_material import GltfMaterials, tinted
from catalog.ingest.surface import Surface

DRACO = "KHR_draco_mesh_compression"
INTEGERS = {1: np.int8, 2: np.uint8, 3: np.int16, 4: np.uint16, 5: np.int32, 6: np.uint32}
"""Draco's numbers of integer types; its decoder hands wider ones over."""
SHARES = ("COLOR_", "WEIGHTS_")
"""Attributes whose integers are shares of their type's largest value, whether or not an accessor says so."""
Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Primitive:
    """Triangles in the file's axes and units, before the node's transform; ``uvs`` with v down."""

    surface: Surface
    points: Floats
    faces: NDArray[np.int64]
    normals: Floats
    uvs: Floats
    colors: Floats | None = None
    joints: NDArray[np.int64] | None = None
    weights: Floats | None = None


class GltfMeshes:
    """Reads the primitives of meshes, each mesh and set of morph weights once."""

    def __init__(self, file: GltfFile) -> None:
        self.file, self.materials = file, GltfMaterials(file)
        self._read: dict[tuple[int, tuple[float, ...]], list[Primitive]] = {}

    def primitives(self, mesh: Any, weights: Any = None) -> list[Primitive]:
        """The primitives of a mesh under morph weights (its own when left out).

        Primitives that are points or lines are left out with a note; ``BadInput`` when one is malformed.
        """
        record = self.file.item("meshes", mesh)
        try:
            chosen = tuple(float(value) for value in (weights or record.get("weights") or ()))
            if (mesh, chosen) not in self._read:
                name = str(record.get("name") or f"mesh {mesh}")
                made = [self._primitive(one, name, chosen) for one in record.get("primitives", [])]
                self._read[mesh, chosen] = [one for one in made if one is not None]
        except (TypeError, ValueError, AttributeError, IndexError, KeyError) as error:
            raise self.file.bad(f"mesh {record.get('name') or mesh!r} is malformed: {error}") from None
        return self._read[mesh, chosen]

    def _primitive(self, record: dict[str, Any], name: str, weights: tuple[float, ...]) -> Primitive | None:
        mode = record.get("mode", 4)
        if mode not in (4, 5, 6):
            self._note(f"mesh {name!r}: {'points' if mode == 0 else 'lines'} are left out")
            return None
        decoded = self._draco(record)
        attributes = record.get("attributes", {})
        if "POSITION" not in attributes:
            raise self.file.bad(f"mesh {name!r} has no positions")

        def values(key: str) -> NDArray[Any] | None:
            if key in decoded:
                return decoded[key]
            if key not in attributes:
                return None
            found = self.file.array(attributes[key])
            return scaled(found) if key.startswith(SHARES) else found

        points = np.asarray(values("POSITION"), float)
        if points.shape[1:] != (3,):
            raise self.file.bad(f"mesh {name!r} has positions that are no vectors")
        if "faces" in decoded:
            corners = decoded["faces"].astype(np.int64).reshape(-1)
        elif "indices" in record:
            corners = self.file.array(record["indices"]).astype(np.int64).reshape(-1)
        else:
            corners = np.arange(len(points))
        faces = _triangles(corners, 4 if "faces" in decoded else mode)
        if len(faces) and not 0 <= faces.min() <= faces.max() < len(points):
            raise self.file.bad("a triangle names a vertex that does not exist")
        if not len(faces):
            self._note(f"mesh {name!r} has a primitive without triangles")
            return None
        normals, targets = values("NORMAL"), record.get("targets", [])
        for weight, target in zip(weights, targets, strict=False):
            if weight:
                points = points + weight * self.file.array(target["POSITION"]) if "POSITION" in target else points
                if normals is not None and "NORMAL" in target:
                    normals = normals + weight * self.file.array(target["NORMAL"])
        looks = self.materials.surface(record.get("material"))
        uvs = values(f"TEXCOORD_{looks.uv_set}")
        flat = (
            np.zeros((len(points), 2))
            if uvs is None or uvs.shape != (len(points), 2)
            else np.nan_to_num(np.asarray(uvs, float))
        )
        if looks.surface.texture and uvs is None:
            self._note(f"mesh {name!r} has a texture and no texture coordinates")
        if looks.uv_transform is not None:
            flat = flat @ looks.uv_transform[:2, :2].T + looks.uv_transform[:2, 2]
        joints, shares = self._skinning(values, len(points))
        surface, colors = _coloured(looks.surface, values("COLOR_0"), faces, len(points))
        if normals is None or normals.shape != points.shape:
            return _flat(Primitive(surface, points, faces, np.zeros_like(points), flat, colors, joints, shares))
        return Primitive(
            surface, points, faces, np.nan_to_num(np.asarray(normals, float)), flat, colors, joints, shares
        )

    def _skinning(self, values: Any, count: int) -> tuple[NDArray[np.int64] | None, Floats | None]:
        joints, shares, number = [], [], 0
        while (found := values(f"JOINTS_{number}")) is not None and (part := values(f"WEIGHTS_{number}")) is not None:
            joints.append(np.asarray(found, np.int64))
            shares.append(np.asarray(part, float))
            number += 1
        if not joints:
            return None, None
        total = np.concatenate(shares, axis=1)
        whole = total.sum(axis=1, keepdims=True)
        if len(total) != count:
            raise self.file.bad("a skin has as many weights as vertices")
        return np.concatenate(joints, axis=1), np.divide(total, whole, out=np.zeros_like(total), where=whole > 0)

    def _draco(self, record: dict[str, Any]) -> dict[str, NDArray[Any]]:
        """Attributes and faces of a compressed primitive; nothing for a plain one."""
        packed = record.get("extensions", {}).get(DRACO)
        if packed is None:
            return {}
        import DracoPy  # type: ignore[import-not-found]

        try:
            compressed = bytes(self.file.view(packed["bufferView"]))
            hold_draco(compressed, str(self.file.path))
            mesh = DracoPy.decode(compressed)
        except BadInput:
            raise
        except Exception as error:  # DracoPy raises its own and built-in errors for broken data
            raise self.file.bad(f"a mesh compressed with Draco cannot be read: {error}") from None
        names = {ident: name for name, ident in packed.get("attributes", {}).items()}
        found = {}
        for attribute in mesh.attributes:
            name = names.get(attribute["unique_id"])
            if name is not None:
                data = np.asarray(attribute["data"])
                described = (
                    self.file.item("accessors", record["attributes"][name])
                    if name in record.get("attributes", {})
                    else {}
                )
                whole = described.get("normalized") or name.startswith(SHARES)
                own = INTEGERS.get(attribute.get("data_type"), data.dtype)
                found[name] = scaled(data.astype(own)) if whole and data.dtype.kind in "ui" else data
        if getattr(mesh, "faces", None) is not None:
            found["faces"] = np.asarray(mesh.faces)
        return found

    def _note(self, text: str) -> None:
        if text not in self.file.notes:
            self.file.notes.append(text)


def _coloured(
    surface: Surface, colors: NDArray[Any] | None, faces: NDArray[np.int64], count: int
) -> tuple[Surface, Floats | None]:
    """Linear colours of vertices; those that are all alike go into the surface."""
    if colors is None or len(colors) != count:
        return surface, None
    rgb = np.clip(np.nan_to_num(np.asarray(colors, float))[:, :3], 0.0, 1.0)
    if np.ptp(rgb[faces].reshape(-1, 3), axis=0).max() < 1 / 512:
        return tinted(surface, rgb[faces[0, 0]]), None
    return surface, rgb


def _triangles(corners: NDArray[np.int64], mode: int) -> NDArray[np.int64]:
    """Triangles of a list (4), strip (5) or fan (6) of corners; those with two equal corners in strips are left out."""
    if mode == 4:
        return corners[: len(corners) // 3 * 3].reshape(-1, 3)
    if len(corners) < 3:
        return np.zeros((0, 3), np.int64)
    if mode == 5:
        faces = np.stack([corners[:-2], corners[1:-1], corners[2:]], axis=1)
        faces[1::2] = faces[1::2][:, [1, 0, 2]]
    else:
        faces = np.stack([np.full(len(corners) - 2, corners[0]), corners[1:-1], corners[2:]], axis=1)
    apart = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 0] != faces[:, 2])
    kept: NDArray[np.int64] = faces[apart]
    return kept


def _unwelded(made: Primitive) -> Primitive:
    """Every triangle with corners of its own."""
    each = made.faces.reshape(-1)
    return Primitive(
        made.surface,
        made.points[each],
        np.arange(len(each)).reshape(-1, 3),
        made.normals[each],
        made.uvs[each],
        None if made.colors is None else made.colors[each],
        None if made.joints is None else made.joints[each],
        None if made.weights is None else made.weights[each],
    )


def _flat(made: Primitive) -> Primitive:
    """Flat normals, as glTF asks for where a primitive has none."""
    split = _unwelded(replace(made, normals=np.zeros_like(made.points)))
    sides = split.points.reshape(-1, 3, 3)
    normals = np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0])
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.divide(normals, length, out=np.tile([0.0, 1.0, 0.0], (len(normals), 1)), where=length > 0)
    return replace(split, normals=normals.repeat(3, axis=0))
