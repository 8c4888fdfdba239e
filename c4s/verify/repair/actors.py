"""Reading actors of a snapshot: scene checks, structural descriptor, identity, and who counts as a semantic actor."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Literal, TypeAlias

from c4s.errors import BadInput
from c4s.verify.repair.vectors import Vector3, valid_vector

Record: TypeAlias = dict[str, Any]
Descriptor: TypeAlias = tuple[str, str, str, tuple[str, ...]]
"""Class path, static mesh, Blueprint class, sorted component assets; all normalised."""
Role: TypeAlias = Literal["input", "truth", "candidate"]

_HELPERS = frozenset({"cameraactor", "cinecameraactor", "scenecapture2d", "scenecapturecube"})
_CONTENT_FIELDS = ("class", "asset_path", "component_asset_paths", "transform", "bounds", "properties",
                   "material_paths", "component_material_slots")
_LEVEL_MARK = ":PersistentLevel."


@lru_cache(maxsize=65536)
def _normalized_text(text: str) -> str:
    text = text.strip()
    if text.endswith("'") and "'" in text[:-1]:
        text = text[text.index("'") + 1:-1]
    return text.casefold()


def normalized_path(value: Any) -> str:
    """An asset or class path without export quotes, case-folded; empty for null."""
    return "" if value is None else _normalized_text(str(value))


def short_class(value: Any) -> str:
    """Class name without its package: the part after the last ``.``, then after the last ``/``."""
    return str(value or "").rpartition(".")[2].rpartition("/")[2]


@lru_cache(maxsize=65536)
def _descriptor(class_path: Any, asset: Any, components: tuple[Any, ...]) -> Descriptor:
    kind = normalized_path(class_path)
    blueprint = kind if kind.startswith("/game/") else ""
    mesh = "" if blueprint else normalized_path(asset)
    return kind, mesh, blueprint, tuple(sorted({normalized_path(part) for part in components}))


def descriptor(record: Record) -> Descriptor:
    """The normalised structural descriptor (scorer fact 1): what the actor is, not where or how it is called."""
    parts = record.get("component_asset_paths")
    raw = record.get("class"), record.get("asset_path"), tuple(parts) if isinstance(parts, list) else ()
    try:
        return _descriptor(*raw)
    except TypeError:
        return _descriptor(str(raw[0] or ""), str(raw[1] or ""), tuple(map(str, raw[2])))


@lru_cache(maxsize=65536)
def _helper(class_path: str, asset: str) -> bool:
    name = short_class(class_path).casefold()
    return (name in _HELPERS or name.endswith("cameraactor") or name.startswith("scenecapture")
            or short_class(_normalized_text(asset)) == "matineecam_sm")


def is_semantic(record: Record) -> bool:
    """False for capture helpers (cameras, scene captures); everything else counts, lights and volumes included."""
    kind, asset = record.get("class") or "", record.get("asset_path") or ""
    return not _helper(kind if type(kind) is str else str(kind), asset if type(asset) is str else str(asset))


def identity(record: Record) -> str:
    """The actor's identity key: stable id, else GUID, else label, else its path inside the level.

    Raises ``BadInput`` when the record has none of them.
    """
    stable = record.get("stable_actor_id")
    if type(stable) is str and (stable := stable.strip()):
        return f"stable:{stable}"
    for field, name in (("stable_actor_id", "stable"), ("actor_guid", "guid"), ("label", "label")):
        value = record.get(field)
        if value is not None:
            text = str(value).strip()
            if text:
                return f"{name}:{text}"
    path = str(record.get("actor_path") or "").strip()
    if not path:
        raise BadInput("an actor has no id, GUID, label or path", todo="export the scene again")
    return f"path:{path.rpartition(_LEVEL_MARK)[2]}"


def by_identity(records: Sequence[Record], role: Role) -> dict[str, Record]:
    """Actors by identity key; ``BadInput`` when two share one."""
    found: dict[str, Record] = {}
    for record in records:
        key = identity(record)
        if key in found:
            raise BadInput(f"two actors have the identity {key}", where=f"{role} snapshot",
                           todo="identities must be unique in a scene")
        found[key] = record
    return found


def scene_actors(snapshot: Any, role: Role) -> list[Record]:
    """The actor records of a snapshot after the scene checks (scorer fact 2.1); raises ``BadInput``."""
    where = f"{role} snapshot"
    if not isinstance(snapshot, dict):
        raise BadInput("a scene snapshot must be a JSON object", where=where)
    actors = snapshot.get("actors")
    if not isinstance(actors, list):
        raise BadInput("a scene snapshot must have a list 'actors'", where=where, todo="is it a snapshot?")
    wrong = next((n for n, actor in enumerate(actors) if not isinstance(actor, dict)), None)
    if wrong is not None:
        raise BadInput(f"actor {wrong} is not a JSON object", where=where)
    metadata = snapshot.get("export_metadata")
    if metadata is None or (role == "candidate" and metadata == {}):
        return actors
    status = metadata.get("status") if isinstance(metadata, dict) else None
    if status != "success":
        raise BadInput(f"the export of this scene did not succeed: status {status!r}", where=where,
                       todo="export it again")
    return actors


@dataclass(slots=True, eq=False)
class Actor:
    """A semantic actor prepared for matching. Vectors are None when missing or invalid."""

    record: Record
    key: str
    index: int
    descriptor: Descriptor
    location: Vector3 | None
    rotation: Vector3 | None
    scale: Vector3 | None
    posed: bool
    """Whether location, rotation and scale are all valid."""
    _order: str | None = None

    def order(self) -> tuple[str, int]:
        """Sort key that makes results independent of export order: canonical content, then position in the export."""
        if self._order is None:
            content = {field: self.record[field] for field in _CONTENT_FIELDS if field in self.record}
            self._order = json.dumps(content, sort_keys=True)
        return self._order, self.index


def prepare(records: dict[str, Record]) -> list[Actor]:
    """Actors ready for matching, in export order."""
    actors = []
    for index, (key, record) in enumerate(records.items()):
        pose = record.get("transform")
        pose = pose if isinstance(pose, dict) else {}
        location, rotation = valid_vector(pose.get("location_cm")), valid_vector(pose.get("rotation_deg"))
        scale = valid_vector(pose.get("scale"))
        actors.append(Actor(record, key, index, descriptor(record), location, rotation, scale,
                            location is not None and rotation is not None and scale is not None))
    return actors
