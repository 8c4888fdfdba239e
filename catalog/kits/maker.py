"""How families make things: ``KitMaker`` chooses and builds, ``Assortment`` collects what a place needs into a pack.

A family is a function of a ``KitMaker``. It says what it makes (``say``), adds parts, and marks surfaces that things
may stand on. All choices come from one generator whose seed is the family, the number of the variant and the seed of
the place, so that equal places are equal bytes.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

from catalog.kits.materials import library
from catalog.kits.styles import Style
from catalog.shapes import AssetSpec, Builder, BuiltShape, PackSpec
from catalog.shapes.spec import asset_id, readable

T = TypeVar("T")
FamilyFunction = Callable[["KitMaker"], None]
TRIES = 6
SIZES = ("Small", "Large", "Old", "Plain", "Tall", "Wide", "Narrow", "Long", "Broad", "Little", "Second", "Third")


@dataclass(frozen=True)
class StandingSurface:
    """A level part of a thing that others may stand on: height, middle and size (cm) in the thing's own axes."""

    z: float
    x: float
    y: float
    width: float
    depth: float
    room: float = 200.0
    """Free height above it."""


class KitMaker:
    """One thing being made: its builder, its style, its choices."""

    def __init__(self, style: Style, seed: str, options: dict[str, Any]) -> None:
        self.b = Builder()
        self.style = style
        self.options = options
        self._random = random.Random(seed)
        self._roles: dict[str, str] = {}
        self.noun, self.about, self.category = "", "", ""
        self.adjectives: tuple[str, ...] = ()
        self.tags: tuple[str, ...] = ()
        self.surfaces: list[StandingSurface] = []

    def pick(self, *among: T) -> T:
        """One of some things."""
        return self._random.choice(among)

    def uni(self, low: float, high: float, step: float = 5.0) -> float:
        """A number of a range, a whole number of steps."""
        return round(self._random.uniform(low, high) / step) * step

    def chance(self, share: float) -> bool:
        """True in that share of cases."""
        return self._random.random() < share

    def opt(self, name: str, default: T) -> T:
        """What the place asks for, else the default."""
        found: T = self.options.get(name, default)
        return found

    def mat(self, role: str) -> str:
        """The material of a role in this thing: one choice a thing, or what the place asks for by the role's name."""
        if role not in self._roles:
            chosen: str = self.opt(role, "") or self.pick(*getattr(self.style, role))
            self._roles[role] = chosen
        return self._roles[role]

    def another(self, role: str) -> str:
        """A material of a role, chosen anew."""
        chosen: str = self.pick(*getattr(self.style, role))
        return chosen

    def say(self, noun: str, category: str, about: str, *adjectives: str, tags: str = "") -> None:
        """Name what is made: a noun in camel case, what tells it from its like, and a sentence about it."""
        self.noun = self.opt("noun", noun)
        self.adjectives = tuple(a for a in (self.opt("adj", ""), *adjectives) if a)
        self.about, self.category = about, category
        words = readable(self.noun).lower().split()
        self.tags = tuple(dict.fromkeys((*tags.split(), *words)))

    def top(self, z: float, width: float, depth: float, x: float = 0, y: float = 0, room: float = 200.0) -> None:
        """Mark a surface that things may stand on."""
        self.surfaces.append(StandingSurface(z, x, y, width, depth, room))


def word(material: str) -> str:
    """A material as it is spoken of: ``RedBrick`` is red brick."""
    text = readable(material).lower()
    for end in (" paint", " cloth", " plastic", " glow"):
        text = text.removesuffix(end)
    return text


def camel(material: str) -> str:
    """A material as part of a name: ``RedPaint`` is ``Red``."""
    return "".join(part.title() for part in word(material).split())


FAMILIES: dict[str, FamilyFunction] = {}
FLAT: set[str] = set()
"""Families of ground and rugs, that others stand on."""


def family(name: str, *, flat: bool = False) -> Callable[[FamilyFunction], FamilyFunction]:
    """Register a family."""

    def register(make: FamilyFunction) -> FamilyFunction:
        FAMILIES[name] = make
        if flat:
            FLAT.add(name)
        return make

    return register


