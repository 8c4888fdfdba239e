"""What was measured of how a body can use a scene: ``evidence/navigation.json``. Pure measurements, no score.

Lengths in cm, world coordinates. The same record comes from a walkable space and from a real editor.
"""

from __future__ import annotations

import base64
import zlib
from typing import Annotated, Final, Literal, Self

from pydantic import Field, model_validator

from c4s.protocol.navigation import SAMPLES, Withheld
from c4s.records.base import Record

Triple = tuple[float, float, float]
Fall = Literal["connected", "unconnected", "unreached", "raised", "buried"]
"""A target on the floor that a way leads to from the largest component, or not, or that no cell of the mesh is near to;
one above or below the floor is scenery."""
SCENERY: Final[frozenset[Fall]] = frozenset({"raised", "buried"})
LETTERS: Final[dict[str, Fall]] = {"c": "connected", "u": "unconnected", "n": "unreached", "r": "raised", "b": "buried"}
LETTER: Final[dict[Fall, str]] = {fall: letter for letter, fall in LETTERS.items()}
NOWHERE, ELSEWHERE, MAIN, NEAR = 0, 1, 2, 3
"""Values of a map's pixels: not walkable, walkable in another component, in the largest, and within arm's length of a
solid that keeps the body off."""

FLOOR_BYTES: Final = 24
MOST_FLOORS: Final = 20_000
"""A scene whose floor falls into more rectangles has none in its record."""


class TargetRecord(Record):
    """An actor, and why it is no target."""

    index: int
    """In the snapshot."""
    name: str
    label: str
    left: str = ""
    """Empty for a target; ``no_collision``, ``kind``, ``effect``, ``surface``."""
    low_cm: Triple
    high_cm: Triple
    """Box of what collides of it."""
    hidden: bool = False
    named_out: bool = False
    """A name alone makes it no target."""


class BuildRecord(Record):
    """One build of the mesh."""

    settled: bool
    reason: str = ""
    """Why it did not."""
    cells: int = 0
    """Points of the mesh on the projection lattice."""
    component_cells: list[int] = Field(default_factory=list)
    """Points of the mesh on the component lattice, of each component from the largest (the first hundred)."""
    falls: str = Field(default="", pattern="^[cunrb]*$")
    """A letter a target, in their order: see ``LETTERS``."""
    area_m2: float | None = None
    """Of the mesh, where that is known."""


class PlaceRecord(Record):
    """Where the footprint of a target falls."""

    point_cm: Triple
    """On the mesh, on the target's own storey."""
    sample: int = Field(ge=0, lt=len(SAMPLES))
    """Which of the footprint's nine samples fell there."""


class WalkRecord(Record):
    """A route that was walked."""

    start: str = ""
    """Object name of what it starts at; empty for the anchor."""
    goal: str
    """Object name of the target."""
    goal_cm: Triple
    length_cm: float
    """Of the planned route."""
    route_cm: list[Triple]
    trace_cm: list[Triple]
    """Feet of the capsule every half second."""
    left_cm: Annotated[list[float], Field(min_length=1)]
    """What it still had to go then, along the route."""

    @model_validator(mode="after")
    def _whole(self) -> Self:
        if len(self.left_cm) != len(self.trace_cm):
            raise ValueError("a walk tells at each of its places how far it still has to go")
        return self


class NavigationMap(Record):
    """The walkable area from above, for pictures: the highest floor of each pixel."""

    low_cm: tuple[float, float]
    pixel_cm: float
    columns: int = Field(ge=0, le=1024)
    rows: int = Field(ge=0, le=1024)
    packed: str
    """A byte a pixel, row by row from the lowest y, compressed with zlib, as base64."""

    @classmethod
    def of(cls, low_cm: tuple[float, float], pixel_cm: float, columns: int, rows: int, pixels: bytes) -> Self:
        """Pack pixels."""
        packed = base64.b64encode(zlib.compress(pixels, 9)).decode()
        return cls(low_cm=low_cm, pixel_cm=pixel_cm, columns=columns, rows=rows, packed=packed)

    def pixels(self) -> bytes:
        """The pixels; ``ValueError`` where they are not as many as the map has."""
        found = zlib.decompressobj().decompress(base64.b64decode(self.packed), self.columns * self.rows + 1)
        if len(found) != self.columns * self.rows:
            raise ValueError("the map has other pixels than it says")
        return found


class NavigationFloors(Record):
    """Where a body can walk, as flat rectangles, for views in three dimensions: all floors that lie over each other."""

    count: Annotated[int, Field(ge=0, le=MOST_FLOORS)]
    packed: str
    """Six whole numbers of four bytes a rectangle (low x, low y, high x, high y and height in mm, and 1 where it is of
    the largest component), low byte first, compressed with zlib, as base64."""

    @classmethod
    def of(cls, rows: bytes) -> Self | None:
        """Pack rows of rectangles; None where they are more than a record holds."""
        count = len(rows) // FLOOR_BYTES
        if count > MOST_FLOORS:
            return None
        return cls(count=count, packed=base64.b64encode(zlib.compress(rows, 9)).decode())

    def rows(self) -> bytes:
        """The rows; ``ValueError`` where they are not as many as it says."""
        size = FLOOR_BYTES * self.count
        found = zlib.decompressobj().decompress(base64.b64decode(self.packed), size + 1)
        if len(found) != size:
            raise ValueError("there are other floors than it says")
        return found


class NavigationEvidence(Record):
    """``navigation.json``."""

    schema_version: Literal["c4s.navigation.v1"] = "c4s.navigation.v1"
    engine: str
    engine_version: str = ""
    made_by: Literal["walkable_space", "engine_mesh", "published_probe"]
    """Our voxels over the snapshot's collision bodies, the engine's own navigation mesh, or the benchmark's own probe,
    which builds once and lets nothing walk."""
    fault: Withheld | None = None
    """Why nothing could be measured."""
    detail: str = ""
    asked: dict[str, float]
    """Settings that the mesh was to have (cm, degrees)."""
    kept: dict[str, float]
    """Those that it said it had after its builds; a setting that it does not tell is left out."""
    bounds_cm: tuple[Triple, Triple] | None = None
    """Of the settled mesh."""
    ground_cm: float | None = None
    """Median height of the mesh."""
    anchor_cm: Triple | None = None
    """Where walks start."""
    small: bool = False
    """Whether it was walked from object to object."""
    targets: list[TargetRecord] = Field(default_factory=list)
    """All actors."""
    builds: list[BuildRecord] = Field(default_factory=list)
    places: list[PlaceRecord | None] = Field(default_factory=list)
    """Of each target of the last build, None where its footprint falls on no place; empty where that is not told."""
    walks: list[WalkRecord] = Field(default_factory=list)
    map: NavigationMap | None = None
    floors: NavigationFloors | None = None
    """None where they are not known, or are too many."""
    unknown: dict[str, str] = Field(default_factory=dict)
    """Actors whose collision is not known, and why."""

    @model_validator(mode="after")
    def _whole(self) -> Self:
        pool = sum(not target.left for target in self.targets)
        if any(build.settled and len(build.falls) != pool for build in self.builds):
            raise ValueError("a build tells of each target where it falls")
        if self.places and len(self.places) != pool:
            raise ValueError("places are told of each target, or of none")
        return self
