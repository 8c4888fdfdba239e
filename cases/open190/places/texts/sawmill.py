"""Sawmill in the woods."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.land import forest
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "sawmill",
    "text",
    "Sawmill in the woods",
    styles.INDUSTRIAL.but(wall=("Planks", "RedBoards", "GreyPlanks"), old=True),
    130,
)
def sawmill(p: StagedPlace) -> None:
    """Stacks of logs and planks, a saw shed, a mill pond, carts, a forest around."""
    p.plate(130, "Grass")
    p.ground((-2600, -2600, 3600, 2200), "Soil", tile=700, z=0.5)
    p.put(p.one("hall", use="SawMill", width=2200.0, depth=1100.0, high=450.0), 0, 3000, yaw=180)
    p.put(p.one("hall", use="DryingShed", width=1800.0, depth=900.0, high=380.0), -4000, 900, yaw=-90)
    p.ground((-6200, -4600, -3000, -1600), family="water", tile=800, z=0.6)
    p.grid((-2200, -2300, 300, -400), p.kinds("log", "WoodPile"), 6, 6, jitter=15)
    p.grid((1300, -2300, 3300, -300), p.kinds("works", "PlankStack"), 4, 7, jitter=15)
    p.grid(
        (-2000, 500, 200, 1700), [*p.kit("pallet", 2, load="Timber"), *p.kinds("works", "PlankStack")], 5, 4, jitter=15
    )
    p.row(
        (900, 800),
        (3200, 800),
        p.kinds("machine", "BandSaw", "ConveyorBelt") + p.kinds("forge", "Sawhorse", "Grindstone"),
        8,
    )
    p.row(
        (800, 1800),
        (3300, 1800),
        [*p.kit("cart", 4), *p.kit("truck", 1, kind="Lorry"), *p.kit("tractor", 1, kind="Tractor")],
        5,
    )
    p.scatter(
        (-2500, -2500, 3500, 2100),
        [
            *p.kinds("log", "Firewood", "TreeStump"),
            *p.kit("barrel", 2),
            *p.kit("crate", 2),
            *p.kinds("works", "Ladder", "Wheelbarrow"),
        ],
        60,
        clear=40,
    )
    p.row((4300, -2200), (4300, 2400), p.kit("house", 4, storeys=1), 4, yaw=0)
    p.scatter(
        (-6200, -6200, 6200, 6200),
        p.kinds("log", "TreeStump", "FallenLog"),
        70,
        clear=60,
        avoid=((-5200, -4700, 5400, 4200),),
    )
    p.put(p.one("crane", kind="TreadwheelCrane"), 700, -900)
    forest(
        p,
        (-6300, -6300, 6300, 6300),
        p.kit("conifer", 7),
        240,
        under=[*p.kit("rock", 4), *p.kit("flowers", 2, kind="Ferns")],
        floor=80,
        avoid=((-5400, -4800, 5600, 4300),),
    )
    p.trail([(0, -6400), (0, -2700)], 420, "Soil")
    p.palette(55, "log", "conifer", "works", "cart", "rock", "shed")
