"""Army camp under a castle."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.castles import castle
from cases.open190.parts.clutter import old_goods
from cases.open190.parts.gardens import enclosure
from cases.open190.parts.land import forest, ring
from cases.open190.parts.streets import frontage
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "war-camp",
    "text",
    "Army camp under a castle",
    styles.HISTORICAL.but(
        awning=("RedStripes", "BlueStripes", "YellowStripes", "GreenStripes"), stone=("Granite", "DarkStone")
    ),
    200,
)
def war_camp(p: StagedPlace) -> None:
    """Rows of striped tents with banners and fires before a castle with a gatehouse."""
    p.plate(200, "Grass")
    castle(
        p,
        (-3500, 3200, 3500, 8200),
        towers=p.kit("tower", 3, round=True, height=1300.0, radius=320.0),
        gatehouse=p.one("gatehouse"),
        wall=p.one("castle-wall", length=700.0),
    )
    p.put(p.one("tower", round=False, spire=True, height=1700.0, radius=450.0, noun="GreatKeep"), 0, 6500, yaw=180)
    frontage(p, (-3100, 7800), (-3100, 3700), p.kit("house", 4), (50, 150))
    for x in range(-8500, 8501, 1700):
        for y in (-8600, -6900, -5200, -3500):
            p.put(p.kit("tent", 8), x + p.uni(-150, 150), y + p.uni(-150, 150), yaw=p.uni(-20, 20))
            p.put(p.kit("flag", 5, banner=True), x + 430, y)
    for x in range(-7600, 7601, 3400):
        for y in (-7700, -4400):
            ring(p, x, y, 330, p.kinds("log", "FallenLog"), 3, face=0)
            p.put(p.kit("forge", 2, kind="Cauldron"), x, y)
    p.row((-7500, -1800), (7500, -1800), [*p.kit("cart", 4), *p.kit("handcart", 3)], 13, jitter=80)
    enclosure(p, (-8800, -1200, -4800, 1600), p.kit("fence", 2, kind="Rail"), gate=p.one("gate"))
    p.scatter((-8600, -1000, -5000, 1400), p.kit("animal", 4, kind="Horse"), 20, clear=60)
    for k in range(5):
        p.put(
            p.kinds("forge", "Anvil", "ForgeHearth", "Grindstone", "Bellows", "Sawhorse")[k], 5200 + 420 * k, 0, yaw=180
        )
    p.scatter((-8800, -9000, 8800, -1500), old_goods(p), 120, clear=60)
    p.trail([(0, -9800), (0, 3000)], 500, "Soil")
    forest(
        p,
        (-9800, 800, 9800, 9800),
        p.kit("tree", 5),
        150,
        under=p.kit("rock", 4),
        floor=50,
        avoid=((-4400, 600, 4400, 9000), (-9000, -1400, -4600, 1800), (4800, -400, 7600, 400)),
    )
    p.palette(105, "tent", "flag", "cart", "barrel", "crate", "forge", "tower", "tree", "animal", "sack")
