"""The records of ``evidence/contacts.json`` and ``evidence/support.json``: plain JSON, and the one check of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Final, Literal, NotRequired, TypedDict, TypeVar

import msgspec

from c4s.errors import BadInput
from c4s.verify.physics.scene import PhysicsScene, actor_name

CONTACTS_VERSION: Final = "c4s.contacts.v1"
SUPPORT_VERSION: Final = "c4s.support.v1"
State = Literal["supported", "floating", "unresolved"]


class MeasuredPopulation(TypedDict):
    """What was measured."""

    setting: str
    actors: int
    """How many the scene holds."""
    fault: str
    """Why the population is not known; empty when it is."""
    edited: list[int]
    """Positions of the edited actors in the order in which they are measured; text-to-scene has none."""


class ContactRow(TypedDict):
    """Two actors that overlap, by position and name; ``depth_cm`` is None where it is not known."""

    a: int
    b: int
    a_name: str
    b_name: str
    depth_cm: float | None
    trusted: bool


class UnknownBodies(TypedDict):
    """An actor whose bodies are not (all) known."""

    index: int
    reason: str


class ContactsRecord(TypedDict):
    """Contacts of a scene's population. Contacts that cannot change a verdict are left out."""

    schema_version: Literal["c4s.contacts.v1"]
    scene: MeasuredPopulation
    measured_beyond_cm: float
    noise_cm: float
    """Rounding of the depths."""
    with_bodies: list[int]
    """Actors that have collision bodies."""
    unknown: list[UnknownBodies]
    contacts: list[ContactRow]
    crowded: NotRequired[str]
    """Why there are too many to be measured; then none is listed."""


class SupportRow(TypedDict):
    """One tested actor. Text-to-scene has the first four alone."""

    index: int
    actor: str
    state: State
    gap_cm: float | None
    """To what is below; negative where the actor reaches into it. None: nothing is (in text-to-scene: it floats)."""
    mode: NotRequired[Literal["ground", "lateral", "none"]]
    method: NotRequired[Literal["vertices", "box"] | None]
    lateral_share: NotRequired[float | None]
    lateral_cm: NotRequired[float | None]
    held_by: NotRequired[list[str]]
    reason: NotRequired[str]


class NearState(TypedDict):
    """Whether collision bodies hold an actor."""

    index: int
    state: State


class NearBodies(TypedDict):
    """The measure that has no weight: the state of each tested actor by collision bodies near it."""

    metric: str
    states: list[NearState]


class SupportRecord(TypedDict):
    """What holds each actor of a scene's population."""

    schema_version: Literal["c4s.support.v1"]
    scene: MeasuredPopulation
    metric: str | None
    rows: list[SupportRow]
    excluded: NotRequired[int]
    """Text-to-scene: how many actors are not tested; and why nothing could be measured."""
    error: NotRequired[str]
    gap_cm: NotRequired[float]
    near_bodies: NotRequired[NearBodies]


Kind = TypeVar("Kind", ContactsRecord, SupportRecord)


def checked(scene: PhysicsScene, record: Mapping[str, Any], kind: type[Kind]) -> Kind:
    """A record as it was measured of this scene. ``BadInput`` when it is damaged, or of something else."""
    where = "contacts record" if kind is ContactsRecord else "support record"
    try:
        found = msgspec.convert(record, kind)
    except msgspec.ValidationError as error:
        raise BadInput(f"the record is damaged: {error}", where=where, todo="measure the scene again") from None
    count = len(scene.actors)
    told: list[str] = []
    if found["scene"] != scene_record(scene):
        told.append("scene")
    if kind is SupportRecord:
        told += [key for key in (("error", "excluded") if scene.whole else ("near_bodies",)) if key not in found]
    told += [name for index, name in _named(found) if not 0 <= index < count or name != actor_name(scene.actors[index])]
    if told:
        raise BadInput(
            f"the record is not of this scene: {told[0]!r} differs", where=where, todo="measure the scene again"
        )
    return found


def scene_record(scene: PhysicsScene) -> MeasuredPopulation:
    """What a record says of the scene that it is of."""
    return {
        "setting": scene.setting,
        "actors": len(scene.actors),
        "fault": scene.fault,
        "edited": [] if scene.whole else scene.order,
    }


def _named(record: Any) -> Iterator[tuple[int, str]]:
    for row in record.get("contacts", ()):
        yield row["a"], row["a_name"]
        yield row["b"], row["b_name"]
    for row in record.get("rows", ()):
        yield row["index"], row["actor"]
