"""Ground, roads, water and beds."""

from __future__ import annotations

from catalog.kits.maker import KitMaker, camel, family, word
from catalog.kits.nature.categories import GROUND

PAVED = {
    "Cobble": "CobblePavement",
    "Paving": "StonePavement",
    "Flagstone": "FlagstonePavement",
    "RedPaving": "RedPavement",
    "Asphalt": "AsphaltRoad",
    "Concrete": "ConcreteGround",
    "Gravel": "GravelGround",
    "Planks": "PlankGround",
    "Rubber": "RubberGround",
    "Cinder": "CinderGround",
}


@family("ground", flat=True)
def ground(m: KitMaker) -> None:
    """A square piece of ground; its upper face is at the pivot."""
    material, side = m.opt("of", "Grass"), m.opt("side", 1000.0)
    noun = PAVED.get(material, f"{material}Ground")
    m.say(
        noun,
        GROUND,
        f"Square of {word(material)}, {side / 100:.0f} x {side / 100:.0f} m, its upper face at the pivot.",
        tags="ground floor tile",
    )
    m.b.box(material, (side, side, 4), (0, 0, -4))


@family("road", flat=True)
def road(m: KitMaker) -> None:
    """A piece of road along X with markings, upper face at the pivot."""
    length, wide, of = m.opt("length", 800.0), m.opt("wide", 700.0), m.opt("of", "Asphalt")
    mark = m.opt("mark", "line")
    m.say(
        {"line": "RoadStraight", "zebra": "RoadZebraCrossing", "bays": "RoadParkingBays"}[mark],
        GROUND,
        f"Piece of road of {word(of)}, {length / 100:.0f} m long along X and {wide / 100:.0f} m wide, with {mark}.",
        tags="road ground street asphalt",
    )
    m.b.box(of, (length, wide, 4), (0, 0, -4))
    if mark == "line":
        for i in range(int(length // 400)):
            m.b.box("WhitePaint", (180, 12, 0.5), (-length / 2 + 200 + 400 * i, 0, 0), body=None)
    elif mark == "zebra":
        for i in range(int(wide // 90)):
            m.b.box("WhitePaint", (260, 45, 0.5), (0, -wide / 2 + 55 + 90 * i, 0), body=None)
    else:
        for i in range(int(length // 270) + 1):
            m.b.box(
                "WhitePaint",
                (10, wide - 60, 0.5),
                (-length / 2 + 6 + i * (length - 12) / int(length // 270), 0, 0),
                body=None,
            )


@family("water", flat=True)
def water(m: KitMaker) -> None:
    """A square of water."""
    side = m.opt("side", 1000.0)
    m.say(
        "WaterSurface",
        GROUND,
        f"Calm water, {side / 100:.0f} x {side / 100:.0f} m, its surface at the pivot.",
        "Calm",
        tags="water sea river lake surface",
    )
    m.b.box("Water", (side, side, 4), (0, 0, -4), body=None)


@family("bed", flat=True)
def bed(m: KitMaker) -> None:
    """A garden bed edged with stones or boards, upper face near the pivot."""
    edge, soil = m.opt("edge", m.pick("Fieldstone", "Oak", "RedBrick", "Limestone")), "DarkSoil"
    length, wide = m.opt("length", 400.0), m.opt("wide", 160.0)
    m.say(
        "GardenBedGround",
        GROUND,
        f"Bed of dark soil edged with {word(edge)}, {length / 100:.1f} x {wide / 100:.1f} m.",
        camel(edge),
        tags="bed garden soil ground",
    )
    m.b.box(soil, (length, wide, 4), (0, 0, -2))
    for s in (-1, 1):
        m.b.box(edge, (length, 10, 9), (0, s * wide / 2, -3), body=None)
        m.b.box(edge, (10, wide, 9), (s * length / 2, 0, -3), body=None)
