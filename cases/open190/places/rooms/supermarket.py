"""Supermarket."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.halls import aisles
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("supermarket", "indoor", "Supermarket", styles.URBAN.but(wall=("WhitePlaster",), trim=("GreyPaint",)))
def supermarket(p: StagedPlace) -> None:
    """Aisles of stocked shelves, freezers, fruit tables, checkouts."""
    p.room(
        (-2000, -1400, 2000, 1400),
        "LinoTiles",
        wall="WhitePlaster",
        high=400,
        S=("Shopfront", "Shopfront", "Door", "Shopfront"),
    )
    shelf = p.one("shelf", kind="Metal", boards=6, width=120.0, depth=46.0, high=200.0)
    goods = [
        p.kit("package", 4, kind=kind)
        for kind in (
            "CerealBoxes",
            "SoupTins",
            "SodaBottles",
            "JamJars",
            "TeaBoxes",
            "Detergent",
            "SpiceJars",
            "PaintTins",
            "ShoeBoxes",
        )
    ]
    count = aisles(p, (-1500, -480, 780, 1190), 6, shelf, goods, gap=3, share=0.97)
    p.row((-1300, 1250), (900, 1250), p.kit("service", 2, kind="FridgeDisplay"), 16, yaw=180)
    p.row((1000, -350), (1000, 950), p.kit("service", 2, kind="ChestFreezer"), 6)
    p.row((1350, -350), (1350, 950), p.kit("service", 2, kind="ChestFreezer"), 6)
    fruit = p.kinds("crate", "AppleCrate") + p.kit("crate", 3, kind="AppleCrate")
    stand = p.one("table", kind="Trestle", width=200.0, depth=90.0)
    for x in range(-1700, -1000, 330):
        for y in (-980, -700):
            table = p.put(stand, x, y)
            p.on(table, fruit, 5, yaw=0)
    p.row((1800, -800), (1800, 1000), p.kit("stall", 2, ware="Bread") + p.kit("stall", 1, ware="Cheese"), 5, yaw=0)
    checkouts = p.kit("service", 2, kind="Checkout")
    for x in range(-700, 900, 320):
        p.put(checkouts, x, -930, yaw=90)
        p.put(p.kit("stool", 1, high=75.0), x + 62, -990)
        p.put(p.kit("service", 3, kind="ShoppingCart"), x - 110, -820, yaw=90)
    p.row((-1700, -1250), (-900, -1250), p.kit("service", 3, kind="ShoppingCart"), 9, yaw=90)
    p.row((1100, -1330), (1900, -1330), p.kinds("service", "VendingMachine", "CashMachine", "PhotoBooth"), 4)
    p.row((900, -1150), (1700, -1150), p.kit("planter", 3), 4)
    p.scatter(
        (-1900, -1350, 1900, -500),
        [*p.kit("bin", 2), *p.kit("house-plant", 3), *p.kit("sign", 1, kind="InfoSign")],
        14,
        clear=50,
    )
    p.scatter((1500, 200, 1950, 1350), p.kit("pallet", 3, load="Boxes"), 5, clear=30)
    p.beams((-2000, -1400, 2000, 1400), 400, 9, "Steel", truss=True)
    for x in (-1300, -400, 500, 1400):
        for y in (-900, 100, 900):
            p.light(x, y, 370, intensity=4500, radius=1400, colour=(244, 248, 255))
    p.sun(-55, -70, intensity=1.6, sky=0.75)
    p.view("checkouts", (-1700, -1300, 175), (300, -400, 90), 75)
    p.view("aisle", (-1620, 40, 165), (600, 130, 120), 70)
    if count < 2000:
        p.left_out["goods"] += 1
