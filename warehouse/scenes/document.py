"""A snapshot as a scene document: what can be drawn, in a hundredth of the bytes.

Lengths are cm, axes Unreal's (left-handed, Z up), quaternions x, y, z, w, colours linear. ``meshes`` and ``materials``
are named by their place in those lists::

    meshes     [path, SHA-256 or "", lowest corner, highest corner]
    materials  {path, color, emissive, opacity, texture?, cut?}    texture: its SHA-256; cut: alpha below it is a hole
    actors     {name, label, class, asset, id, pose, box, hidden?, parts, state}
        pose   [x, y, z, qx, qy, qz, qw, sx, sy, sz] in the world
        box    [x, y, z, ex, ey, ez]: centre and half extents in the world
        parts  [mesh, [material of each slot], pose, or 0 where it is the actor's]
        state  recorded properties that are set

A snapshot without c4s's own keys has no parts; pages draw its actors as their boxes.
"""

from __future__ import annotations

import json
import zlib
from collections.abc import Mapping, Sequence
from typing import Any, Final

from c4s.geometry.transform import quat_from_rotator
from warehouse.scenes.content import Content

Json = dict[str, Any]
NO_MATERIAL: Final = -1
LENGTH_DIGITS, QUATERNION_DIGITS, SCALE_DIGITS, COLOUR_DIGITS = 3, 6, 5, 4
_LEVEL: Final = 9
_RAW_DEFLATE: Final = -15


def document_of(snapshot: Mapping[str, Any], content: Content | None = None) -> Json:
    """The scene document of a snapshot.

    Args:
        snapshot: as ``c4s.records.snapshot`` says.
        content: packs, which know the textures of materials; None leaves them out.
    """
    made = _Document(snapshot, content)
    actors = [made.actor(actor) for actor in snapshot["actors"]]
    return {"meshes": made.meshes, "materials": made.materials, "actors": actors}


def packed(document: Json) -> bytes:
    """A document as raw deflate of its JSON, which browsers unpack."""
    squeezer = zlib.compressobj(_LEVEL, zlib.DEFLATED, _RAW_DEFLATE)
    text = json.dumps(document, separators=(",", ":"), ensure_ascii=False)
    return squeezer.compress(text.encode()) + squeezer.flush()


def unpacked(data: bytes) -> Json:
    """The document of ``packed``."""
    document: Json = json.loads(zlib.decompress(data, _RAW_DEFLATE))
    return document


class _Document:
    """The lists that actors name by place."""

    def __init__(self, snapshot: Mapping[str, Any], content: Content | None) -> None:
        self.meshes: list[list[Any]] = []
        self.materials: list[Json] = []
        self._mesh_at: dict[str, int] = {}
        self._material_at: dict[str, int] = {}
        self._facts: Mapping[str, Any] = (snapshot.get("c4s") or {}).get("meshes", {})
        self._looks: Mapping[str, Any] = snapshot.get("material_parameter_catalog") or {}
        self._content = content

    def actor(self, actor: Mapping[str, Any]) -> Json:
        facts, transform, bounds = actor.get("c4s") or {}, actor.get("transform") or {}, actor.get("bounds") or {}
        quat = facts.get("quaternion_xyzw") or quat_from_rotator(transform.get("rotation_deg", (0.0, 0.0, 0.0)))
        pose = _pose(transform, quat)
        box = [*bounds.get("origin_cm", pose[:3]), *bounds.get("extent_cm", (0.0, 0.0, 0.0))]
        slots: dict[str, dict[int, str | None]] = {}
        for slot in actor.get("component_material_slots") or []:
            slots.setdefault(slot["component_identity"], {})[slot["slot_index"]] = slot["material_path"]
        parts = [
            part
            for component in facts.get("components", [])
            if component["mesh"] and component.get("visible", True)
            for part in self._parts(component, slots.get(f"{component['name']}|{component['class']}", {}), pose)
        ]
        made = {
            "name": actor.get("name", ""),
            "label": actor.get("label", ""),
            "class": str(actor.get("class", "")).rsplit(".", 1)[-1],
            "asset": actor.get("asset_path") or "",
            "id": actor.get("stable_actor_id", ""),
            "pose": pose,
            "box": [round(value, LENGTH_DIGITS) for value in box],
            "parts": parts,
            "state": actor.get("properties") or {},
        }
        return {**made, "hidden": 1} if facts.get("hidden") else made

    def _parts(self, component: Mapping[str, Any], slots: Mapping[int, str | None], actor: Sequence[float]) -> Any:
        mesh = self._mesh(component["mesh"])
        materials = [self._material(slots.get(index)) for index in range(max(slots, default=-1) + 1)]
        for placed in component.get("instances") or [component["transform"]]:
            pose = _pose(placed, placed["quaternion_xyzw"])
            yield [mesh, materials, 0 if pose == actor else pose]

    def _mesh(self, path: str) -> int:
        if path not in self._mesh_at:
            self._mesh_at[path] = len(self.meshes)
            facts = self._facts.get(path) or {}
            corners = [
                [round(value, LENGTH_DIGITS) for value in facts.get(f"bounds_{end}_cm", (0.0, 0.0, 0.0))]
                for end in ("min", "max")
            ]
            self.meshes.append([path, facts.get("sha256") or "", *corners])
        return self._mesh_at[path]

    def _material(self, path: str | None) -> int:
        if path is None:
            return NO_MATERIAL
        if path not in self._material_at:
            self._material_at[path] = len(self.materials)
            self.materials.append(self._look(path))
        return self._material_at[path]

    def _look(self, path: str) -> Json:
        told = self._looks.get(path) or {}
        vectors, scalars = told.get("resolved_vector_parameters", {}), told.get("resolved_scalar_parameters", {})
        known = self._content.material(path) if self._content else None
        base = vectors.get("BaseColor") or (known.base_color if known else (0.5, 0.5, 0.5))
        glow = vectors.get("EmissiveColor") or (known.emissive if known else (0.0, 0.0, 0.0))
        look: Json = {
            "path": path,
            "color": [round(value, COLOUR_DIGITS) for value in base[:3]],
            "emissive": [round(value, COLOUR_DIGITS) for value in glow[:3]],
            "opacity": scalars.get("Opacity", known.opacity if known else 1.0),
        }
        texture = self._content.texture(known) if self._content and known else None
        if known and texture:
            look["texture"] = texture[0]
            if known.alpha == "mask":
                look["cut"] = known.alpha_cutoff
        return look


def _pose(transform: Mapping[str, Any], quat: Sequence[float]) -> list[float]:
    place, scale = transform.get("location_cm", (0.0, 0.0, 0.0)), transform.get("scale", (1.0, 1.0, 1.0))
    return [
        *(round(value, LENGTH_DIGITS) for value in place),
        *(round(value, QUATERNION_DIGITS) for value in quat),
        *(round(value, SCALE_DIGITS) for value in scale),
    ]
