"""Parts of places that many scenes share: streets, squares, gardens, woods, fields, yards, waterfronts, rails, castles;
aisles, classes, wards. Each lies in the frame of the place (``at``), its middle at the origin."""

from __future__ import annotations

import math
from collections.abc import Sequence

from cases.open190.layout import Assets, Item, Pair, StagedPlace

Box = tuple[float, float, float, float]


def frontage(
    p: StagedPlace, a: Pair, b: Pair, houses: Sequence[str], gap: Pair = (0.0, 0.0), setback: Pair = (0.0, 0.0)
) -> list[Item]:
    """Houses along a line from a to b whose fronts lie on it and look to its left; each once, then over again."""
    length, yaw = math.hypot(b[0] - a[0], b[1] - a[1]), math.degrees(math.atan2(b[1] - a[1], b[0] - a[0]))
    x, number = 0.0, 0
    found: list[Item] = []
    while True:
        thing = p.thing(houses[number % len(houses)])
        number += 1
        if x + thing.width > length:
            return found
        with p.at(a[0], a[1], yaw):
            item = p.put(thing.name, x - thing.low[0], -thing.high[1] - p.uni(*setback), slack=2.0)
        p.relate("along", item, found[-1] if found else None)
        if item:
            found.append(item)
        x += thing.width + 2 + p.uni(*gap)


def street(
    p: StagedPlace,
    x0: float,
    x1: float,
    y: float,
    *,
    north: Sequence[str] = (),
    south: Sequence[str] = (),
    wide: float = 700.0,
    pavement: str = "Paving",
    trees: Sequence[str] = (),
    cars: Sequence[str] = (),
    lamps: Sequence[str] = (),
    clutter: Sequence[str] = (),
    gap: Pair = (0.0, 0.0),
    setback: Pair = (10.0, 20.0),
    road: str = "Asphalt",
    share: float = 0.6,
) -> None:
    """A road along X with pavements, parked cars, lamps and trees, and houses on both sides."""
    length = x1 - x0
    pieces = max(1, round(length / 800))
    asset = p.one("road", length=round(length / pieces, 1), wide=wide, of=road)
    for i in range(pieces):
        p.put(asset, x0 + (i + 0.5) * length / pieces, y, 0.4)
    walk = 300.0
    for side in (-1, 1):
        p.ground(
            (x0, y + side * wide / 2 - (walk if side < 0 else 0), x1, y + side * wide / 2 + (walk if side > 0 else 0)),
            pavement,
            tile=walk,
            z=0.6,
        )
        edge = y + side * (wide / 2 + 55)
        if lamps:
            p.row((x0 + 200, edge), (x1 - 200, edge), lamps, max(2, int(length / 1400)), yaw=0 if side < 0 else 180)
        if trees:
            p.row(
                (x0 + 700, edge + side * 20),
                (x1 - 700, edge + side * 20),
                trees,
                max(1, int(length / 1100)),
                jitter=20,
                scale=(0.6, 0.8),
            )
        if cars:
            for i in range(int(length / 620)):
                if p.random.random() < share:
                    p.put(
                        cars,
                        x0 + 320 + i * 620 + p.uni(-20, 20),
                        y + side * (wide / 2 - 115),
                        0.4,
                        0 if side > 0 else 180,
                    )
        if clutter:
            for _ in range(int(length / 260)):
                p.put(
                    clutter, p.uni(x0 + 60, x1 - 60), y + side * (wide / 2 + p.uni(110, 180)), 0, 0 if side < 0 else 180
                )
    line = wide / 2 + walk
    if north:
        frontage(p, (x1, y + line), (x0, y + line), north, gap, setback)
    if south:
        frontage(p, (x0, y - line), (x1, y - line), south, gap, setback)


def forest(
    p: StagedPlace,
    box: Box,
    trees: Assets,
    count: int,
    *,
    under: Assets = (),
    floor: int = 0,
    avoid: Sequence[Box] = (),
) -> None:
    """Trees at random with bushes, stones and flowers under them."""
    p.scatter(box, trees, count, clear=120, scale=(0.7, 1.15), avoid=avoid)
    if under and floor:
        p.scatter(box, under, floor, clear=15, scale=(0.8, 1.2), avoid=avoid)


