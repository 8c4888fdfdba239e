"""What a case author writes: scenes, repair cases and text cases, and the suite that holds them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

from c4s.protocol.settings import Setting
from c4s.records.binding import ReviewedBindings
from c4s.records.level import Level, Vector
from c4s.records.suite import Budget, Visibility
from cases.corruption import Corruption
from cases.recipe import Entry, Kind, Operation
from cases.requirements import RequirementSpec

Group = Literal["Restore", "Lifecycle", "Layout", "Symmetry", "Transform"]
Difficulty = Literal["easy", "medium", "hard"]

GROUP_OF_KIND: dict[Kind, Group] = {
    "removal": "Restore",
    "insertion": "Lifecycle",
    "duplication": "Lifecycle",
    "replacement": "Lifecycle",
    "move": "Layout",
    "rotate": "Transform",
    "rescale": "Transform",
    "mirror": "Symmetry",
}
"""The operation group of a case whose author names none: that of its first change."""
TEXT_BUDGET = Budget(tool_calls=800, wall_minutes=180)
INDOOR_BUDGET = Budget(tool_calls=120, wall_minutes=45)
OUTDOOR_BUDGET = Budget(tool_calls=80, wall_minutes=20)
"""Budgets of the paper (agent interface)."""


@dataclass(frozen=True)
class CaseView:
    """A reference camera: position and target in cm, horizontal field of view in degrees, picture size in pixels."""

    name: str
    location_cm: Vector
    target_cm: Vector
    fov_deg: float = 60.0
    width: int = 1280
    height: int = 720


@dataclass(frozen=True)
class SourceScene:
    """A source scene: the original level and the packs (by id) that its assets come from."""

    scene_id: str
    environment: Literal["indoor", "outdoor"]
    title: str
    level: Level
    packs: tuple[str, ...]


@dataclass(frozen=True)
class RepairCase:
    """An image-to-scene case: which changes made the corrupted copy, and the views that show the original.

    ``group`` is the authored operation group, ``difficulty`` the author's prior (targets, extent, coupling, ambiguity).
    Prompt and budget follow from the setting unless given.
    """

    case_id: str
    scene_id: str
    title: str
    corruptions: Sequence[Corruption]
    group: Group
    difficulty: Difficulty
    views: Sequence[CaseView]
    setting: Setting = "image-to-scene/outdoor"
    prompt: str | None = None
    budget: Budget | None = None
    visibility: Visibility = "public"

    @property
    def operations(self) -> list[Operation]:
        """All operations in order."""
        return [operation for corruption in self.corruptions for operation in corruption.operations]

    @property
    def entries(self) -> list[Entry]:
        """The changes in order, each with its operations by their place in ``operations``."""
        made: list[Entry] = []
        first = 0
        for corruption in self.corruptions:
            made.append(Entry(label=corruption.kind, operations=list(range(first, first + len(corruption.operations)))))
            first += len(corruption.operations)
        return made

    @property
    def kinds(self) -> list[str]:
        """The kinds of change in order."""
        return [corruption.kind for corruption in self.corruptions]


@dataclass(frozen=True)
class TextCase:
    """A text-to-scene case. ``scene_id`` names the scene that the oracle saves.

    ``palette`` holds asset paths (all assets of the scene's packs when empty), ``ground`` the flat tiles named in the
    ground block of the prompt; an empty ``ground`` leaves the block out.
    """

    case_id: str
    scene_id: str
    title: str
    description: str
    requirements: RequirementSpec
    plate_m: float
    difficulty: Difficulty
    palette: Sequence[str] = ()
    ground: Sequence[str] = ()
    minimum_actors: int = 10
    budget: Budget = field(default=TEXT_BUDGET)
    setting: Setting = "text-to-scene"
    reviewed: ReviewedBindings | None = None
    """What the author says of the entities' bindings."""
    visibility: Visibility = "public"


@dataclass(frozen=True)
class SuiteDefinition:
    """All that a suite is built from."""

    suite_id: str
    title: str
    description: str
    packs: Sequence[str]
    scenes: Sequence[SourceScene]
    cases: Sequence[RepairCase | TextCase]
    authors: Mapping[str, str] = field(default_factory=dict)
    """Who made a case, by its id."""
    most: int | None = None
    """Of each scene so many repairs are kept, the first good ones (``cases.sifting``); every case when left out."""


def difficulty_of(changes: int) -> Difficulty:
    """The difficulty of a repair whose author names none, by its number of changes."""
    return "easy" if changes == 1 else "medium" if changes < 4 else "hard"
