"""Crystal miners' camp."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.clutter import old_goods
from cases.open190.parts.gardens import border
from cases.open190.parts.land import ring
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "crystal-camp",
    "text",
    "Crystal miners' camp",
    styles.FANTASY.but(stone=("DarkStone", "Granite"), leaf=("VioletLeaf", "DarkLeaf")),
    130,
)
def crystal_camp(p: StagedPlace) -> None:
    """Tents around a fire, carts of rock, crystals in a ring of boulders, a palisade."""
    p.plate(130, "Cinder")
    ring(p, 0, 0, 1400, p.kit("tent", 6), 9, face=90)
    p.put(p.one("forge", kind="Cauldron"), 0, 0)
    ring(p, 0, 0, 420, p.kinds("log", "FallenLog"), 5, face=0)
    ring(p, 0, 0, 2300, p.kit("flag", 4, banner=True), 12)
    for x, y in ((-3800, 2400), (3600, 2600), (3700, -2500), (-3600, -2700)):
        ring(p, x, y, 700, p.kit("rock", 6), 9, jitter=80)
        p.scatter((x - 420, y - 420, x + 420, y + 420), p.kit("mushroom", 4, crystal=True), 12, clear=20)
        ring(p, x, y, 1150, [*p.kit("handcart", 3, load="Rock"), *p.kit("crate", 3), *p.kit("barrel", 2)], 8)
    p.put(p.one("crane", kind="TreadwheelCrane"), 2600, 0)
    p.put(p.one("tower", round=False, spire=False, height=900.0), -2700, 0)
    p.row((-900, 2600), (900, 2600), p.kinds("forge", "ForgeHearth", "Anvil", "Grindstone", "Bellows"), 6)
    p.scatter(
        (-2400, -2400, 2400, 2400),
        [*old_goods(p), *p.kinds("works", "Ladder", "Wheelbarrow", "PlankStack"), *p.kinds("log", "Firewood")],
        70,
        clear=50,
    )
    for a, b in (((-6200, -6200), (6200, -6200)), ((-6200, 6200), (6200, 6200))):
        border(p, a, b, p.kit("fence", 2, kind="Plank"), opening=600)
    p.scatter(
        (-6200, -6000, 6200, 6000),
        [*p.kit("rock", 6), *p.kit("tree", 4), *p.kit("mushroom", 3, crystal=False)],
        110,
        clear=100,
        avoid=((-3000, -3000, 3000, 3000),),
    )
    p.put(p.one("hill", of="Rock"), 0, 5000)
    p.palette(80, "tent", "mushroom", "rock", "crate", "barrel", "forge", "flag", "tree", "handcart")
