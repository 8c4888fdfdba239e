"""School grounds."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.gardens import border, garden, playground
from cases.open190.parts.land import forest
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "school-grounds",
    "text",
    "School grounds",
    styles.OFFICE.but(
        wall=("RedBrick", "YellowBrick", "WhiteBrick"), paint=("RedPaint", "YellowPaint", "BluePaint", "LimePaint")
    ),
    130,
)
def school_grounds(p: StagedPlace) -> None:
    """A school with a yard, a playground, a sports field, a garden, bicycles and buses."""
    p.plate(130, "Grass")
    p.put(p.one("block", use="School", storeys=3.0, width=2400.0, depth=1100.0), -1500, 2600, yaw=180)
    p.put(p.one("block", use="School", storeys=2.0, width=1500.0, depth=1000.0, noun="SportsHall"), 1700, 2700, yaw=180)
    p.ground((-3000, -400, 3000, 1800), "Asphalt", tile=800, z=0.5)
    playground(p, -4700, 600)
    p.ground((1000, -5800, 6000, -1600), "LawnStripes", tile=1000, z=0.5)
    for x in (1150, 5850):
        p.put(p.one("play", kind="ClimbingFrame", noun="GoalFrame"), x, -3700, yaw=90)
    p.row((1200, -1450), (5800, -1450), p.kit("bench", 3), 10, yaw=180)
    garden(
        p,
        (-5600, -5600, -1800, -2400),
        beds=4,
        centre=p.one("well"),
        benches=p.kit("bench", 2),
        trees=p.kit("tree", 3, height=500.0),
    )
    p.row((-2800, 1500), (-400, 1500), p.kit("bike-rack", 1), 7)
    p.row((-2800, 1280), (-400, 1280), p.kit("bicycle", 5), 12, jitter=15)
    p.grid((200, 0, 2600, 1300), p.kit("table", 3, kind="Square"), 5, 3, jitter=30)
    p.scatter(
        (-2800, -300, 2800, 1100),
        [
            *p.kit("bench", 3),
            *p.kit("bin", 3),
            *p.kit("planter", 5),
            *p.kit("play", 2, kind="SpringHorse"),
            *p.kit("flag", 3),
        ],
        40,
        clear=60,
    )
    p.put(p.one("greenhouse"), -600, -4600)
    p.trail([(0, -6400), (0, -450)], 350, "Paving")
    p.row((-4800, 5200), (4800, 5200), [*p.kit("truck", 2, kind="CityBus"), *p.kit("car", 6)], 7)
    p.put(p.one("bus-shelter"), 0, 4700, yaw=0)
    for a, b in (((-6300, -6200), (6300, -6200)), ((6300, -6200), (6300, 4400)), ((-6300, 4400), (-6300, -6200))):
        border(p, a, b, p.kit("fence", 2, kind="Iron"), opening=450 if a[1] == b[1] else 0)
    forest(
        p,
        (-6200, -6100, 6200, 4200),
        p.kit("tree", 5),
        60,
        under=p.kit("bush", 4),
        floor=40,
        avoid=(
            (-3200, -600, 3200, 3400),
            (900, -5900, 6100, -1300),
            (-5700, -5700, -1700, -300),
            (-400, -6400, 400, 0),
        ),
    )
    p.palette(
        185,
        "play",
        "bench",
        "bicycle",
        "planter",
        "tree",
        "flowers",
        "sign",
        "car",
        "bush",
        "chair",
        "table",
        "streetlamp",
        "statue",
    )
