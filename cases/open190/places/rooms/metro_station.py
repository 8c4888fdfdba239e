"""Metro station."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.rails import rails
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("metro-station", "indoor", "Metro station", styles.TRANSIT)
def metro_station(p: StagedPlace) -> None:
    """Two platforms with trains, a concourse with gates and ticket machines."""
    p.room(
        (-3200, -1500, 3200, 1500),
        "WhiteTiles",
        wall="WhiteTiles",
        base="BlueTiles",
        high=480,
        module=800.0,
        S=("Plain", "Plain", "Arch", "Plain"),
    )
    cars = p.kit("train", 2, kind="MetroCar")
    for y in (380, 1180):
        rails(p, -3100, 3100, y, [cars[0]] * 4 if y > 1000 else [cars[1]] * 3, start=60 if y > 1000 else 1400, gap=25)
    deck = p.one("platform", length=800.0, wide=440.0, of="Paving")
    benches, bins = p.kit("pew", 2, kind="WaitingBench", length=240.0), p.kit("bin", 2)
    for i in range(8):
        x = -2800 + 800 * i
        item = p.put(deck, x, 780)
        p.relate("in_row", item)
        with p.at(x, 780):
            for y, things in ((0, benches),):
                made = p.put(things, -150, y + 30, 90.2)
                p.relate("on", made, item)
                made = p.put(things, -150, y - 30, 90.2, 180)
            p.put(bins, 120, 0, 90.2)
            p.put(p.kit("pillar", 2, kind="Square", of="WhiteTiles", high=380.0), 300, 0, 90.2)
            p.put(p.kit("service", 3, kind="VendingMachine"), 220, 0, 90.2) if i % 2 else p.put(
                p.kit("board", 1, kind="TimetableBoard"), 220, 0, 90.2
            )
            p.put(p.kit("ceiling-lamp", 2, high=300.0), 20, 0, 90.2)
    gates = p.kit("service", 2, kind="TicketGate")
    p.row((-1600, -350), (1600, -350), gates, 26, yaw=90)
    p.along(
        (-3150, -1490),
        (-700, -1490),
        [
            *p.kit("service", 3, kind="TicketMachine"),
            *p.kit("service", 2, kind="PhotoBooth"),
            *p.kit("service", 3, kind="VendingMachine"),
            *p.kit("service", 1, kind="CashMachine"),
        ],
        40,
        fill=True,
    )
    p.along(
        (900, -1490),
        (3150, -1490),
        [p.one("kiosk", use="NewsKiosk"), p.one("kiosk", use="CoffeeKiosk"), p.one("kiosk", use="FlowerKiosk")],
        120,
        fill=True,
    )
    p.grid((-2600, -1000, 2600, -1000), p.kit("pillar", 2, kind="Square", of="WhiteTiles", high=380.0), 9, 1)
    p.grid(
        (-2200, -750, 2200, -750),
        p.kit("board", 2, kind="TimetableBoard") + p.kit("board", 2, kind="PosterStand"),
        8,
        1,
    )
    p.row((-3180, -900), (-3180, -300), p.kit("stairs", 1, width=300.0), 1, yaw=180)
    p.scatter(
        (-3000, -1350, 3000, -500),
        [
            *benches,
            *bins,
            *p.kit("sign", 3, kind="InfoSign"),
            *p.kit("planter", 3),
            *p.kit("house-plant", 2),
            *p.kit("bicycle", 3),
            *p.kit("crate", 2, kind="CardboardBox"),
        ],
        90,
        clear=40,
    )
    p.scatter(
        (-3000, -250, 3000, 80),
        [*bins, *p.kit("works", 1, kind="TrafficCone"), *p.kit("works", 1, kind="Barrier"), *p.kit("bollard", 2)],
        50,
        clear=50,
    )
    p.row((-3100, 175), (3100, 175), p.kit("bollard", 2), 60)
    p.beams((-3200, -1500, 3200, 1500), 480, 11, "Steel", truss=True)
    for x in (-2400, -800, 800, 2400):
        for y in (-800, 300, 900):
            p.light(x, y, 420, intensity=6000, radius=1700, colour=(240, 246, 255))
    p.sun(-70, -90, intensity=0.9, sky=0.7)
    p.view("platform", (-2950, 800, 270), (600, 700, 190), 75)
    p.view("concourse", (-2950, -620, 175), (900, -420, 130), 75)
