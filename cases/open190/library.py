"""All scenes, in the order in which the plan deals with them."""

from typing import Final

from cases.open190 import places
from cases.open190.scenes import REGISTERED, SceneSpec

LAID_OUT = places
"""Importing them registers their scenes."""
ORDER: Final = (
    "market-town",
    "mountain-monastery",
    "viking-harbour",
    "caravanserai",
    "windmill-village",
    "vineyard",
    "roman-forum",
    "wizard-village",
    "crystal-camp",
    "elf-river",
    "war-camp",
    "cemetery-hill",
    "tavern",
    "supermarket",
    "library",
    "metro-station",
    "museum",
    "hospital-ward",
    "school",
    "office-floor",
    "machine-shop",
    "loft",
    "fishing-village",
    "castle-yard",
    "town-square",
    "container-port",
    "fairground",
    "rail-yard",
    "campus",
    "forest-ruins",
    "farm",
    "suburb",
    "city-crossing",
    "park-lake",
    "tram-street",
    "bus-terminal",
    "country-station",
    "airfield",
    "brickworks",
    "refinery",
    "building-site",
    "sawmill",
    "power-station",
    "allotments",
    "quiet-close",
    "camping",
    "school-grounds",
    "business-park",
    "toy-town",
    "winter-village",
)
"""In another order the same seed deals other repairs to the scenes."""
SCENES: Final[dict[str, SceneSpec]] = {name: REGISTERED[name] for name in ORDER}

__all__ = ["LAID_OUT", "ORDER", "SCENES"]
