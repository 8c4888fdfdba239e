"""Shapes of proxies by kind. Each function fills a box of the given size (cm) whose bottom centre is the origin."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from catalog.shapes import Builder

Shaper = Callable[[Builder, float, float, float], None]
MAIN, ACCENT, LEAF, TRUNK = "Main", "Accent", "Leaf", "Trunk"
MIN_SOLID_CM = 0.5


def slab(b: Builder, w: float, d: float, h: float) -> None:
    """Road tiles, floors, roofs without slope, planes."""
    if min(w, d, h) < MIN_SOLID_CM:
        _sheet(b, w, d, h)
    else:
        b.box(MAIN, (w, d, h))


def _sheet(b: Builder, w: float, d: float, h: float) -> None:
    """A plane: one dimension is (almost) zero."""
    x, y = w / 2, d / 2
    if h <= min(w, d):
        b.quad(MAIN, [(-x, -y, h), (x, -y, h), (x, y, h), (-x, y, h)])
        if h > 0:
            b.quad(MAIN, [(-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)])
    elif d <= w:
        b.quad(MAIN, [(-x, -y, 0), (x, y, 0), (x, y, h), (-x, -y, h)])
    else:
        b.quad(MAIN, [(-x, -y, 0), (x, y, 0), (x, y, h), (-x, -y, h)])


def block(b: Builder, w: float, d: float, h: float) -> None:
    """Anything unnamed: a box with a lighter lid."""
    b.box(MAIN, (w, d, h * 0.88))
    b.box(ACCENT, (w * 0.9, d * 0.9, h * 0.12), (0, 0, h * 0.88))


def wall(b: Builder, w: float, d: float, h: float) -> None:
    """A wall with a plinth and a coping."""
    b.box(MAIN, (w * 0.97, d * 0.8, h * 0.96), body=None)
    b.box(ACCENT, (w, d, h * 0.08), body=None)
    b.box(ACCENT, (w, d, h * 0.05), (0, 0, h * 0.95), body=None)
    b.body_box((w, d, h))


def tower(b: Builder, w: float, d: float, h: float) -> None:
    """A shaft with a crenellated head."""
    b.box(MAIN, (w * 0.86, d * 0.86, h * 0.86))
    b.box(ACCENT, (w, d, h * 0.06), (0, 0, h * 0.86), body=None)
    for i in (-1, 0, 1):
        for j in (-1, 0, 1):
            if i or j:
                b.box(MAIN, (w * 0.2, d * 0.2, h * 0.08), (i * w * 0.4, j * d * 0.4, h * 0.92), body=None)
    b.body_box((w, d, h * 0.14), (0, 0, h * 0.86))


def column(b: Builder, w: float, d: float, h: float) -> None:
    """A round shaft with base and capital."""
    b.box(ACCENT, (w, d, h * 0.08))
    b.cylinder(MAIN, w * 0.4, h * 0.84, (0, 0, h * 0.08), squash=d / w)
    b.box(ACCENT, (w, d, h * 0.08), (0, 0, h * 0.92))


def dome(b: Builder, w: float, d: float, h: float) -> None:
    """A drum, a dome and a finial."""
    profile = [(w / 2, 0.0), (w / 2, h * 0.18)]
    profile += [(w / 2 * math.cos(t), h * (0.18 + 0.68 * math.sin(t))) for t in (0.25, 0.5, 0.8, 1.1, 1.35)]
    b.lathe(MAIN, [*profile, (0.0, h * 0.9)], squash=d / w)
    b.cylinder(ACCENT, w * 0.03, h * 0.14, (0, 0, h * 0.86), top=0.0, body=None)


def gable_roof(b: Builder, w: float, d: float, h: float) -> None:
    """A pitched roof."""
    b.gable(MAIN, (w, d, h))


def house(b: Builder, w: float, d: float, h: float) -> None:
    """Walls with windows and a door under a pitched or flat roof."""
    storeys = max(1, min(8, round(h / 320)))
    pitched = h < 2.2 * max(w, d)
    eaves = h * (0.74 if pitched else 0.96)
    b.box(MAIN, (w * 0.94, d * 0.94, eaves))
    for storey in range(storeys):
        z = eaves * (storey + 0.35) / storeys
        count = max(1, min(6, int(w / 260)))
        for index in range(count):
            x = (index + 0.5) / count * w * 0.88 - w * 0.44
            for side in (-1, 1):
                b.box(
                    ACCENT,
                    (w * 0.88 / count * 0.42, d * 0.02, eaves / storeys * 0.45),
                    (x, side * d * 0.475, z),
                    body=None,
                )
    if pitched:
        b.gable("Roof", (w, d, h - eaves), (0, 0, eaves))
    else:
        b.box("Roof", (w, d, h - eaves), (0, 0, eaves))


def tree(b: Builder, w: float, d: float, h: float) -> None:
    """A trunk and a crown of three lobes."""
    radius = max(1.0, 0.05 * min(w, d))
    b.cylinder(TRUNK, radius, h * 0.55)
    b.ellipsoid(LEAF, (w, d * 0.8, h * 0.5), (0, 0, h * 0.34), segments=10, body=None)
    b.ellipsoid(LEAF, (w * 0.7, d, h * 0.45), (0, 0, h * 0.42), segments=10, body=None)
    b.ellipsoid(LEAF, (w * 0.6, d * 0.6, h * 0.4), (0, 0, h * 0.6), segments=10, body=None)


def bush(b: Builder, w: float, d: float, h: float) -> None:
    """Low foliage."""
    b.ellipsoid(LEAF, (w, d, h), segments=10, body=None)


def vessel(b: Builder, w: float, d: float, h: float) -> None:
    """Barrels, pots, vases, jars."""
    b.lathe(MAIN, [(w * 0.36, 0), (w * 0.5, h * 0.4), (w * 0.5, h * 0.6), (w * 0.36, h), (0, h)], squash=d / w)


def crate(b: Builder, w: float, d: float, h: float) -> None:
    """A box with battens."""
    b.box(MAIN, (w * 0.96, d * 0.96, h * 0.98), body=None)
    for side in (-1, 1):
        b.box(ACCENT, (w, d * 0.12, h), (0, side * d * 0.44, 0), body=None)
        b.box(ACCENT, (w * 0.12, d, h), (side * w * 0.44, 0, 0), body=None)
    b.body_box((w, d, h))


def awning(b: Builder, w: float, d: float, h: float) -> None:
    """A slanted cloth on posts; without posts where it is flat."""
    drop = h * 0.25 if h > 120 else h
    stripes = 6
    for index in range(stripes):
        x0, x1 = (w * (index + k) / stripes - w / 2 for k in (0, 1))
        b.quad(
            MAIN if index % 2 else ACCENT,
            [(x0, d / 2, h - drop), (x1, d / 2, h - drop), (x1, -d / 2, h), (x0, -d / 2, h)],
        )
    if drop < h:
        for x in (-1, 1):
            post = min(6.0, w * 0.05, d * 0.2)
            b.box(TRUNK, (post, post, h - drop), (x * (w - post) / 2, (d - post) / 2, 0))
            b.box(TRUNK, (post, post, h), (x * (w - post) / 2, (post - d) / 2, 0))


def arch(b: Builder, w: float, d: float, h: float) -> None:
    """A wall with a round-topped opening, through its thinner side."""
    if w >= d:
        b.arch(MAIN, (w, d, h), (w * 0.6, h * 0.8))
    else:
        b.arch(MAIN, (d, w, h), (d * 0.6, h * 0.8), rot=(0, 90, 0))


def stairs(b: Builder, w: float, d: float, h: float) -> None:
    """Steps that rise along the longer side."""
    count = max(2, min(14, round(h / 18)))
    for index in range(count):
        rise = h * (index + 1) / count
        if d >= w:
            b.box(MAIN, (w, d / count, rise), (0, d * (index + 0.5) / count - d / 2, 0))
        else:
            b.box(MAIN, (w / count, d, rise), (w * (index + 0.5) / count - w / 2, 0, 0))


def fence(b: Builder, w: float, d: float, h: float) -> None:
    """Posts and rails along the longer side."""
    length, thick = max(w, d), min(w, d)
    yaw = 0.0 if w >= d else 90.0
    with b.moved((0, 0, 0), (0, yaw, 0)):
        count = max(2, min(16, round(length / 90) + 1))
        post = min(thick, length / count * 0.4)
        for index in range(count):
            b.box(ACCENT, (post, thick, h), ((length - post) * (index / (count - 1) - 0.5), 0, 0), body=None)
        for level in (0.35, 0.8):
            b.box(MAIN, (length, thick * 0.5, h * 0.1), (0, 0, h * level), body=None)
        b.body_box((length, thick, h))


def lamp(b: Builder, w: float, d: float, h: float) -> None:
    """A pole with a shade; only the shade where it is low."""
    if h < 1.5 * max(w, d):
        b.ellipsoid("Glow", (w, d, h), segments=12)
        return
    base = 0.12 * h
    b.cylinder(MAIN, min(w, d) * 0.12, h - base)
    b.cylinder(MAIN, min(w, d) * 0.3, h * 0.04)
    b.box("Glow", (w, d, base), (0, 0, h - base))


def table(b: Builder, w: float, d: float, h: float) -> None:
    """A top on four legs."""
    top, leg = min(h * 0.14, 8.0), min(w, d) * 0.1
    b.box(MAIN, (w, d, top), (0, 0, h - top))
    for x in (-1, 1):
        for y in (-1, 1):
            b.box(ACCENT, (leg, leg, h - top), (x * (w / 2 - leg), y * (d / 2 - leg), 0))


def chair(b: Builder, w: float, d: float, h: float) -> None:
    """A seat on legs with a back at -Y."""
    seat = h * 0.48
    table(b, w, d, seat)
    b.box(MAIN, (w, d * 0.12, h - seat), (0, -d * 0.44, seat))


def sign(b: Builder, w: float, d: float, h: float) -> None:
    """A board, on a pole where it is high."""
    if h > 1.8 * max(w, d):
        b.cylinder(TRUNK, max(0.6, 0.1 * min(w, d)), h * 0.7)
        b.box(MAIN, (w, d, h * 0.3), (0, 0, h * 0.7))
    else:
        b.box(MAIN, (w, d, h))


def window(b: Builder, w: float, d: float, h: float) -> None:
    """A frame with panes."""
    if w < d:
        with b.moved((0, 0, 0), (0, 90, 0)):
            return window(b, d, w, h)
    rim = 0.1 * min(w, h)
    b.box("Pane", (w - 2 * rim, d * 0.4, h - 2 * rim), (0, 0, rim), body=None)
    for x in (-1, 1):
        b.box(MAIN, (rim, d, h), (x * (w - rim) / 2, 0, 0), body=None)
    for z in (0.0, (h - rim) / 2, h - rim):
        b.box(MAIN, (w, d, rim), (0, 0, z), body=None)
    b.body_box((w, d, h))
    return None


def door(b: Builder, w: float, d: float, h: float) -> None:
    """A leaf with panels and a frame."""
    if w < d:
        with b.moved((0, 0, 0), (0, 90, 0)):
            return door(b, d, w, h)
    b.box(MAIN, (w, d * 0.7, h), body=None)
    for z in (0.08, 0.54):
        b.box(ACCENT, (w * 0.7, d, h * 0.36), (0, 0, h * z), body=None)
    b.body_box((w, d, h))
    return None


def rock(b: Builder, w: float, d: float, h: float) -> None:
    """A faceted boulder."""
    b.lathe(
        MAIN,
        [(0, 0), (w * 0.46, 0), (w * 0.5, h * 0.3), (w * 0.36, h * 0.8), (0, h)],
        segments=7,
        smooth=False,
        squash=d / w,
    )


def vehicle(b: Builder, w: float, d: float, h: float) -> None:
    """A body on wheels with a cabin, along the longer side."""
    length, width = max(w, d), min(w, d)
    with b.moved((0, 0, 0), (0, 0.0 if w >= d else 90.0, 0)):
        b.box(MAIN, (length, width, h * 0.42), (0, 0, h * 0.2), body=None)
        b.box("Pane", (length * 0.52, width * 0.86, h * 0.38), (-length * 0.05, 0, h * 0.62), body=None)
        for x in (-0.32, 0.32):
            b.box(TRUNK, (h * 0.4, width, h * 0.4), (x * length, 0, 0), body=None)
        b.body_box((length, width, h * 0.62))


def boat(b: Builder, w: float, d: float, h: float) -> None:
    """A pointed hull with a cabin, along the longer side."""
    length, width = max(w, d), min(w, d)
    outline = [
        (-length / 2, -width * 0.4),
        (length * 0.2, -width / 2),
        (length / 2, 0),
        (length * 0.2, width / 2),
        (-length / 2, width * 0.4),
    ]
    with b.moved((0, 0, 0), (0, 0.0 if w >= d else 90.0, 0)):
        b.extrude(MAIN, outline, h * 0.45)
        b.box(ACCENT, (length * 0.35, width * 0.6, h * 0.55), (-length * 0.15, 0, h * 0.45))


KINDS: tuple[tuple[tuple[str, ...], Shaper], ...] = (
    (("dome", "onion", "cupola"), dome),
    (("minaret", "pillar", "pilliar", "column", "colon", "chimney", "bollard", "gold"), column),
    (("tower", "keep"), tower),
    (("palm", "tree", "pine", "birch", "oak"), tree),
    (("bush", "shrub", "grass", "plant", "ivy", "flower", "weed", "hedge"), bush),
    (("awning", "canopy", "cloth", "tent", "marquee", "umbrella", "parasol"), awning),
    (("barrel", "pot", "vase", "jar", "urn", "bucket", "keg", "vessel", "basket", "bin", "trash"), vessel),
    (("arch", "archway", "doorway", "gate", "gateway", "portal", "bridge"), arch),
    (("stair", "stairs", "steps"), stairs),
    (("fence", "railing", "rail", "parapet", "balustrade", "barrier"), fence),
    (("lamp", "lantern", "streetlight", "light", "torch", "candle"), lamp),
    (("sign", "banner", "neon", "billboard", "flag", "board"), sign),
    (("window", "showcase"), window),
    (("door",), door),
    (("chair", "stool", "armchair", "throne"), chair),
    (("bench", "table", "stall", "desk", "counter", "cart", "shelf"), table),
    (("crate", "box", "chest", "container", "pallet", "cargo"), crate),
    (("car", "truck", "van", "vehicle", "lorean", "bus", "auto"), vehicle),
    (("boat", "ship", "gondola"), boat),
    (("rock", "stone", "boulder", "cliff", "rubble"), rock),
    (
        (
            "road",
            "floor",
            "ground",
            "tile",
            "plane",
            "pavement",
            "path",
            "carpet",
            "rug",
            "street",
            "dock",
            "pattern",
            "patch",
            "water",
            "river",
            "basicshapes",
        ),
        slab,
    ),
    (("house", "building", "cottage", "barn", "shed", "shop", "hut", "townhouse", "block", "mill", "pavilion"), house),
    (("roof",), gable_roof),
    (("wall", "facade", "teeth", "trim", "partition", "curb"), wall),
)
FLAT_RATIO = 0.05


def shaper(words: Sequence[str], w: float, d: float, h: float) -> Shaper:
    """The shape for a name: flat things are slabs whatever they are called; the name counts before the category."""
    if min(w, d, h) < MIN_SOLID_CM or h < FLAT_RATIO * min(w, d):
        return slab
    for word in words:
        for keys, found in KINDS:
            if word in keys or any(len(key) > 3 and word.startswith(key) for key in keys):
                return wall if found is slab and h > 0.3 * min(w, d) else found
    return block
