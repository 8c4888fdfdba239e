"""Houses and shops."""

from __future__ import annotations

from catalog.kits.facade import BUILDINGS, chimney, door, facade, flat_roof, gable_roof, hip_roof, timbers, window
from catalog.kits.maker import KitMaker, camel, family, word
from catalog.shapes.patches import hull


@family("house")
def house(m: KitMaker) -> None:
    """A dwelling of one to four storeys."""
    storeys = m.opt("storeys", m.pick(1, 2, 2, 3))
    width, depth = m.opt("width", m.uni(650, 1150, 50)), m.opt("depth", m.uni(600, 850, 50))
    floor, wall, roof = 285.0, m.mat("wall"), m.mat("roof")
    form = m.opt("form", m.pick("gable", "gable", "hip", "cross") if "Concrete" not in roof else "flat")
    noun = (
        m.pick("Cottage", "Bungalow") if storeys == 1 else m.pick("House", "Townhouse") if storeys < 3 else "Tenement"
    )
    if m.style.old:
        noun = m.pick("Cottage", "Longhouse") if storeys == 1 else m.pick("House", "TownHouse", "MerchantHouse")
    m.say(
        noun,
        BUILDINGS,
        f"{word(wall).capitalize()} house of {storeys} storeys with a {word(roof)} {form} roof, "
        f"{width / 100:.1f} x {depth / 100:.1f} m.",
        camel(wall),
        f"{camel(roof)}Roofed",
        tags="house building home",
    )
    m.b.box(wall, (width, depth, storeys * floor))
    m.b.box(m.mat("stone"), (width + 14, depth + 14, 40), body=None)
    facade(m, width, depth, storeys, floor)
    if m.style.ornate and wall.endswith("Plaster") and m.chance(0.6):
        timbers(m, width, depth, storeys, floor)
    top, rise = storeys * floor, depth * 0.42 * m.style.steep
    if form == "flat":
        flat_roof(m, width, depth, top)
    elif form == "hip":
        hip_roof(m, width, depth, top, rise * 0.9, roof)
    else:
        m.b.gable(wall, (depth, width, rise * 0.94), (0, 0, top), (0, 90, 0), body=None)
        gable_roof(m, width, depth, top, rise, roof)
        if form == "cross":
            with m.b.moved((m.pick(-1, 1) * width * 0.22, depth * 0.25, top)):
                m.b.gable(wall, (width * 0.32, depth * 0.52, rise * 0.8), (0, 0, 0), body=None)
                m.b.gable(roof, (width * 0.4, depth * 0.5, rise * 0.88), (0, -8, 0), body=None)
                window(m, 70, 80, (0, depth * 0.26, rise * 0.2))
    if form != "flat":
        chimney(m, (m.pick(-1, 1) * width * 0.3, -depth * 0.1, top + rise * 0.35), rise * 0.8)
    if m.opt("shop", False):
        awning(m, width * 0.8, depth / 2, 255)


def awning(m: KitMaker, width: float, y: float, z: float) -> None:
    """A sloped awning and a signboard over a shop window."""
    m.b.add(
        m.mat("awning"),
        hull(
            [
                (sx * width / 2, yy, zz)
                for sx in (-1, 1)
                for yy, zz in ((0.0, 0.0), (0.0, -6.0), (120.0, -50.0), (120.0, -56.0))
            ]
        ),
        (0, y, z),
        body=None,
    )
    m.b.box(m.mat("door"), (width, 8, 45), (0, y + 4, z + 8), body=None)


@family("shop")
def shop(m: KitMaker) -> None:
    """A narrow building of a street with a shop at its foot."""
    trade = m.opt(
        "trade",
        m.pick(
            "Bakery",
            "Bookshop",
            "Grocery",
            "Pharmacy",
            "Cafe",
            "FlowerShop",
            "BarberShop",
            "ShoeShop",
            "ToyShop",
            "Butchery",
            "Restaurant",
            "TeaHouse",
            "TailorShop",
            "Bank",
        ),
    )
    storeys = m.opt("storeys", m.pick(2, 3, 3, 4))
    width, depth, floor, wall = m.uni(650, 950, 50), m.opt("depth", 800.0), 300.0, m.mat("wall")
    m.say(
        trade,
        BUILDINGS,
        f"{word(wall).capitalize()} building of {storeys} storeys with a {trade.lower()} at street level, "
        f"{width / 100:.1f} m wide.",
        "",
        camel(wall),
        tags="shop building store",
    )
    m.b.box(wall, (width, depth, storeys * floor + 20))
    m.b.box(m.mat("door"), (width - 40, 10, 250), (0, depth / 2 + 2, 0), body=None)
    m.b.box(m.mat("window"), (width * 0.5, 10, 170), (-width * 0.16, depth / 2 + 5, 50), body=None)
    door(m, 100, 215, (width * 0.28, depth / 2 + 4, 0))
    awning(m, width - 60, depth / 2 + 6, 270)
    with m.b.moved((0, 0, floor)):
        facade(m, width, depth, storeys - 1, floor, doors=False)
    top = storeys * floor + 20
    if "Concrete" in m.mat("roof") or m.chance(0.35):
        flat_roof(m, width, depth, top)
    else:
        gable_roof(m, width - 58, depth, top, depth * 0.36 * m.style.steep, m.mat("roof"))
        chimney(m, (width * 0.3, -60, top + 100), 190)
