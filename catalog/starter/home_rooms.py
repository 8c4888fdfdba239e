"""Room modules of the flat."""

from __future__ import annotations

from catalog.shapes import Builder, Kit
from catalog.starter.rooms import door_leaf, shell, tile, wall

KIT = Kit()
shell(KIT, "Plaster", "Home")


@KIT.asset("SageWall300", "architecture", "Wall module in sage green, 3 m long.", "wall module green accent")
def _sage(b: Builder) -> None:
    wall(b, "WallGreen", 300)


@KIT.asset("HomeDoor", "architecture", "White panel door leaf with brass handles, 88 x 203 cm.", "door leaf white")
def _door(b: Builder) -> None:
    door_leaf(b, "WhiteLaminate", "Brass")


@KIT.asset("FloorParquet200", "architecture", "Parquet floor tile, 2 x 2 m, 2 cm thick.", "floor parquet wood tile")
def _parquet(b: Builder) -> None:
    tile(b, "Parquet")


@KIT.asset("FloorBath200", "architecture", "Light ceramic floor tile, 2 x 2 m, 2 cm thick.", "floor bathroom ceramic")
def _bath(b: Builder) -> None:
    tile(b, "BathTiles")


@KIT.asset(
    "FloorKitchen200", "architecture", "Chequered kitchen floor tile, 2 x 2 m, 2 cm thick.", "floor kitchen chequered"
)
def _kitchen(b: Builder) -> None:
    tile(b, "ChessTiles")
