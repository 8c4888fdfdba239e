"""``suite.yaml``: what an author writes of a suite. Each model holds what the definition model of its name holds.

::

    suite_id: corner-shop
    title: The corner shop
    scenes:
      - {scene_id: shop, level: shop, environment: indoor}
    repairs:
      - case_id: shop-chair
        scene_id: shop
        corruptions: [{kind: move, actor: Chair_02, by_cm: [110, -45, 0]}]
        views:
          - {name: view-01, location_cm: [300, 200, 180], target_cm: [0, 0, 60]}
          - {name: view-02, location_cm: [-300, 150, 190], target_cm: [0, 0, 60]}

Lengths are cm, angles degrees, scales factors. Actors go by their names in the scene's level, assets by their paths.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from c4s.names import InnerPath, Name, PackagePath
from c4s.records.base import Record
from c4s.records.level import Number, Vector
from c4s.records.suite import SUITE_FILE, Budget, Visibility
from cases.model import Difficulty, Group
from cases.recipe import LONGEST_CHAIN
from cases.requirements import EntitySpec, PredicateSpec

__all__ = ["SUITE_FILE", "SuiteFile"]


class ViewEntry(Record):
    """A reference camera (``CaseView``)."""

    name: Name
    location_cm: Vector
    target_cm: Vector
    fov_deg: Annotated[Number, Field(gt=1, lt=179)] = 60.0
    width: int = Field(default=1280, ge=64, le=4096)
    height: int = Field(default=720, ge=64, le=4096)


class Removal(Record):
    """The actor is missing."""

    kind: Literal["removal"]
    actor: str


class Insertion(Record):
    """An asset that does not belong stands at ``location_cm``."""

    kind: Literal["insertion"]
    mesh: PackagePath
    location_cm: Vector
    yaw_deg: Number = 0.0
    scale: Annotated[Number, Field(gt=0)] = 1.0


class Duplication(Record):
    """A second copy of the actor stands at ``location_cm``."""

    kind: Literal["duplication"]
    actor: str
    location_cm: Vector
    yaw_deg: Number | None = None


class Replacement(Record):
    """The actor shows another mesh."""

    kind: Literal["replacement"]
    actor: str
    mesh: PackagePath


class Move(Record):
    """The actor is shifted by ``by_cm``, or stands at ``to_cm``."""

    kind: Literal["move"]
    actor: str
    by_cm: Vector | None = None
    to_cm: Vector | None = None

    @model_validator(mode="after")
    def _one_place(self) -> Move:
        if (self.by_cm is None) == (self.to_cm is None):
            raise ValueError("a move has either by_cm or to_cm")
        return self


class Rotation(Record):
    """The actor is turned about the vertical by ``yaw_deg``."""

    kind: Literal["rotate"]
    actor: str
    yaw_deg: Number


class Rescale(Record):
    """The actor's scale is multiplied by ``factor``, one for all axes or one an axis."""

    kind: Literal["rescale"]
    actor: str
    factor: Annotated[Number, Field(gt=0)] | Vector


class Mirror(Record):
    """The actor is mirrored along an axis of its own."""

    kind: Literal["mirror"]
    actor: str
    axis: Literal["x", "y"] = "y"


ChangeEntry = Annotated[
    Removal | Insertion | Duplication | Replacement | Move | Rotation | Rescale | Mirror, Field(discriminator="kind")
]


class SceneEntry(Record):
    """A source scene (``SourceScene``)."""

    scene_id: Name
    level: str = Field(min_length=1)
    """Id of an imported scene, or a level document (``*.level.json``) beside the suite file."""
    environment: Literal["indoor", "outdoor"]
    title: str = ""
    packs: list[Name] = Field(default_factory=list)
    """Packs of its assets; that of an imported scene is known."""


class RepairCaseEntry(Record):
    """An image-to-scene case (``RepairCase``). Group and difficulty follow from the changes unless given."""

    case_id: Name
    scene_id: Name
    title: str = ""
    corruptions: list[ChangeEntry] = Field(min_length=1, max_length=LONGEST_CHAIN)
    views: list[ViewEntry] = Field(min_length=1)
    group: Group | None = None
    difficulty: Difficulty | None = None
    prompt: str | None = None
    budget: Budget | None = None
    visibility: Visibility = "public"
    author: Name | None = None
    """Who made the case; nobody reviews their own. The suite's first author unless given."""


class RequirementsEntry(Record):
    """The requirements of a prompt (``RequirementSpec``), in words of the prompt."""

    entities: list[EntitySpec]
    predicates: list[PredicateSpec]


class TextCaseEntry(Record):
    """A text-to-scene case (``TextCase``)."""

    case_id: Name
    scene_id: Name
    """The scene that the oracle saves."""
    title: str = ""
    description: str = Field(min_length=1)
    """The prompt's own words; palette, ground and task are written behind it."""
    requirements: RequirementsEntry | InnerPath
    """Here, or in a YAML file beside the suite file."""
    plate_m: Annotated[Number, Field(gt=0)]
    difficulty: Difficulty = "medium"
    palette: list[PackagePath] = Field(default_factory=list)
    """All assets of the scene's packs when empty."""
    ground: list[PackagePath] = Field(default_factory=list)
    minimum_actors: int = Field(default=10, ge=1)
    budget: Budget | None = None
    visibility: Visibility = "public"
    author: Name | None = None


class SelectionSet(Record):
    """One of the nested sets."""

    size: int = Field(ge=1)
    cases: list[Name]


class SelectionFile(Record):
    """What ``c4s suite select`` writes: which cases of a suite are public, chosen by scores."""

    schema_version: Literal["c4s.selection.v1"] = "c4s.selection.v1"
    suite_id: Name
    suite_digest: str
    """Of the build whose scores the cases were chosen by."""
    pool: dict[str, list[str]]
    """Configurations by whose scores they were chosen, by setting."""
    sets: list[SelectionSet]
    """The smallest first; each holds the smaller ones."""
    withdrawn: dict[Name, Name | None] = Field(default_factory=dict)
    """Cases in no set, and what took their place."""
    visibility: dict[Name, Visibility]
    """Of each case that is not withdrawn."""
    slots: dict[Name, str] = Field(default_factory=dict)
    """Scenes of packages that may be installed or not: the package, or the scene that is in its place."""


class SuiteFile(Record):
    """A suite file (``SuiteDefinition``)."""

    suite_id: Name
    title: str = Field(min_length=1)
    description: str = ""
    authors: list[Name] = Field(default_factory=list)
    scenes: list[SceneEntry] = Field(min_length=1)
    repairs: list[RepairCaseEntry] = Field(default_factory=list)
    texts: list[TextCaseEntry] = Field(default_factory=list)
    visibility: InnerPath | None = None
    """A selection file (``c4s suite select``) beside this one; it goes before what the cases say."""

    @property
    def cases(self) -> list[RepairCaseEntry | TextCaseEntry]:
        """All cases, the repairs first."""
        return [*self.repairs, *self.texts]

    def author_of(self, case: RepairCaseEntry | TextCaseEntry) -> str | None:
        """Who made a case; None where the file does not say."""
        return case.author or (self.authors[0] if self.authors else None)
