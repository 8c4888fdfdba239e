"""Castle yard."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.castles import castle
from cases.open190.parts.gardens import enclosure
from cases.open190.parts.land import forest
from cases.open190.parts.streets import frontage
from cases.open190.parts.trade import market
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "castle-yard",
    "outdoor",
    "Castle yard",
    styles.HISTORICAL.but(stone=("Limestone", "Fieldstone"), wall=("WhitePlaster", "Fieldstone", "CreamPlaster")),
)
def castle_yard(p: StagedPlace) -> None:
    """A walled yard with a keep, a smithy, stables, a market day and a practice ground."""
    p.ground((-3600, -3200, 3600, 3200), "Grass")
    p.ground((-2200, -1800, 2200, 1800), "Cobble", tile=550, z=0.5)
    castle(
        p,
        (-2700, -2300, 2700, 2300),
        towers=p.kit("tower", 2, round=True, height=1100.0, radius=280.0),
        gatehouse=p.one("gatehouse"),
        wall=p.one("castle-wall", length=700.0),
    )
    p.put(p.one("tower", round=False, spire=False, height=1700.0, radius=480.0, noun="GreatKeep"), 0, 1450, yaw=180)
    frontage(
        p,
        (-2500, 1900),
        (-2500, -1900),
        p.kit("hall", 2, use="Stable", width=900.0, depth=500.0, high=300.0)[::-1]
        + p.kit("house", 3, storeys=2, depth=550.0),
        (20, 120),
    )
    frontage(
        p,
        (2500, -1900),
        (2500, 1900),
        p.kit("house", 3, storeys=1, depth=520.0) + p.kit("house", 2, storeys=2, depth=520.0),
        (60, 160),
    )
    p.put(p.one("church"), 1450, 1250, yaw=180)
    p.put(p.one("well"), 0, -150)
    goods = p.kit("crate", 4) + p.kit("barrel", 4) + p.kit("sack", 4)
    market(p, (-1500, -1250, 300, -450), 5, 3, goods)
    for k, kind in enumerate(("ForgeHearth", "Anvil", "Bellows", "Grindstone", "Cauldron", "Kiln", "Sawhorse")):
        p.put(p.one("forge", kind=kind), 900 + 240 * (k % 4), -500 - 260 * (k // 4), yaw=180)
    p.put(p.one("pavilion", use="SmithyShelter", size=600.0), 1750, -950)
    p.row((-900, 500), (900, 500), p.kit("flag", 4, banner=True), 6)
    p.row((-700, 250), (-1700, 250), p.kit("cart", 3), 3, jitter=30)
    enclosure(p, (-1850, 520, -850, 1250), p.kit("fence", 1, kind="Rail"))
    p.scatter((-1780, 600, -920, 1180), p.kinds("animal", "Horse", "Cow", "Goat", "Sheep", "Pig"), 9, clear=50)
    p.scatter(
        (-2150, -1750, 2150, 1750),
        [*goods, *p.kit("handcart", 3), *p.kinds("log", "Firewood"), *p.kit("bench", 2, back=False)],
        130,
        clear=25,
        avoid=((-300, -2300, 300, 900),),
    )
    p.scatter((-2100, -1700, 2100, 1700), p.kinds("animal", "Hen", "Dog", "Cat", "Duck"), 26, clear=30)
    forest(
        p,
        (-3500, -3150, 3500, 3150),
        p.kit("tree", 6),
        70,
        under=[*p.kit("bush", 4), *p.kit("rock", 3), *p.kit("flowers", 4)],
        floor=110,
        avoid=((-3050, -2700, 3050, 2700), (-350, -3200, 350, -2300)),
    )
    p.trail([(0, -3200), (0, -1000)], 400, "Cobble")
    p.sun(-36, 60, colour=(255, 244, 226))
    p.view("gate", (0, -2150, 175), (-100, 1300, 350), 72)
    p.view("yard", (1750, -1500, 260), (-1300, 300, 150), 72)