def garden(
    p: StagedPlace,
    box: Box,
    *,
    beds: int = 3,
    centre: str = "",
    hedge: bool = True,
    path: str = "Gravel",
    benches: Assets = (),
    plants: Assets = (),
    trees: Assets = (),
) -> None:
    """A formal garden: crossing paths, hedges, beds of flowers, benches that look to the middle."""
    x0, y0, x1, y1 = box
    cx, cy = (x0 + x1) / 2, (y0 + y1) / 2
    p.trail([(x0, cy), (x1, cy)], 220, path)
    p.trail([(cx, y0), (cx, y1)], 220, path, z=1.6)
    if centre:
        p.put(centre, cx, cy)
    plants = plants or p.kit("flowers", 6)
    bed = p.one("bed", length=300.0, wide=130.0)
    for sx in (-1, 1):
        for sy in (-1, 1):
            qx, qy = cx + sx * (x1 - x0) / 4, cy + sy * (y1 - y0) / 4
            for i in range(beds):
                by = qy + (i - (beds - 1) / 2) * 260
                p.put(bed, qx, by, 2.0)
                for k in range(4):
                    p.put(plants, qx - 105 + 70 * k, by + p.uni(-22, 22), 0, p.uni(0, 360))
            if benches:
                p.put(benches, cx + sx * 330, cy + sy * 175, yaw=0 if sy < 0 else 180)
            if trees:
                p.put(
                    trees,
                    cx + sx * ((x1 - x0) / 2 - 190),
                    cy + sy * ((y1 - y0) / 2 - 190),
                    yaw=p.uni(0, 360),
                    scale=0.75,
                )
    if hedge:
        piece = p.kit("hedge", 2, length=300.0, high=100.0)
        for a, b in (((x0, y0), (x1, y0)), ((x1, y0), (x1, y1)), ((x1, y1), (x0, y1)), ((x0, y1), (x0, y0))):
            border(p, a, b, piece, opening=300.0)


def border(p: StagedPlace, a: Pair, b: Pair, pieces: Sequence[str], opening: float = 0.0) -> None:
    """Fences, walls or hedges end to end from a to b, with an opening in the middle."""
    length, yaw = math.hypot(b[0] - a[0], b[1] - a[1]), math.degrees(math.atan2(b[1] - a[1], b[0] - a[0]))
    step = p.thing(pieces[0]).width + 1
    count = int(length // step)
    start = (length - count * step) / 2
    for i in range(count):
        x = start + (i + 0.5) * step
        if opening and abs(x - length / 2) < opening / 2 + step * 0.3:
            continue
        with p.at(a[0], a[1], yaw):
            p.relate("in_row", p.put(pieces, x, 0))


def enclosure(p: StagedPlace, box: Box, pieces: Sequence[str], *, gate: str = "", sides: str = "SENW") -> None:
    """A fence or wall around a rectangle, with a gate in the middle of its south side."""
    x0, y0, x1, y1 = box
    for side, a, b in (
        ("S", (x0, y0), (x1, y0)),
        ("E", (x1, y0), (x1, y1)),
        ("N", (x1, y1), (x0, y1)),
        ("W", (x0, y1), (x0, y0)),
    ):
        if side in sides:
            border(p, a, b, pieces, opening=(p.thing(gate).width if gate else 300.0) if side == "S" else 0.0)
    if gate:
        p.put(gate, (x0 + x1) / 2, y0, slack=3)


def field(p: StagedPlace, box: Box, kind: str, *, soil: str = "Furrows", step: float = 130.0) -> int:
    """A field of one crop in rows along X."""
    x0, y0, x1, y1 = box
    p.ground(box, soil)
    row, count = p.one("crop", kind=kind), 0
    y = y0 + step / 2 + 20
    while y < y1 - 40:
        x = x0 + 215
        while x < x1 - 200:
            item = p.put(row, x, y)
            p.relate("in_row", item)
            count += item is not None
            x += 410
        y += step
    return count


def castle(p: StagedPlace, box: Box, *, towers: Sequence[str], gatehouse: str, wall: str) -> None:
    """Curtain walls around a rectangle with towers at the corners and a gatehouse in the south."""
    x0, y0, x1, y1 = box
    for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1)):
        p.put(towers, x, y, yaw=p.random.choice((0, 90, 180, -90)))
    p.put(gatehouse, (x0 + x1) / 2, y0, yaw=180)
    reach = max(p.thing(t).width for t in towers) / 2 + 5
    gate = p.thing(gatehouse).width / 2 + 5
    length = p.thing(wall).width + 2
    for a, b in (
        ((x0 + reach, y0), ((x0 + x1) / 2 - gate, y0)),
        (((x0 + x1) / 2 + gate, y0), (x1 - reach, y0)),
        ((x1, y0 + reach), (x1, y1 - reach)),
        ((x1 - reach, y1), (x0 + reach, y1)),
        ((x0, y1 - reach), (x0, y0 + reach)),
    ):
        span, yaw = math.hypot(b[0] - a[0], b[1] - a[1]), math.degrees(math.atan2(b[1] - a[1], b[0] - a[0]))
        count = max(1, math.ceil(span / length - 0.4))
        for i in range(count):
            t = (i + 0.5) / count
            p.put(
                wall,
                a[0] + t * (b[0] - a[0]),
                a[1] + t * (b[1] - a[1]),
                yaw=yaw + 180,
                scale=(round(span / count / length, 4), 1.0, 1.0),
                slack=4,
            )


