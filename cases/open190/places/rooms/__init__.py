"""The indoor source scenes, one a file."""

from cases.open190.places.rooms import (
    hospital_ward,
    library,
    loft,
    machine_shop,
    metro_station,
    museum,
    office_floor,
    school,
    supermarket,
    tavern,
)

__all__ = [
    "hospital_ward",
    "library",
    "loft",
    "machine_shop",
    "metro_station",
    "museum",
    "office_floor",
    "school",
    "supermarket",
    "tavern",
]