@dataclass(frozen=True)
class KitAsset:
    """A made asset: what a place needs to know to put it somewhere."""

    name: str
    family: str
    noun: str
    category: str
    shape: BuiltShape
    surfaces: tuple[StandingSurface, ...]
    flat: bool

    @property
    def low(self) -> tuple[float, float, float]:
        """Lowest corner of its box, cm."""
        return self.shape.mesh.bounds_cm[0]

    @property
    def high(self) -> tuple[float, float, float]:
        """Highest corner of its box, cm."""
        return self.shape.mesh.bounds_cm[1]

    @property
    def width(self) -> float:
        """Along X."""
        return self.high[0] - self.low[0]

    @property
    def depth(self) -> float:
        """Along Y."""
        return self.high[1] - self.low[1]

    @property
    def words(self) -> str:
        """Its name in words."""
        return readable(self.name).lower()


@dataclass
class Assortment:
    """The things that a place is made of, in one style and from one seed."""

    style: Style
    seed: str
    things: dict[str, KitAsset] = field(default_factory=dict)
    specs: list[AssetSpec] = field(default_factory=list)
    categories: dict[str, str] = field(default_factory=dict)
    _asked: dict[str, list[str]] = field(default_factory=dict)

    def kit(self, family_name: str, count: int = 1, style: Style | None = None, **options: Any) -> list[str]:
        """Names of ``count`` different things of a family; the same question has the same answer."""
        style = style or self.style
        key = f"{family_name}|{style.name}|{sorted(options.items())!r}"
        made = self._asked.setdefault(key, [])
        while len(made) < count:
            made.append(self._make(family_name, f"{self.seed}|{key}|{len(made)}", style, options))
        return made[:count]

    def _make(self, family_name: str, seed: str, style: Style, options: dict[str, Any]) -> str:
        make = FAMILIES[family_name]
        for attempt in range(TRIES):
            maker = KitMaker(style, f"{seed}|{attempt}", options)
            make(maker)
            name = next((name for name in names_of(maker, attempt == TRIES - 1) if self._free(name)), "")
            if name:
                break
        chosen = f"{seed}|{attempt}"

        def build(b: Builder) -> None:
            again = KitMaker(style, chosen, options)
            again.b = b
            make(again)

        self.things[name] = KitAsset(
            name, family_name, maker.noun, maker.category, maker.b.shape(), tuple(maker.surfaces), family_name in FLAT
        )
        self.specs.append(AssetSpec(name, maker.category, maker.about, maker.tags, build))
        self.categories.setdefault(maker.category, maker.category.capitalize() + " of this place.")
        return name

    def _free(self, name: str) -> bool:
        return asset_id(name) not in {asset_id(known) for known in self.things}

    def pack(self, pack_id: str, title: str) -> PackSpec:
        """The pack of all things, with the materials that they use."""
        known = library()
        used = dict.fromkeys(name for thing in self.things.values() for name in thing.shape.materials)
        return PackSpec(
            pack_id=pack_id,
            content_folder="".join(part.title() for part in pack_id.split("-")),
            title=title,
            description=f"Things of the place {title.lower()}, in {self.style.name} style and real sizes.",
            materials=[known[name] for name in used],
            assets=self.specs,
            category_descriptions=self.categories,
        )


def names_of(maker: KitMaker, last: bool) -> Iterable[str]:
    """Names for a thing, the shortest first; the last are tried only when nothing else is free."""
    adjectives: Sequence[str] = tuple(maker.adjectives)
    noun = maker.noun
    if adjectives:
        yield adjectives[0] + noun
        for extra in adjectives[1:]:
            yield extra + adjectives[0] + noun if extra != adjectives[0] else extra + noun
    else:
        yield noun
    if last:
        stem = (adjectives[0] if adjectives else "") + noun
        for size in SIZES:
            yield size + stem
        for number in range(2, 60):
            yield f"{stem}{number}"
