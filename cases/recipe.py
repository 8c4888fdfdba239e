"""The recipe format (``code4scene.recipe.v1``): what made the corrupted level of the original, as it is published.

``operations`` are atoms, applied in order. Vectors are new absolute values (cm, [pitch, yaw, roll] degrees, scale
factors), never differences; what is left out stays as it is. Every published file is read whole and written unchanged.

``entries`` is of c4s: the labels that an author gave, each with the atoms that it is made of. Published recipes have
none; ``labels_of`` reads a chain of labels from their atoms.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any, Final, Literal, Self

from pydantic import ConfigDict, Field, model_serializer, model_validator
from pydantic_core.core_schema import SerializerFunctionWrapHandler

from c4s.names import Name, PackagePath
from c4s.records.base import Record
from c4s.records.level import Label, Vector

Kind = Literal["removal", "insertion", "duplication", "replacement", "move", "rotate", "rescale", "mirror"]
KINDS: Final[tuple[Kind, ...]] = (
    *("removal", "insertion", "duplication", "replacement", "move", "rotate", "rescale", "mirror"),
)
LONGEST_CHAIN: Final = 5
"""Labels of a case: the paper's outdoor chains have one to five (appendix on case construction)."""


class _Sparse(Record):
    """A record that writes only what it was given."""

    @model_serializer(mode="wrap")
    def _given(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        written: dict[str, Any] = handler(self)
        return {name: value for name, value in written.items() if value is not None}


class ExpectedSlot(_Sparse):
    """A material slot after the operation, as a snapshot tells it."""

    component_identity: str
    """``<component name>|<class path>``."""
    is_dynamic: bool
    material_class_path: str
    material_path: PackagePath
    slot_index: int = Field(ge=0)

    @property
    def component(self) -> str:
        """Name of the component."""
        return self.component_identity.partition("|")[0]


class Expected(_Sparse):
    """What an actor is like once it is spawned or shows another mesh."""

    like: str | None = None
    """Stable id of the actor that it is like in all but its name and place."""
    component_asset_paths: list[PackagePath] | None = None
    material_slots: list[ExpectedSlot] | None = None
    tags: list[str] | None = None
    properties: dict[str, Any] | None = None


class SetTransform(_Sparse):
    """New location, rotation or scale of an actor."""

    op: Literal["set_transform"] = "set_transform"
    target: str
    location_cm: Vector | None = None
    rotation_deg: Vector | None = None
    scale: Vector | None = None

    @model_validator(mode="after")
    def _some(self) -> Self:
        if self.location_cm is None and self.rotation_deg is None and self.scale is None:
            raise ValueError("it sets neither location_cm nor rotation_deg nor scale")
        return self


class RemoveActor(_Sparse):
    """An actor goes missing."""

    op: Literal["remove_actor"] = "remove_actor"
    target: str


class SpawnActor(_Sparse):
    """An actor appears. ``source`` (``from`` in JSON) is ``{"static_mesh": path}`` or ``{"class": path_C}``."""

    op: Literal["spawn_actor"] = "spawn_actor"
    stable_id: str
    identity_tag: bool = True
    object_name: Label
    label: Label
    source: dict[Literal["static_mesh", "class"], PackagePath] = Field(alias="from", min_length=1, max_length=1)
    location_cm: Vector
    rotation_deg: Vector = (0.0, 0.0, 0.0)
    scale: Vector = (1.0, 1.0, 1.0)
    expect: Expected | None = None

    model_config = ConfigDict(populate_by_name=True)

    @property
    def like(self) -> str | None:
        """Stable id of the actor that it is made like."""
        return self.expect.like if self.expect else None


class SetStaticMesh(_Sparse):
    """A component shows another mesh; ``replaces`` is the original one."""

    op: Literal["set_static_mesh"] = "set_static_mesh"
    target: str
    component: str
    static_mesh: PackagePath
    replaces: PackagePath
    expect: Expected | None = None


class RetargetStreamingLevel(_Sparse):
    """The corrupted level streams another package, ``target`` (``to`` in JSON), than the original, ``source``
    (``from``); with ``copy_package`` it is a copy of that one."""

    op: Literal["retarget_streaming_level"] = "retarget_streaming_level"
    source: PackagePath = Field(alias="from")
    target: PackagePath = Field(alias="to")
    copy_package: bool = False
    note: str | None = None

    model_config = ConfigDict(populate_by_name=True)


Operation = Annotated[SetTransform | RemoveActor | SpawnActor | SetStaticMesh, Field(discriminator="op")]


class Entry(_Sparse):
    """An authored change: one label, and the atoms that make it by their place in ``operations``."""

    label: Kind
    operations: list[Annotated[int, Field(ge=0)]] = Field(min_length=1)


class Recipe(_Sparse):
    """A recipe in the published format."""

    schema_version: Literal["code4scene.recipe.v1"] = "code4scene.recipe.v1"
    case_id: Name
    setting: str
    scene_id: Name
    scene_spec: str | None = None
    """Path of the scene's own description, relative to the recipe."""
    source_map: PackagePath
    ground_truth_map: PackagePath
    input_map: PackagePath
    level_structure: list[RetargetStreamingLevel] = Field(default_factory=list)
    operations: list[Operation] = Field(min_length=1)
    entries: list[Entry] | None = Field(default=None, min_length=1, max_length=LONGEST_CHAIN)
    expected_input_fingerprint: str | None = None
    expected_ground_truth_fingerprint: str | None = None

    @model_validator(mode="after")
    def _whole(self) -> Self:
        named = {place for entry in self.entries or () for place in entry.operations}
        beyond = [place for place in named if place >= len(self.operations)]
        if beyond:
            raise ValueError(f"an entry names operation {max(beyond)}, and the last is {len(self.operations) - 1}")
        if self.entries is not None and (left := set(range(len(self.operations))) - named):
            raise ValueError(f"operation {min(left)} belongs to no entry")
        return self

    def plain(self) -> dict[str, Any]:
        """JSON data with the published names; values that are not set are left out."""
        return self.model_dump(mode="json", by_alias=True)

    @property
    def labels(self) -> list[Kind]:
        """The chain of labels: as authored, else as read from the atoms."""
        return [entry.label for entry in self.entries] if self.entries else labels_of(self.operations)


def labels_of(operations: Sequence[Operation]) -> list[Kind]:
    """The chain of labels that atoms amount to: each thing that is set is one, so a ``set_transform`` may be three.

    A reading: the published data gives no labels. So read, the outdoor recipes at hand have three and four, as most
    of the paper's do that have more than one. A scale with a negative factor counts as a mirror.
    """
    labels: list[Kind] = []
    for operation in operations:
        match operation:
            case RemoveActor():
                labels.append("removal")
            case SpawnActor():
                labels.append("insertion" if operation.like is None else "duplication")
            case SetStaticMesh():
                labels.append("replacement")
            case SetTransform():
                labels += ["move"] if operation.location_cm else []
                labels += ["rotate"] if operation.rotation_deg else []
                if operation.scale:
                    labels.append("mirror" if min(operation.scale) < 0 else "rescale")
    return labels
