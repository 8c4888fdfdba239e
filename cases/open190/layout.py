"""Layout rules: how things are put into a place without penetration and with support, and what stands how to what.

Cm and degrees. At yaw 0 a front looks to +Y; a row that runs from a to b has the fronts on its left as seen from above
with X to the right and Y up. What finds no room is left out and counted (``left_out``).
"""

from __future__ import annotations

import math
import random
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

from c4s.geometry.transform import normalize_axis
from c4s.records.level import Level, Transform, Vector
from cases.corruption import with_identities
from cases.model import CaseView
from cases.open190.space import Solid, Space, placed, solids
from cases.starter.stage import Stage, asset_path
from catalog.kits import buildings, furniture, goods, nature, outdoors, rooms, small, vehicles
from catalog.kits.maker import Assortment, KitAsset, StandingSurface
from catalog.kits.styles import Style

VOCABULARY = (buildings, furniture, goods, nature, outdoors, rooms, small, vehicles)
"""Importing them fills the table of families."""
TOP_CM = 4.5
"""The support rule of text-to-scene knows only the top of a whole thing, and nothing that is further above."""
SEABED_CM = 0.6
"""Water carries nothing, so boats lie on solid ground that far below its surface: sand, or the plate of a text."""
GAP_CM = 0.2
"""Air under what stands on something: rounding never makes it sink."""
Assets = str | Sequence[str]
Pair = tuple[float, float]


@dataclass(frozen=True)
class Item:
    """A thing that was placed."""

    label: str
    thing: KitAsset
    x: float
    y: float
    z: float
    yaw: float
    scale: Vector

    def at(self, x: float, y: float) -> Pair:
        """World place of a point in the thing's axes."""
        c, s = math.cos(math.radians(self.yaw)), math.sin(math.radians(self.yaw))
        return self.x + x * self.scale[0] * c - y * self.scale[1] * s, self.y + x * self.scale[0] * s + y * self.scale[
            1
        ] * c


@dataclass(frozen=True)
class Relation:
    """How a placed thing stands to another, or to its like: ``on``, ``around``, ``in_row``, ``along``, ``in_grid``."""

    kind: str
    subject: str
    reference: str = ""


