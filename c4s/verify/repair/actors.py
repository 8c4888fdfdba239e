"""The actors of a scene, checked and prepared for matching."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

import msgspec

from c4s.errors import BadInput
from c4s.verify.actors.entries import ActorEntry, PlainEntry, Record, posed_locations
from c4s.verify.actors.kinds import ActorKind, Descriptor
from c4s.verify.actors.vectors import Vector3, valid_vector

Role: TypeAlias = Literal["input", "truth", "candidate"]

_CONTENT_FIELDS = (
    "class",
    "asset_path",
    "component_asset_paths",
    "transform",
    "bounds",
    "properties",
    "material_paths",
    "component_material_slots",
)


@dataclass(frozen=True, slots=True)
class RepairScene:
    """A snapshot that was read from a file: its actors as text, and how its export went."""

    actors: list[ActorEntry]
    export_metadata: Any


def by_identity(entries: Sequence[ActorEntry], role: Role) -> dict[str, ActorEntry]:
    """Actors by identity key; ``BadInput`` when two share one."""
    found = {entry.identity(): entry for entry in entries}
    if len(found) != len(entries):
        key = next(key for key, count in Counter(entry.identity() for entry in entries).items() if count > 1)
        raise BadInput(
            f"two actors have the identity {key}", where=f"{role} snapshot", todo="identities must be unique in a scene"
        )
    return found


def _plain(snapshot: Any, where: str) -> RepairScene:
    if not isinstance(snapshot, dict):
        raise BadInput("a scene snapshot must be a JSON object", where=where)
    actors = snapshot.get("actors")
    if not isinstance(actors, list):
        raise BadInput("a scene snapshot must have a list 'actors'", where=where, todo="is it a snapshot?")
    wrong = next((n for n, actor in enumerate(actors) if not isinstance(actor, dict)), None)
    if wrong is not None:
        raise BadInput(f"actor {wrong} is not a JSON object", where=where)
    return RepairScene(list(map(PlainEntry, actors)), snapshot.get("export_metadata"))


def scene_actors(snapshot: Any, role: Role) -> list[ActorEntry]:
    """The actors of a snapshot after the scene checks (scorer fact 2.1); raises ``BadInput``.

    Args:
        snapshot: a ``Scene``, or plain data.
        role: which scene of the case it is.
    """
    where = f"{role} snapshot"
    scene = snapshot if isinstance(snapshot, RepairScene) else _plain(snapshot, where)
    metadata = scene.export_metadata
    if not metadata and (role == "candidate" or not isinstance(metadata, dict)):
        return scene.actors
    status = metadata.get("status") if isinstance(metadata, dict) else None
    if status != "success":
        raise BadInput(
            f"the export of this scene did not succeed: status {status!r}", where=where, todo="export it again"
        )
    return scene.actors


class Actor(msgspec.Struct, gc=False, eq=False):
    """A semantic actor prepared for matching."""

    entry: ActorEntry
    key: str
    index: int
    kind: ActorKind
    location: Vector3 | None
    """Location in cm; None unless location, rotation and scale are all valid."""
    written: bytes | None
    """See ``Entry``."""
    content: str | None = None
    """Its canonical content, once it was needed."""

    @property
    def record(self) -> Record:
        """All that is recorded of the actor."""
        return self.entry.record

    @property
    def descriptor(self) -> Descriptor:
        """Structural descriptor."""
        return self.kind.descriptor

    def vector(self, member: str) -> Vector3 | None:
        """A member of the transform (``location_cm``, ``rotation_deg``, ``scale``), or None when it is not valid."""
        pose = self.record.get("transform")
        return valid_vector(pose.get(member)) if isinstance(pose, dict) else None

    def order(self) -> tuple[str, int]:
        """Sort key that makes results independent of export order: canonical content, then position in the export."""
        if self.content is None:
            content = {field: self.record[field] for field in _CONTENT_FIELDS if field in self.record}
            self.content = json.dumps(content, sort_keys=True)
        return self.content, self.index


def prepare(entries: Iterable[ActorEntry], keys: Iterable[str], kinds: Iterable[ActorKind]) -> list[Actor]:
    """The semantic ones of the actors, with their identities and kinds, ready for matching, in export order."""
    known = [row for row in zip(entries, keys, kinds, strict=True) if row[2].semantic]
    places = posed_locations([entry for entry, _, _ in known])
    return [
        Actor(entry, key, index, kind, place, entry.written)
        for index, ((entry, key, kind), place) in enumerate(zip(known, places, strict=True))
    ]
