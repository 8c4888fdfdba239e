"""Desert caravanserai."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.castles import castle
from cases.open190.parts.clutter import old_goods
from cases.open190.parts.land import ring
from cases.open190.parts.streets import frontage
from cases.open190.parts.trade import market
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "caravanserai",
    "text",
    "Desert caravanserai",
    styles.HISTORICAL.but(
        wall=("SandPlaster", "Clay", "OchrePlaster"),
        roof=("DarkConcrete",),
        stone=("Sandstone",),
        leaf=("PaleLeaf",),
        awning=("RedStripes", "BlueStripes", "YellowStripes", "TealCloth"),
    ),
    130,
)
def caravanserai(p: StagedPlace) -> None:
    """A walled inn of sandstone with an arcade, a bazaar, tents, palms and a pool."""
    p.plate(130, "Sand")
    castle(
        p,
        (-3000, -2600, 3000, 2600),
        towers=p.kit("tower", 2, round=True, spire=False, height=900.0, radius=260.0),
        gatehouse=p.one("gatehouse"),
        wall=p.one("castle-wall", length=700.0),
    )
    p.ground((-1700, -1500, 1700, 1500), "Flagstone", tile=600, z=0.5)
    houses = p.kit("house", 6, storeys=2, form="flat", depth=600.0)
    frontage(p, (-2650, 2200), (-2650, -2050), houses, (10, 40))
    frontage(p, (2650, -2050), (2650, 2200), houses[::-1], (10, 40))
    p.ground((-500, -400, 500, 400), family="water", tile=500, z=1.0)
    ring(p, 0, 0, 850, p.kit("palm", 3), 8)
    market(p, (-1600, -1450, 1600, -650), 7, 2, [*p.kit("sack", 3), *p.kit("crate", 2), *p.kit("handcart", 2)])
    for x in (-1000, 0, 1000):
        p.put(p.kit("tent", 3, round=True), x, 1300, yaw=180)
    p.row((-1500, 800), (1500, 800), [*p.kit("rug", 3), *p.kit("sack", 2)], 8)
    p.row((-1600, 2150), (1600, 2150), p.kit("column", 2, broken=False, height=380.0), 11)
    p.scatter((-2000, -1900, 2000, 2000), [*old_goods(p), *p.kinds("animal", "Donkey", "Horse", "Goat")], 60, clear=50)
    for x, y in ((-4700, -3600), (-4300, 900), (4600, -800), (4300, 3900), (-4800, 4400)):
        ring(p, x, y, 500, p.kit("tent", 5), 5)
        p.put(p.kit("cart", 2), x, y, yaw=p.uni(0, 360))
    p.scatter(
        (-6300, -6300, 6300, 6300),
        [*p.kit("palm", 3), *p.kit("rock", 5), *p.kit("flowers", 1, kind="TallGrass")],
        110,
        clear=120,
        avoid=((-3400, -3000, 3400, 3000), (-350, -6400, 350, -2500)),
    )
    p.trail([(0, -6400), (0, -1600)], 400, "RedSand")
    p.palette(120, "tent", "stall", "palm", "rock", "house", "barrel", "crate", "sack", "column", "animal", "planter")