def ring(
    p: StagedPlace,
    x: float,
    y: float,
    radius: float,
    assets: Assets,
    count: int,
    *,
    face: float = 90.0,
    start: float = 0.0,
    jitter: float = 0.0,
) -> list[Item]:
    """Things in a circle, fronts to its middle (``face`` 90) or away from it (-90)."""
    found = []
    for i in range(count):
        a = start + 360 * i / count
        item = p.put(
            assets,
            x + radius * math.cos(math.radians(a)) + p.uni(-jitter, jitter),
            y + radius * math.sin(math.radians(a)) + p.uni(-jitter, jitter),
            yaw=a + face,
        )
        p.relate("in_ring", item)
        if item:
            found.append(item)
    return found


def rails(
    p: StagedPlace,
    x0: float,
    x1: float,
    y: float,
    trains: Sequence[str] = (),
    *,
    start: float = 400.0,
    gap: float = 40.0,
) -> None:
    """A track along X with vehicles coupled on it."""
    piece = p.one("track", length=1000.0)
    count = round((x1 - x0) / 1000)
    for i in range(count):
        p.put(piece, x0 + (i + 0.5) * (x1 - x0) / count, y, 0.8, scale=(round((x1 - x0) / count / 1000, 4), 1.0, 1.0))
    x = x0 + start
    for name in trains:
        thing = p.thing(name)
        if x + thing.width > x1:
            break
        p.relate("in_row", p.put(name, x + thing.width / 2, y, 4.8 if not p.tops_only else 4.6))
        x += thing.width + gap


def waterfront(
    p: StagedPlace,
    x0: float,
    x1: float,
    y: float,
    *,
    deep: float = 3000.0,
    boats: Sequence[str],
    jetties: int = 3,
    gear: Assets = (),
    wood: str = "Planks",
    far: Assets = (),
) -> None:
    """Water to +Y of a shore line, with jetties and boats moored along them."""
    p.ground((x0, y, x1, y + deep), family="water")
    deck_piece = p.one("jetty", length=900.0, wide=260.0, high=60.0, wood=wood)
    for k in range(jetties):
        jx = x0 + (k + 0.5) * (x1 - x0) / jetties
        for part in range(2):
            deck = p.put(deck_piece, jx, y + 330 + 902 * part, yaw=90)
            if gear:
                p.on(deck, gear, 4)
        for side in (-1, 1):
            reach = 170.0
            for part in range(3):
                name = p.choose(boats)
                thing = p.thing(name)
                item = p.put(name, jx + side * (reach + thing.depth / 2), y + 250 + 780 * part, yaw=90 + p.uni(-4, 4))
                p.relate("along", item, None)
    if far:
        for _ in range(6):
            p.put(
                far, p.uni(x0 + 700, x1 - 700), p.uni(y + deep * 0.7, y + deep - 700), yaw=p.uni(-180, 180), margin=100
            )


