"""Allotment gardens."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.gardens import enclosure
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("allotments", "text", "Allotment gardens", styles.DOMESTIC, 130)
def allotments(p: StagedPlace) -> None:
    """Plots with beds, sheds, greenhouses, water butts, scarecrow flags, hedges and a green path."""
    p.plate(130, "Grass")
    p.trail([(-6300, 0), (6300, 0)], 300, "Gravel")
    p.trail([(0, -6300), (0, 6300)], 300, "Gravel", z=1.8)
    crops = ("Cabbage", "Lettuce", "Carrot", "Strawberry", "Leek", "Pumpkin", "Maize")
    fences, hedges = p.kit("fence", 3, kind="Picket", length=250.0), p.kit("hedge", 2, length=250.0, high=80.0)
    for i in range(6):
        for j in range(4):
            x, y = (-5200 + 2000 * i) + (250 if i > 2 else -50), -4700 + 3000 * j + (200 if j > 1 else -100)
            with p.at(x, y, 0 if j % 2 else 180):
                enclosure(p, (-870, -1200, 870, 1200), fences if (i + j) % 2 else hedges)
                p.put(p.kit("shed", 6), -520, 820, yaw=180)
                p.put([*p.kit("greenhouse", 2)], 380, 800, scale=0.7) if (i + j) % 3 == 0 else p.put(
                    p.kit("arbour", 2), 420, 800
                )
                for k in range(5):
                    p.put(p.one("bed", length=420.0, wide=130.0), -420, -950 + 280 * k, 1.0)
                    p.put(p.one("crop", kind=crops[(i + k + j) % 7]), -420, -950 + 280 * k)
                for k in range(4):
                    p.put(p.kit("flowers", 7), 250 + 170 * (k % 3), -900 + 300 * k)
                p.put(p.kit("barrel", 2, style=styles.HISTORICAL, kind="RainButt"), -760, 560)
                p.scatter(
                    (100, -1000, 780, 500),
                    [
                        *p.kinds("works", "Wheelbarrow"),
                        *p.kit("bench", 3),
                        *p.kit("sack", 2),
                        *p.kit("planter", 3),
                        *p.kit("parasol-table", 2),
                        *p.kit("tree", 3, height=450.0),
                    ],
                    5,
                    clear=30,
                )
    p.row((-6000, 260), (6000, 260), [*p.kit("bench", 2), *p.kit("bicycle", 3), *p.kit("bin", 2)], 14)
    p.put(p.one("pavilion"), 5900, 5900)
    p.palette(
        155,
        "shed",
        "flowers",
        "crop",
        "planter",
        "bench",
        "bush",
        "tree",
        "fence",
        "works",
        "animal",
        "bicycle",
        "barrel",
    )
