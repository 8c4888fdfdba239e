"""What a check of judges is made of: scenes with an edited twin, and claims whose truth follows from how they were
made."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final, Literal

from c4s.records.level import Level
from cases.graphs.ir import IREntity, IRRequirement, RequirementType

Variant = Literal["base", "edited", "restyled"]
"""A scene as it was staged; with single objects changed; at night with one material on everything."""
VARIANTS: Final[tuple[Variant, ...]] = ("base", "edited", "restyled")


@dataclass(frozen=True)
class Swap:
    """A thing that is overlaid with one material: what is true of it before, and what after."""

    asset: str
    was: str
    material: str
    """Name of a material of the pack, without ``M_``."""
    becomes: str


@dataclass(frozen=True)
class Cast:
    """Which assets of a pack, by name, play which part. Each plays one part; none is left of the authored scene."""

    removed: str
    replaced: str
    newcomer: str
    """Stands in the place of ``replaced`` after the edit."""
    absent: str
    counted: tuple[str, str, str]
    recoloured: Swap
    tipped: str
    remade: Swap
    remade_too: Swap
    mover: str
    neighbour: str
    """``mover`` stands beside it, and far from it after the edit."""
    carried: str
    carrier: str
    rowed: str
    spaced: str
    focal: str
    filler: str

    def assets(self) -> list[str]:
        """All of them."""
        swaps = [swap.asset for swap in (self.recoloured, self.remade, self.remade_too)]
        single = [value for value in vars(self).values() if isinstance(value, str)]
        return [*single, *self.counted, *swaps]


@dataclass(frozen=True)
class CheckScene:
    """A piece of an authored scene, cleared in the middle, with a cast.

    The cleared piece is 6 x 8 cells; what stands beside it, and all ground below it, is kept.
    """

    name: str
    pack: str
    source: str
    """Id of the authored scene."""
    origin_cm: tuple[float, float]
    """The corner with the lowest x and y."""
    cell_cm: float
    margin_cm: float
    floor_cm: float
    overlay: str
    """The material that covers everything in the restyled variant."""
    identities: tuple[tuple[str, str], ...]
    """What the place is, and what it is not."""
    indoors: bool
    style: tuple[str, str]
    cast: Cast
    names: dict[str, tuple[str, str]] = field(default_factory=dict)
    """Singular and plural of assets that are not called as they are named."""


@dataclass(frozen=True)
class Staged:
    """The three levels of a scene."""

    stage: CheckScene
    levels: dict[Variant, Level]


@dataclass(frozen=True)
class Claim:
    """One requirement, and the variants on which it was made to hold or not to hold."""

    row: IRRequirement
    pair: str
    """Claims and variants of one name make a pair: one holds, one does not."""
    true_on: Variant | None = None
    false_on: Variant | None = None
    operands: tuple[tuple[IRRequirement, dict[Variant, bool]], ...] = ()
    """Of a claim that is made of others: these, with their truth where the claim is asked."""

    @property
    def kind(self) -> RequirementType:
        """Its type."""
        return self.row.requirement_type


@dataclass(frozen=True)
class Sheet:
    """All claims of one scene, with the things they speak of."""

    entities: tuple[IREntity, ...]
    claims: tuple[Claim, ...]
