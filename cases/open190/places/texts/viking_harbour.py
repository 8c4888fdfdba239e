"""Viking harbour."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.clutter import old_goods
from cases.open190.parts.gardens import border
from cases.open190.parts.land import forest, ring
from cases.open190.parts.water import waterfront
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "viking-harbour",
    "text",
    "Viking harbour",
    styles.HISTORICAL.but(
        wall=("DarkPlanks", "Planks", "GreyPlanks"),
        roof=("Thatch", "Shingle"),
        awning=("RedStripes", "BlueStripes"),
        trim=("DarkOak",),
    ),
    130,
)
def viking_harbour(p: StagedPlace) -> None:
    """Longhouses above a beach with longships, a smithy, drying racks and a palisade."""
    p.plate(130, "Grass")
    p.ground((-6400, 900, 6400, 1700), "Sand", tile=800, z=0.5)
    waterfront(
        p,
        -6400,
        6400,
        1700,
        deep=4700,
        boats=p.kit("boat", 3, kind="Longship") + p.kit("boat", 3, kind="RowingBoat"),
        jetties=4,
        gear=[*p.kit("barrel", 2), *p.kit("crate", 2)],
        wood="GreyPlanks",
    )
    houses = p.kit("house", 6, storeys=1, noun="Longhouse", width=1300.0, form="gable")
    for x in range(-5000, 5001, 2000):
        p.put(houses, x, -500 + p.uni(-100, 100), yaw=p.uni(-12, 12))
        p.put(houses, x + 400, -2300 + p.uni(-200, 200), yaw=p.uni(-25, 25))
    p.put(p.one("hall", use="MeadHall", width=2200.0, depth=1000.0), 0, -4200, yaw=0)
    border(p, (-6300, -5600), (6300, -5600), p.kit("fence", 2, kind="Plank"))
    for k, kind in enumerate(("ForgeHearth", "Anvil", "Bellows", "Grindstone", "Cauldron", "Sawhorse")):
        p.put(p.one("forge", kind=kind), -2300 + 280 * k, -3400, yaw=180)
    p.row(
        (-5800, 1250),
        (5800, 1250),
        p.kinds("boat-gear", "FishRack", "NetHeap", "OarRack", "RopeCoil", "Anchor", "LobsterPot"),
        20,
        jitter=60,
    )
    ring(p, 2600, -3700, 380, p.kinds("log", "FallenLog"), 5, face=0)
    p.put(p.one("forge", kind="Cauldron"), 2600, -3700)
    p.scatter(
        (-5800, -3200, 5800, 700),
        [*old_goods(p), *p.kinds("log", "Firewood", "WoodPile"), *p.kinds("animal", "Goat", "Hen", "Dog", "Sheep")],
        90,
        clear=50,
    )
    p.row((-6000, 780), (6000, 780), p.kit("flag", 4, banner=True), 9)
    forest(p, (-6300, -6300, 6300, -4900), p.kit("conifer", 6), 60)
    p.palette(95, "boat", "boat-gear", "crate", "barrel", "house", "forge", "tent", "log", "animal", "rock")
