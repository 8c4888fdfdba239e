"""Great farm."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.gardens import border, enclosure
from cases.open190.parts.land import field
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "farm",
    "outdoor",
    "Great farm",
    styles.DOMESTIC.but(
        wall=("RedBoards", "WhiteBoards"), old=True, paint=("RedPaint", "GreenPaint", "BluePaint", "YellowPaint")
    ),
)
def farm(p: StagedPlace) -> None:
    """Fields of seven crops in rows around a farmyard with barns, silos, animals and machines."""
    p.ground((-9000, -7000, 9000, 7000), "Grass", tile=1500)
    p.trail([(-9000, 0), (9000, 0)], 500, "Soil")
    p.trail([(0, -7000), (0, 7000)], 500, "Soil", z=1.8)
    crops = ("Wheat", "Maize", "Cabbage", "Lettuce", "Carrot", "Pumpkin", "Strawberry", "Leek", "Vine")
    for k, (x0, y0, x1, y1) in enumerate(
        (
            (-8700, 500, -4600, 6700),
            (-8700, -6700, -4600, -500),
            (-4300, 3600, -500, 6700),
            (-4300, -6700, -500, -3200),
            (500, 3600, 4300, 6700),
            (500, -6700, 4300, -3200),
            (4600, -6700, 8700, -500),
            (4600, 500, 8700, 3400),
        )
    ):
        field(p, (x0, y0, x1, y1), crops[k], step=(66.0, 58.0, 62.0, 50.0, 47.0, 66.0, 48.0, 58.0)[k])
    for x in range(4800, 8700, 560):
        for y in range(3900, 6700, 560):
            p.relate(
                "in_grid", p.put(p.kit("tree", 3, leaf="Blossom", height=450.0), x, y, yaw=p.uni(0, 360), scale=0.7)
            )
    p.put(p.one("house", storeys=2, width=1100.0), -1500, 2300, yaw=180)
    for x, y, yaw, use in (
        (-3200, 2000, -90, "Barn"),
        (1700, 2400, 180, "Barn"),
        (3300, 1500, 90, "CowShed"),
        (1700, -1500, 0, "Granary"),
    ):
        p.put(p.one("hall", use=use, width=1400.0, depth=900.0, high=450.0), x, y, yaw=yaw)
    p.row((2900, 2900), (3900, 2900), p.kit("tank", 2, kind="GrainSilo"), 3, scale=(0.6, 0.6))
    p.put(p.one("windmill"), -3500, -1500, yaw=30)
    p.put(p.one("greenhouse"), -2000, -1400)
    p.put(p.one("greenhouse"), -2000, -2200)
    p.put(p.one("well"), -700, 1300)
    p.ground((-3000, 500, 3000, 1900), "Soil", tile=700, z=0.6)
    animals = p.kinds("animal", "Cow", "Sheep", "Horse", "Goat", "Donkey")
    for box in ((-4200, -2900, -2400, -2300), (500, -3000, 3900, -1950)):
        enclosure(p, box, p.kit("fence", 2, kind="Rail"), gate=p.one("gate"))
        p.scatter(
            (box[0] + 150, box[1] + 150, box[2] - 150, box[3] - 150),
            [*animals, *p.kit("animal", 3, kind="Sheep")],
            24,
            clear=60,
        )
    p.scatter(
        (-2800, 550, 2800, 1850),
        [
            *p.kinds("animal", "Hen", "Duck", "Pig", "Dog", "Cat"),
            *p.kit("crate", 4),
            *p.kit("barrel", 3),
            *p.kit("sack", 4),
            *p.kit("handcart", 4),
            *p.kinds("log", "Firewood", "WoodPile"),
            *p.kinds("works", "Wheelbarrow", "Ladder"),
        ],
        120,
        clear=40,
    )
    p.row(
        (-2500, 700),
        (2500, 700),
        [*p.kit("tractor", 3, kind="Tractor"), *p.kit("cart", 3), *p.kinds("car", "Pickup")],
        6,
    )
    for a, b in (
        ((-8900, 350), (-300, 350)),
        ((300, 350), (8900, 350)),
        ((-8900, -350), (-300, -350)),
        ((300, -350), (8900, -350)),
    ):
        border(p, a, b, p.kit("fence", 2, kind="Rail"))
    p.row((-8800, 6900), (8800, 6900), p.kit("conifer", 4), 46, jitter=40)
    p.row((-8800, -6900), (8800, -6900), p.kit("tree", 4), 40, jitter=40)
    p.scatter(
        (-4200, -3000, 4200, 3400),
        [*p.kit("bush", 4), *p.kit("flowers", 6), *p.kit("rock", 3)],
        200,
        clear=40,
        avoid=((-4200, -300, 4200, 300), (-300, -3100, 300, 3500)),
    )
    p.sun(-38, 55, colour=(255, 246, 226))
    p.view("yard", (-2700, 300, 200), (900, 1700, 150), 72)
    p.view("fields", (-300, 3000, 500), (-7500, 4800, 0), 72)
