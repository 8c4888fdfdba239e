"""City crossing."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.parts.clutter import pavement_goods
from cases.open190.parts.streets import street
from cases.open190.scenes import scene
from catalog.kits import styles


@scene("city-crossing", "text", "City crossing", styles.URBAN, 130)
def city_crossing(p: StagedPlace) -> None:
    """Two avenues that cross between tall blocks, shops, traffic lights, buses and taxis."""
    p.plate(130, "Concrete")
    blocks = p.kit("block", 7)
    cars = [*p.kit("car", 7), *p.kit("car", 2, kind="Taxi"), *p.kit("truck", 2, kind="CityBus")]
    lamps, trees = p.kit("streetlamp", 3), p.kit("tree", 3, height=600.0)
    street(
        p,
        -6400,
        -700,
        0,
        north=p.kit("shop", 6),
        south=blocks,
        cars=cars,
        lamps=lamps,
        trees=trees,
        clutter=pavement_goods(p),
        wide=900,
    )
    street(
        p,
        700,
        6400,
        0,
        north=blocks[2:] + blocks[:2],
        south=p.kit("shop", 8)[2:],
        cars=cars,
        lamps=lamps,
        trees=trees,
        clutter=pavement_goods(p),
        wide=900,
    )
    with p.at(0, 0, 90):
        street(p, -6400, -700, 0, cars=cars, lamps=lamps, trees=trees, clutter=pavement_goods(p), wide=900)
        street(p, 700, 6400, 0, cars=cars, lamps=lamps, trees=trees, clutter=pavement_goods(p), wide=900)
    p.ground((-700, -700, 700, 700), "Asphalt", tile=700, z=0.7)
    zebra = p.one("road", length=300.0, wide=900.0, mark="zebra")
    for yaw in (0, 90, 180, 270):
        with p.at(0, 0, yaw):
            p.put(zebra, 560, 0, 1.2)
            p.put(p.kit("traffic-light", 2), 760, 560, yaw=90)
    p.put(p.one("statue"), 620 + 250, 1000)
    p.row((-6000, 5900), (6000, 5900), blocks, 5, yaw=180)
    p.palette(
        120, "car", "shop", "block", "sign", "planter", "bench", "streetlamp", "truck", "kiosk", "hydrant", "tree"
    )
