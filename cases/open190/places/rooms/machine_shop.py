"""Machine shop."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("machine-shop", "indoor", "Machine shop", styles.INDUSTRIAL, slot=True)
def machine_shop(p: StagedPlace) -> None:
    """Machines in rows between marked ways, workbenches, racks, a forklift, pallets."""
    p.room(
        (-1800, -1100, 1800, 1100),
        "Concrete",
        wall="RedBrick",
        high=520,
        S=("Window", "Plain", "Door", "Plain"),
        N=("Window", "Plain"),
    )
    machines = (
        p.kinds(
            "machine",
            "Lathe",
            "MillingMachine",
            "DrillPress",
            "HydraulicPress",
            "BandSaw",
            "GrindingMachine",
            "CncMachine",
            "Compressor",
            "RobotArm",
            "PackingMachine",
        )
        + p.kit("machine", 3, kind="Lathe")
        + p.kit("machine", 3, kind="MillingMachine")
    )
    for j, y in enumerate((-700, -330, 330, 700)):
        p.row((-1500, y), (900, y), machines, 8, yaw=0 if j % 2 else 180)
        p.row(
            (-1330, y + (90 if j % 2 else -90)),
            (1050, y + (90 if j % 2 else -90)),
            [*p.kit("crate", 4), *p.kit("bin", 1), *p.kit("barrel", 3), *p.kit("stool", 2)],
            12,
            jitter=20,
        )
    belt = p.one("machine", kind="ConveyorBelt")
    for i in range(8):
        item = p.put(belt, -1350 + 302 * i, 0)
        p.on(item, [*p.kit("package", 3, kind="ToolBox"), *p.kit("crate", 1, kind="AppleCrate")], 3)
    bench, tools = (
        p.one("table", kind="Long", width=200.0, depth=80.0),
        p.kinds("package", "ToolBox", "PaintTins")
        + p.kinds("desk-thing", "Binders", "Telephone", "Mug")
        + p.kit("lamp", 2, kind="DeskLamp")
        + p.kit("package", 3, kind="PaintTins"),
    )
    for x in range(-1600, 1300, 260):
        p.on(p.put(bench, x, 1040, yaw=180), tools, 5)
        p.put(p.kit("stool", 3), x, 930)
    for item in p.along((1799, -1000), (1799, 1000), p.kit("shelf", 3, kind="Metal", depth=60.0), 6, fill=True):
        p.stock(
            item,
            [
                *p.kit("package", 4, kind="PaintTins"),
                *p.kit("package", 4, kind="ToolBox"),
                *p.kit("crate", 2, kind="AppleCrate"),
                *p.kit("package", 3, kind="ShoeBoxes"),
            ],
            8,
            0.8,
        )
    for x in (1250, 1500):
        for y in range(-800, 900, 260):
            pal = p.put(p.kit("pallet", 8), x, y, yaw=90)
            p.middle(pal, p.kit("crate", 4, kind="PackingCase"))
    p.put(p.one("tractor", kind="Forklift"), 1380, -980, yaw=180)
    p.put(p.one("tractor", kind="Forklift", paint="RedPaint"), -1620, 100, yaw=90)
    p.along(
        (-1799, 900),
        (-1799, -900),
        [
            *p.kit("cupboard", 3, kind="LockerRow"),
            *p.kit("machine", 1, kind="Boiler"),
            *p.kit("machine", 1, kind="Generator"),
            *p.kit("barrel", 4, kind="GasBottle"),
        ],
        24,
        fill=True,
    )
    p.along(
        (-1700, -1099),
        (700, -1099),
        [
            *p.kit("works", 1, kind="CableDrum"),
            *p.kit("works", 2, kind="SteelBeams"),
            *p.kit("pipe", 3, kind="PipeStack"),
            *p.kit("barrel", 3, kind="OilDrum"),
        ],
        40,
        fill=True,
    )
    p.scatter(
        (-1700, -200, 1100, -120), [*p.kit("works", 1, kind="TrafficCone"), *p.kit("barrel", 3, kind="OilDrum")], 12
    )
    p.scatter(
        (-1700, -1000, 1700, 1000),
        [
            *p.kit("barrel", 3, kind="OilDrum"),
            *p.kit("crate", 3),
            *p.kit("works", 1, kind="TrafficCone"),
            *p.kit("bin", 2),
            *p.kit("works", 1, kind="Barrier"),
        ],
        60,
        clear=30,
    )
    p.beams((-1800, -1100, 1800, 1100), 520, 8, "Iron", truss=True)
    for x in (-1200, 0, 1200):
        for y in (-600, 600):
            p.light(x, y, 460, intensity=6000, radius=1700, colour=(255, 250, 238))
    p.sun(-50, -50, intensity=2.0, sky=0.65)
    p.view("line", (-1700, -150, 175), (600, 100, 90), 75)
    p.view("benches", (1150, 940, 175), (-700, 500, 80), 75)
