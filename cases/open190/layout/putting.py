"""How one thing is put somewhere: where nothing else is, in the frame that is set."""

from __future__ import annotations

import math
import random
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from c4s.geometry.transform import normalize_axis
from c4s.records.level import Transform, Vector
from cases.model import CaseView
from cases.open190.layout.things import TOP_CM, Assets, Item, Relation
from cases.open190.space import Solid, Space, placed, solids
from cases.starter.stage import Stage, asset_path
from catalog.kits import buildings, furniture, goods, nature, outdoors, rooms, small, vehicles
from catalog.kits.maker import Assortment, KitAsset
from catalog.kits.styles import Style

VOCABULARY = (buildings, furniture, goods, nature, outdoors, rooms, small, vehicles)
"""Importing them fills the table of families."""


@dataclass
class Putting(Stage):
    """A place whose things are made by families, each put where there is room."""

    scene_id: str
    style: Style
    seed: str
    tops_only: bool = False
    """Whether things stand only on what is the top of another: so the support rule of text-to-scene wants it."""
    left_out: Counter[str] = field(default_factory=Counter)
    relations: list[Relation] = field(default_factory=list)
    items: dict[str, Item] = field(default_factory=dict)
    views: list[CaseView] = field(default_factory=list)

    def __post_init__(self) -> None:
        super().__init__(self.scene_id, {})
        self.random = random.Random(f"{self.scene_id}|{self.seed}")
        self.assortment = Assortment(self.style, f"{self.scene_id}|{self.seed}")
        self.space = Space()
        self._solids: dict[str, list[Solid]] = {}
        self._frame: list[tuple[float, float, float]] = []
        self._numbers: Counter[str] = Counter()

    @property
    def pack_id(self) -> str:
        """The pack of this place's things."""
        return f"open-{self.scene_id}"

    @property
    def content_folder(self) -> str:
        """Where the pack lies under ``/Game``."""
        return "".join(part.title() for part in self.pack_id.split("-"))

    def kit(self, family: str, count: int = 1, style: Style | None = None, **options: Any) -> list[str]:
        """Names of ``count`` things of a family (``Assortment.kit``)."""
        return self.assortment.kit(family, count, style, **options)

    def one(self, family: str, style: Style | None = None, **options: Any) -> str:
        """The name of one thing of a family."""
        return self.assortment.kit(family, 1, style, **options)[0]

    def kinds(self, family: str, *kinds: str, **options: Any) -> list[str]:
        """One thing of each named kind of a family."""
        return [self.one(family, kind=kind, **options) for kind in kinds]

    def kinds_of(self, family: str, option: str, *values: Any) -> list[str]:
        """One thing of a family for each value of an option."""
        return [self.one(family, **{option: value}) for value in values]

    def palette(self, total: int, *families: str) -> None:
        """Make more things of families, in turn, until there are ``total``: more than the place needs."""
        round_ = 1
        while len(self.assortment.things) < total:
            round_ += 1
            for family in families:
                if len(self.assortment.things) < total:
                    self.kit(family, round_, spare=True)

    def thing(self, asset: str) -> KitAsset:
        """A made thing by its name."""
        return self.assortment.things[asset]

    def choose(self, assets: Assets) -> str:
        """One of some assets."""
        return assets if isinstance(assets, str) else self.random.choice(list(assets))

    def uni(self, low: float, high: float) -> float:
        """A number of a range."""
        return round(self.random.uniform(low, high), 2)

    @contextmanager
    def at(self, x: float, y: float, yaw: float = 0.0) -> Iterator[None]:
        """What is placed inside is placed in a frame at ``x, y`` turned by ``yaw``."""
        self._frame.append((x, y, yaw))
        try:
            yield
        finally:
            self._frame.pop()

    def _world(self, x: float, y: float, yaw: float) -> tuple[float, float, float]:
        for fx, fy, turn in reversed(self._frame):
            c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
            x, y, yaw = fx + x * c - y * s, fy + x * s + y * c, yaw + turn
        return round(x, 3), round(y, 3), round(normalize_axis(yaw), 3)

    def put(
        self,
        assets: Assets,
        x: float,
        y: float,
        z: float = 0.0,
        yaw: float = 0.0,
        *,
        scale: float | Vector = 1.0,
        slack: float = 0.4,
        margin: float = 0.0,
    ) -> Item | None:
        """Stand a thing at a place; None, and counted, where it would meet another by more than ``slack`` cm."""
        return self._put(self.choose(assets), *self._world(x, y, yaw), z, scale, slack, margin)

    def put_world(self, asset: str, x: float, y: float, yaw: float, z: float = 0.0) -> Item | None:
        """Stand a thing at a place of the world, whatever the frame."""
        return self._put(asset, round(x, 3), round(y, 3), round(normalize_axis(yaw), 3), z, 1.0, 0.4, 0.0)

    def _put(
        self,
        asset: str,
        wx: float,
        wy: float,
        turn: float,
        z: float,
        scale: float | Vector,
        slack: float,
        margin: float,
    ) -> Item | None:
        thing = self.thing(asset)
        factors = (scale, scale, scale) if isinstance(scale, float | int) else scale
        height = z
        if not thing.flat:
            own = self._solids.setdefault(asset, solids(thing.shape.collision))
            low = min(solid.low for solid in own) if z <= TOP_CM and own else thing.low[2]
            height = round(z - low * factors[2], 3)
            wanted = [placed(solid, wx, wy, height, turn, factors) for solid in own]
            if not self.space.free(wanted, slack=slack, margin=margin):
                self.left_out[asset] += 1
                return None
            self.space.take(wanted)
        self.paths[asset] = asset_path(self.content_folder, thing.category, asset)
        self._numbers[asset] += 1
        label = self.add_mesh(
            f"{asset}_{self._numbers[asset]}",
            asset,
            Transform(location_cm=(wx, wy, height), rotation_deg=(0.0, turn, 0.0), scale=factors),
        )
        item = Item(label, thing, wx, wy, height, turn, factors)
        self.items[label] = item
        return item

    def relate(self, kind: str, subject: Item | None, reference: Item | None = None) -> None:
        """Record how a thing stands to another."""
        if subject is not None:
            self.relations.append(Relation(kind, subject.label, reference.label if reference else ""))