def playground(p: StagedPlace, x: float, y: float, wide: float = 1500.0) -> None:
    """Play things on a rubber square with a low fence and benches."""
    h = wide / 2
    with p.at(x, y):
        p.ground((-h, -h, h, h), "Rubber", tile=wide / 2, z=0.8)
        things = p.kinds(
            "play", "Slide", "Swing", "Seesaw", "Sandbox", "ClimbingFrame", "Roundabout", "SpringHorse", "PlayHouse"
        )
        for i, name in enumerate(things):
            p.put(name, -h * 0.66 + h * 0.66 * (i % 3), -h * 0.62 + h * 0.64 * (i // 3), yaw=p.uni(-20, 20))
        enclosure(p, (-h, -h, h, h), p.kit("fence", 1, kind="Picket", length=250.0))
        p.row((-h * 0.6, h * 0.9), (h * 0.6, h * 0.9), p.kit("bench", 2, back=True), 3, yaw=180)


def market(p: StagedPlace, box: Box, columns: int, lines: int, goods: Assets) -> None:
    """Stalls in rows back to back with goods between them."""
    x0, y0, x1, y1 = box
    stalls = p.kinds_of(
        "stall", "ware", "Fruit", "Vegetable", "Bread", "Cheese", "Fish", "Cloth", "Pottery", "Spice", "Flower", "Book"
    )
    for j in range(lines):
        for i in range(columns):
            x, y = x0 + (i + 0.5) * (x1 - x0) / columns, y0 + (j + 0.5) * (y1 - y0) / lines
            p.relate("in_grid", p.put(stalls, x, y, yaw=0 if j % 2 else 180))
            for s in (-1, 1):
                p.put(goods, x + s * 165, y + p.uni(-60, 60), yaw=p.uni(-20, 20))


def car_park(p: StagedPlace, box: Box, cars: Sequence[str], *, share: float = 0.7) -> None:
    """Rows of parking bays, most of them taken."""
    x0, y0, x1, y1 = box
    lines = max(1, int((y1 - y0) // 1250))
    length = x1 - x0
    bay = p.one("road", length=round(length, 1), wide=550.0, mark="bays")
    p.ground(box, "Asphalt", tile=800)
    for j in range(lines):
        y = y0 + 300 + j * (y1 - y0) / lines
        p.put(bay, (x0 + x1) / 2, y, 0.8)
        count = int(length // 270)
        for i in range(count):
            if p.random.random() < share:
                p.relate(
                    "in_row",
                    p.put(
                        cars, x0 + (i + 0.5) * length / count, y + p.uni(-12, 12), 0.8, 90 * p.random.choice((1, -1))
                    ),
                )


def container_yard(
    p: StagedPlace, x: float, y: float, columns: int, lines: int, levels: int = 3, *, long_: bool = False
) -> None:
    """Blocks of stacked containers."""
    boxes = p.kit("container", 6, long=long_)
    step_x = 1240 if long_ else 640
    for i in range(columns):
        for j in range(lines):
            base = p.put(boxes, x + i * step_x, y + j * 270)
            below = base
            for level in range(p.random.randint(0, levels - 1)):
                if below is None:
                    break
                item = p.put(boxes, x + i * step_x, y + j * 270, (level + 1) * 259.4)
                p.relate("on", item, below)
                below = item


def cemetery(p: StagedPlace, box: Box, columns: int, lines: int) -> None:
    """Graves in rows behind a wall."""
    p.grid(box, p.kit("tomb", 8), columns, lines, jitter=14)


def aisles(
    p: StagedPlace,
    box: Box,
    lines: int,
    shelf: str,
    goods: Sequence[Sequence[str]],
    *,
    gap: float = 4.0,
    share: float = 0.92,
) -> int:
    """Double rows of stocked shelves along X; each row has one kind of goods."""
    x0, y0, x1, y1 = box
    thing, count = p.thing(shelf), 0
    per = int((x1 - x0) // (thing.width + 1))
    for j in range(lines):
        y = y0 + (j + 0.5) * (y1 - y0) / lines
        for side in (-1, 1):
            for i in range(per):
                item = p.put(
                    shelf,
                    x0 + (i + 0.5) * (thing.width + 1),
                    y + side * (thing.depth / 2 + 1),
                    yaw=0 if side > 0 else 180,
                )
                p.relate("in_row", item)
                count += p.stock(item, goods[(2 * j + (side > 0)) % len(goods)], gap, share)
    return count


def desks(
    p: StagedPlace,
    box: Box,
    columns: int,
    lines: int,
    desk: Assets,
    chair: Assets,
    things: Assets,
    *,
    each: int = 3,
    yaw: float = 0.0,
    must: Assets = (),
) -> None:
    """A grid of desks with a chair before and things on each."""
    for item in p.grid(box, desk, columns, lines, yaw=yaw):
        x, y = item.at(p.uni(-6, 6), item.thing.high[1] + 28)
        c = p.thing(p.choose(chair))
        p.relate("beside", p.put_world(c.name, x, y, item.yaw + 180 + p.uni(-12, 12)), item)
        if must:
            p.middle(item, must, yaw=0)
        p.on(item, things, each)
