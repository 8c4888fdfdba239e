"""An actor as a scene holds it: as plain data, or as the text of a snapshot file that is only read where it is needed.

Two actors whose compared fields are the same text are the same, which settles nearly all of a large scene. The text of
an actor is parsed only when a closer look is due.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from operator import itemgetter
from typing import Any, Protocol, TypeAlias

import msgspec

from c4s.errors import BadInput
from c4s.files import parse_json
from c4s.verify.actors.vectors import Vector3, all_valid, valid_vector

Record: TypeAlias = dict[str, Any]
_LEVEL_MARK = ":PersistentLevel."
_POSE = ("location_cm", "rotation_deg", "scale")
_COMPARED = itemgetter(
    "transform",
    "class",
    "asset_path",
    "component_asset_paths",
    "material_paths",
    "component_material_slots",
    "properties",
)


def identity(record: Record) -> str:
    """The actor's identity key: stable id, else GUID, else label, else its path inside the level (scorer fact 1).

    Stable id and label count only as text; the label and the path are taken as they stand, blanks and all.
    Raises ``BadInput`` when the record has none of them.
    """
    stable, label = record.get("stable_actor_id"), record.get("label")
    if isinstance(stable, str) and (stable := stable.strip()):
        return f"stable:{stable}"
    guid = str("" if (value := record.get("actor_guid")) is None else value).strip()
    if guid:
        return f"guid:{guid}"
    if isinstance(label, str) and label:
        return f"label:{label}"
    path = str(record.get("actor_path") or "").rpartition(_LEVEL_MARK)[2]
    if not path:
        raise BadInput("an actor has no id, GUID, label or path", todo="export the scene again")
    return f"path:{path}"


class ActorEntry(Protocol):
    """One actor of a scene."""

    @property
    def record(self) -> Record:
        """All that is recorded of the actor."""

    def identity(self) -> str:
        """Its identity key: see ``identity``."""

    def kind_text(self) -> Hashable | None:
        """What its descriptor is made of, as a key; None when it cannot be one."""

    @property
    def written(self) -> bytes | None:
        """The text of all fields that are ever compared, where the actor is text: equal means ``alike``."""

    def alike(self, other: ActorEntry) -> bool:
        """A fast yes: all fields that are ever compared are written alike.

        Alike is not yet the same where a transform holds what is no number, which equals nothing, itself included.
        """


class PlainEntry:
    """An actor as plain data."""

    __slots__ = ("record",)
    written = None

    def __init__(self, record: Record) -> None:
        self.record = record

    def identity(self) -> str:
        """See ``Entry``."""
        return identity(self.record)

    def kind_text(self) -> Hashable | None:
        """See ``Entry``."""
        read = self.record.get
        parts = read("component_asset_paths")
        texts = (read("class"), read("asset_path"), *(parts if type(parts) is list else ()))
        return texts if all(text is None or type(text) is str for text in texts) else None

    def alike(self, other: ActorEntry) -> bool:
        """See ``Entry``."""
        try:
            return repr(_COMPARED(self.record)) == repr(_COMPARED(other.record))
        except KeyError:
            return False


class TextEntry(msgspec.Struct, gc=False, eq=False):
    """An actor as text. Fields that the text lacks are empty."""

    stable_actor_id: Any = None
    class_path: msgspec.Raw = msgspec.field(name="class", default=msgspec.Raw())
    asset_path: msgspec.Raw = msgspec.Raw()
    component_asset_paths: msgspec.Raw = msgspec.Raw()
    transform: msgspec.Raw = msgspec.Raw()
    material_paths: msgspec.Raw = msgspec.Raw()
    component_material_slots: msgspec.Raw = msgspec.Raw()
    properties: msgspec.Raw = msgspec.Raw()
    text: Any = None
    parsed: Any = None
    key: Any = None
    kind: Any = None
    written: Any = None
    place: Any = None

    @classmethod
    def read(cls, text: msgspec.Raw, known: dict[bytes, bytes]) -> TextEntry:
        """``known``: the lines of earlier actors; equal ones are kept once and compared in no time.

        Raises ``msgspec.DecodeError`` when the text is no JSON object.
        """
        entry = _ENTRY.decode(text)
        entry.text, entry.parsed, entry.place = text, None, None
        stable = entry.stable_actor_id
        entry.key = f"stable:{stable}" if type(stable) is str and (stable := stable.strip()) else None
        kind = _LINE((entry.class_path, entry.asset_path, entry.component_asset_paths))
        entry.kind = known.setdefault(kind, kind)
        written = _LINE((kind, entry.transform, entry.material_paths, entry.component_material_slots, entry.properties))
        entry.written = known.setdefault(written, written)
        return entry

    @property
    def record(self) -> Record:
        """See ``Entry``."""
        if self.parsed is None:
            self.parsed = parse_json(bytes(self.text))
        record: Record = self.parsed
        return record

    def identity(self) -> str:
        """See ``Entry``."""
        key: str | None = self.key
        return identity(self.record) if key is None else key

    def kind_text(self) -> Hashable:
        """See ``Entry``."""
        text: bytes = self.kind
        return text

    def alike(self, other: ActorEntry) -> bool:
        """See ``Entry``."""
        return type(other) is TextEntry and self.written == other.written


class _Pose(msgspec.Struct, gc=False):
    location_cm: tuple[float, float, float]
    rotation_deg: tuple[float, float, float]
    scale: tuple[float, float, float]


_LINE = b"\0".join
"""JSON values side by side. None of them goes on past a zero byte, so equal lines are equal values one by one."""
_ENTRY = msgspec.json.Decoder(TextEntry)
_POSES = msgspec.json.Decoder(list[_Pose])


def read_texts(texts: Sequence[msgspec.Raw], known: dict[bytes, bytes]) -> list[ActorEntry]:
    """The actors of a scene file. ``known``: see ``TextEntry.read``, which raises ``msgspec.DecodeError``."""
    entries = [TextEntry.read(text, known) for text in texts]
    try:
        poses = _POSES.decode(b"[" + b",".join([entry.transform for entry in entries]) + b"]")
    except msgspec.DecodeError:
        return [*entries]
    for entry, pose in zip(entries, poses, strict=True):
        entry.place = pose.location_cm
    return [*entries]


def _location(entry: ActorEntry) -> Vector3 | None:
    pose = entry.record.get("transform")
    if isinstance(pose, dict) and all(valid_vector(pose.get(name)) is not None for name in _POSE):
        return valid_vector(pose["location_cm"])
    return None


def _plain_locations(entries: Sequence[ActorEntry]) -> list[Vector3] | None:
    members = [[entry.record["transform"][name] for entry in entries] for name in _POSE]
    return members[0] if all(map(all_valid, members)) else None


def posed_locations(entries: Sequence[ActorEntry]) -> Sequence[Vector3 | None]:
    """The location in cm of each actor whose location, rotation and scale are all valid vectors, else None."""
    texts = [entry for entry in entries if isinstance(entry, TextEntry)]
    if len(texts) == len(entries):
        return [_location(entry) if entry.place is None else entry.place for entry in texts]
    try:
        regular = _plain_locations(entries)
    except (TypeError, KeyError):
        regular = None
    return list(map(_location, entries)) if regular is None else regular