@dataclass
class StagedPlace(Stage):
    """A scene under construction."""

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

    def put_world(self, asset: str, x: float, y: float, yaw: float, z: float = 0.0) -> Item | None:
        """Stand a thing at a place of the world, whatever the frame."""
        return self._put(asset, round(x, 3), round(y, 3), round(normalize_axis(yaw), 3), z, 1.0, 0.4, 0.0)

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

    # one thing on, or around, another

    def on(
        self, item: Item | None, assets: Assets, count: int = 1, *, surface: int = -1, yaw: float | None = None
    ) -> list[Item]:
        """Stand things on a surface of another (the topmost one unless told) where there is room."""
        if item is None or not item.thing.surfaces:
            return []
        found: list[Item] = []
        top = item.thing.surfaces[surface]
        for _ in range(count):
            asset = self.choose(assets)
            for _attempt in range(8):
                turn = self.uni(-25, 25) if yaw is None else yaw
                made = self._on(item, top, asset, self.uni(-0.5, 0.5), self.uni(-0.5, 0.5), turn)
                if made is not None:
                    found.append(made)
                    break
        return found

    def _on(self, item: Item, top: StandingSurface, asset: str, u: float, v: float, turn: float) -> Item | None:
        thing = self.thing(asset)
        spare_x, spare_y = top.width - thing.width, top.depth - thing.depth
        if self.tops_only and item.thing.high[2] - top.z > TOP_CM:
            return None
        if spare_x < 0 or spare_y < 0 or thing.high[2] - thing.low[2] > top.room:
            return None
        x, y = item.at(top.x + u * spare_x, top.y + v * spare_y)
        before = self.left_out[asset]
        made = self._put(
            asset,
            round(x, 3),
            round(y, 3),
            round(normalize_axis(item.yaw + turn), 3),
            item.z + top.z * item.scale[2] + GAP_CM,
            1.0,
            0.1,
            0.0,
        )
        self.left_out[asset] = before
        self.relate("on", made, item)
        return made

    def middle(self, item: Item | None, assets: Assets, *, surface: int = -1, yaw: float = 0.0) -> Item | None:
        """Stand one thing on the middle of a surface."""
        if item is None or not item.thing.surfaces:
            return None
        return self._on(item, item.thing.surfaces[surface], self.choose(assets), 0.0, 0.0, yaw)

    def stock(self, item: Item | None, assets: Assets, gap: float = 4.0, share: float = 0.9) -> int:
        """Fill every surface of a shelf with things side by side; returns how many."""
        if item is None:
            return 0
        count = 0
        for top in item.thing.surfaces:
            x = -top.width / 2
            while True:
                thing = self.thing(self.choose(assets))
                if x + thing.width > top.width / 2:
                    break
                if self.random.random() < share and thing.high[2] - thing.low[2] <= top.room:
                    spare = top.width - thing.width
                    u = (x + thing.width / 2) / spare if spare > 1 else 0.0
                    count += (
                        self._on(item, top, thing.name, max(-0.5, min(0.5, u)), self.uni(-0.2, 0.2), 0.0) is not None
                    )
                x += thing.width + gap
        return count

    def stack(self, assets: Assets, x: float, y: float, levels: int, yaw: float = 0.0) -> Item | None:
        """Things on top of each other."""
        base = item = self.put(assets, x, y, yaw=yaw)
        for _ in range(levels - 1):
            item = self.middle(item, assets, yaw=self.uni(-8, 8)) if item else None
        return base

    def around(self, item: Item | None, assets: Assets, count: int, gap: float = 8.0) -> list[Item]:
        """Seats around a table, fronts to it: on the long sides of a long one, in a ring around another."""
        if item is None:
            return []
        thing, found = item.thing, []
        half_x, half_y = thing.width * item.scale[0] / 2, thing.depth * item.scale[1] / 2
        asset = self.choose(assets)
        deep = self.thing(asset).depth / 2
        if half_x > 1.3 * half_y:
            each = math.ceil(count / 2)
            spots = [
                (
                    (i - (each - 1) / 2) * 2 * half_x / each,
                    side * (half_y + deep + gap - 14),
                    180.0 if side > 0 else 0.0,
                )
                for side in (1, -1)
                for i in range(each)
            ][:count]
        else:
            reach = max(half_x, half_y) + deep + gap - 10
            spots = [
                (reach * math.cos(a), reach * math.sin(a), math.degrees(a) + 90)
                for a in (2 * math.pi * (i + 0.25) / count for i in range(count))
            ]
        for x, y, yaw in spots:
            wx, wy = item.at(x / item.scale[0], y / item.scale[1])
            made = self._put(
                asset,
                round(wx, 3),
                round(wy, 3),
                round(normalize_axis(item.yaw + yaw + self.uni(-7, 7)), 3),
                item.z if item.z > 5 else 0.0,
                1.0,
                0.4,
                0.0,
            )
            self.relate("around", made, item)
            if made:
                found.append(made)
        return found

    # many things

    def along(
        self,
        a: Pair,
        b: Pair,
        assets: Assets,
        gap: float | Pair = 4.0,
        *,
        z: float = 0.0,
        fill: bool = False,
        count: int = 10_000,
    ) -> list[Item]:
        """Things side by side from a to b, backs on the line: each once in order, or again and again with ``fill``."""
        names = [assets] if isinstance(assets, str) else list(assets)
        length = math.hypot(b[0] - a[0], b[1] - a[1])
        yaw, x = math.degrees(math.atan2(b[1] - a[1], b[0] - a[0])), 0.0
        found: list[Item] = []
        number = 0
        while number < count and (fill or number < len(names)):
            thing = self.thing(self.choose(names) if fill else names[number])
            number += 1
            step = gap if isinstance(gap, int | float) else self.uni(*gap)
            if x + thing.width > length:
                break
            with self.at(a[0], a[1], yaw):
                item = self.put(thing.name, x - thing.low[0], -thing.low[1] + 1, z)
            x += thing.width + step
            self.relate("along", item, found[-1] if found else None)
            if item:
                found.append(item)
        return found

    def row(
        self,
        a: Pair,
        b: Pair,
        assets: Assets,
        count: int,
        *,
        yaw: float = 0.0,
        z: float = 0.0,
        jitter: float = 0.0,
        scale: Pair = (1.0, 1.0),
    ) -> list[Item]:
        """Things at equal distances from a to b; ``yaw`` is added to the row's direction."""
        turn = math.degrees(math.atan2(b[1] - a[1], b[0] - a[0]))
        found = []
        for i in range(count):
            t = i / (count - 1) if count > 1 else 0.5
            x, y = a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])
            item = self.put(
                assets,
                x + self.uni(-jitter, jitter),
                y + self.uni(-jitter, jitter),
                z,
                turn + yaw + self.uni(-jitter, jitter) * 0.2,
                scale=self.uni(*scale),
            )
            self.relate("in_row", item)
            if item:
                found.append(item)
        return found

    def grid(
        self,
        box: tuple[float, float, float, float],
        assets: Assets,
        columns: int,
        rows_: int,
        *,
        yaw: float = 0.0,
        z: float = 0.0,
        jitter: float = 0.0,
    ) -> list[Item]:
        """Things at the crossings of columns and rows in a rectangle (x0, y0, x1, y1)."""
        x0, y0, x1, y1 = box
        found = []
        for j in range(rows_):
            for i in range(columns):
                x = x0 + (x1 - x0) * (i / (columns - 1) if columns > 1 else 0.5)
                y = y0 + (y1 - y0) * (j / (rows_ - 1) if rows_ > 1 else 0.5)
                item = self.put(
                    assets,
                    x + self.uni(-jitter, jitter),
                    y + self.uni(-jitter, jitter),
                    z,
                    yaw + self.uni(-jitter, jitter) * 0.3,
                )
                self.relate("in_grid", item)
                if item:
                    found.append(item)
        return found

    def scatter(
        self,
        box: tuple[float, float, float, float],
        assets: Assets,
        count: int,
        *,
        clear: float = 20.0,
        scale: Pair = (0.9, 1.1),
        z: float = 0.0,
        avoid: Sequence[tuple[float, float, float, float]] = (),
    ) -> list[Item]:
        """Things at random places of a rectangle, at least ``clear`` cm from others and outside ``avoid``."""
        x0, y0, x1, y1 = box
        found: list[Item] = []
        for _ in range(count):
            asset = self.choose(assets)
            for _attempt in range(8):
                x, y = self.uni(x0, x1), self.uni(y0, y1)
                if any(a <= x <= c and b <= y <= d for a, b, c, d in avoid):
                    continue
                before = self.left_out[asset]
                item = self.put(asset, x, y, z, self.uni(-180, 180), scale=self.uni(*scale), margin=clear)
                self.left_out[asset] = before
                if item is not None:
                    self.relate("scattered", item)
                    found.append(item)
                    break
            else:
                self.left_out[asset] += 1
        return found

    def palette(self, total: int, *families: str) -> None:
        """Make more things of families, in turn, until there are ``total``: more than the place needs."""
        round_ = 1
        while len(self.assortment.things) < total:
            round_ += 1
            for family in families:
                if len(self.assortment.things) < total:
                    self.kit(family, round_, spare=True)

    # ground, rooms

    def ground(
        self,
        box: tuple[float, float, float, float],
        of: str = "Grass",
        *,
        family: str = "ground",
        tile: float = 1000.0,
        z: float = 0.0,
    ) -> None:
        """Cover a rectangle with tiles of about ``tile`` cm; their upper faces lie at ``z``, water's above a plate."""
        x0, y0, x1, y1 = box
        asset = self.one(family, side=tile) if family == "water" else self.one(family, of=of, side=tile)
        if family == "water" and self.tops_only:
            z += SEABED_CM
        elif family == "water":
            self.ground(box, "Sand", tile=tile, z=z - SEABED_CM)
        columns, lines = max(1, round((x1 - x0) / tile)), max(1, round((y1 - y0) / tile))
        sx, sy = (x1 - x0) / columns / tile, (y1 - y0) / lines / tile
        for i in range(columns):
            for j in range(lines):
                self.put(
                    asset,
                    x0 + (i + 0.5) * (x1 - x0) / columns,
                    y0 + (j + 0.5) * (y1 - y0) / lines,
                    z,
                    scale=(round(sx, 5), round(sy, 5), 1.0),
                )

    def plate(self, metres: float, of: str) -> None:
        """The ground of a text scene: a square of that many metres around the origin."""
        half = 50 * metres
        self.ground((-half, -half, half, half), of, tile=metres * 10)

    def trail(self, points: Sequence[Pair], wide: float = 250.0, of: str = "Gravel", z: float = 1.0) -> None:
        """A path through points, of square pieces end to end."""
        asset, number = self.one("ground", of=of, side=wide), 0
        for a, b in pairwise(points):
            length = math.hypot(b[0] - a[0], b[1] - a[1])
            yaw, count = math.degrees(math.atan2(b[1] - a[1], b[0] - a[0])), max(1, math.ceil(length / wide))
            for i in range(count):
                t = (i + 0.5) / count
                number += 1
                self.put(asset, a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), z + 0.15 * (number % 3), yaw)

    def room(
        self,
        box: tuple[float, float, float, float],
        floor: str = "",
        *,
        high: float = 300.0,
        wall: str = "",
        module: float = 400.0,
        base: str = "",
        sides: str = "SENW",
        **kinds: Sequence[str],
    ) -> None:
        """Walls around a rectangle and a floor in it. ``S=("Plain", "Door")`` names the kinds of the modules of a side,
        over and over (S is y0, N is y1, W is x0, E is x1)."""
        x0, y0, x1, y1 = box
        wall = wall or self.random.choice(self.style.wall)
        if floor:
            self.ground(box, floor, family="floor", tile=400.0)
        for side, a, b in (
            ("S", (x0, y0 - 7), (x1, y0 - 7)),
            ("N", (x1, y1 + 7), (x0, y1 + 7)),
            ("E", (x1 + 7, y0), (x1 + 7, y1)),
            ("W", (x0 - 7, y1), (x0 - 7, y0)),
        ):
            if side not in sides:
                continue
            length = math.hypot(b[0] - a[0], b[1] - a[1])
            count = max(1, round(length / module))
            order = kinds.get(side) or ("Plain",)
            yaw = math.degrees(math.atan2(b[1] - a[1], b[0] - a[0]))
            for i in range(count):
                asset = self.one(
                    "room-wall",
                    kind=order[i % len(order)],
                    length=round(length / count, 1),
                    high=high,
                    wall=wall,
                    base=base,
                )
                t = (i + 0.5) / count
                self.put(asset, a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), 0.0, yaw, slack=3.0)
        corner = self.one("room-wall", kind="Plain", length=14.0, high=high, wall=wall, noun="CornerPost")
        for x, y, needs in (
            (x0 - 7, y0 - 7, "SW"),
            (x1 + 7, y0 - 7, "SE"),
            (x0 - 7, y1 + 7, "NW"),
            (x1 + 7, y1 + 7, "NE"),
        ):
            if all(side in sides for side in needs):
                self.put(corner, x, y, slack=3.0)

    def beams(
        self, box: tuple[float, float, float, float], high: float, count: int, of: str = "", *, truss: bool = False
    ) -> None:
        """Beams or trusses across a rectangle along X, on its walls."""
        x0, y0, x1, y1 = box
        asset = self.one("beam", length=x1 - x0 + 26, truss=truss, of=of or self.style.wood[0])
        for i in range(count):
            self.put(asset, (x0 + x1) / 2, y0 + (y1 - y0) * (i + 1) / (count + 1), high + 0.1)

    # light and eyes

    def light(
        self,
        x: float,
        y: float,
        z: float = 240.0,
        *,
        intensity: float = 3000.0,
        radius: float = 900.0,
        colour: tuple[int, int, int] = (255, 236, 208),
    ) -> None:
        """A point light; intensity in the engine's unitless measure."""
        wx, wy, _ = self._world(x, y, 0)
        self._numbers["LightPoint"] += 1
        self.add_light(
            f"LightPoint_{self._numbers['LightPoint']}",
            "PointLight",
            Transform(location_cm=(wx, wy, z)),
            intensity=intensity,
            attenuation_radius=radius,
            light_color=[*colour, 255],
        )

    def sun(
        self,
        pitch: float = -42.0,
        yaw: float = -118.0,
        *,
        intensity: float = 4.0,
        colour: tuple[int, int, int] = (255, 255, 255),
        sky: float = 1.0,
    ) -> None:
        """A sun that shines along [pitch, yaw], the light of the sky, air and thin fog."""
        self.add_light(
            "LightSun",
            "DirectionalLight",
            Transform(location_cm=(0.0, 0.0, 3000.0), rotation_deg=(pitch, yaw, 0.0)),
            intensity=intensity,
            light_source_angle=2.0,
            light_color=[*colour, 255],
        )
        self.add_light("LightSky", "SkyLight", Transform(location_cm=(0.0, 0.0, 3100.0)), intensity=sky)
        self.add_air()

    def view(self, name: str, eye: Vector, target: Vector, fov: float = 70.0) -> None:
        """A camera of this place."""
        self.views.append(CaseView(name, eye, target, fov))

    def level(self) -> Level:
        """The finished level, with a stable-id tag on every actor."""
        return with_identities(Level(package=f"/Game/C4SScenes/{self.scene_id}", actors=self.actors), self.scene_id)
