"""The outdoor source scenes, one a file."""

from cases.open190.places.outside import (
    campus,
    castle_yard,
    container_port,
    fairground,
    farm,
    fishing_village,
    forest_ruins,
    rail_yard,
    suburb,
    town_square,
)

__all__ = [
    "campus",
    "castle_yard",
    "container_port",
    "fairground",
    "farm",
    "fishing_village",
    "forest_ruins",
    "rail_yard",
    "suburb",
    "town_square",
]
