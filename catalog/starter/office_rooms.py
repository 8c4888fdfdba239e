"""Room modules of the office."""

from __future__ import annotations

from catalog.shapes import Builder, Kit
from catalog.starter.rooms import door_leaf, shell, tile, wall

KIT = Kit()
shell(KIT, "Plaster", "Office")


@KIT.asset("BrickWall300", "architecture", "Exposed brick wall module, 3 m long.", "wall brick module accent")
def _brick(b: Builder) -> None:
    wall(b, "BrickWall", 300)


@KIT.asset("OfficeDoor", "architecture", "Wooden door leaf with handles, 88 x 203 cm.", "door leaf wood")
def _door(b: Builder) -> None:
    door_leaf(b, "OakWood", "Steel")


@KIT.asset(
    "GlassPartition200",
    "architecture",
    "Glass partition with a dark metal frame, 2 m long, 2.4 m high.",
    "glass partition wall meeting room",
)
def _glass(b: Builder) -> None:
    for x in (-98, 0, 98):
        b.box("DarkMetal", (4, 6, 240), (x, 0, 0))
    for z in (0, 110, 234):
        b.box("DarkMetal", (192, 6, 6 if z != 110 else 4), (0, 0, z), body=None)
    for x in (-49, 49):
        b.box("Glass", (94, 1.2, 232), (x, 0, 3))


@KIT.asset(
    "DeskPartition",
    "architecture",
    "Low felt screen between desks, 160 cm wide, 125 cm high.",
    "partition screen divider felt cubicle",
)
def _partition(b: Builder) -> None:
    b.box("PartitionFelt", (156, 4, 115), (0, 0, 8), bevel=1)
    b.box("Steel", (160, 5, 2), (0, 0, 123))
    for x in (-78, 78):
        b.box("Steel", (4, 5, 123), (x, 0, 0))
        b.box("Steel", (6, 40, 2), (x, 0, 0), bevel=0.5)


@KIT.asset(
    "OfficeColumn",
    "architecture",
    "Square structural column with a base, 40 x 40 cm, 2.7 m high.",
    "column pillar concrete",
)
def _column(b: Builder) -> None:
    b.box("Plaster", (40, 40, 270), bevel=1.5)
    b.box("SkirtingWhite", (44, 44, 10), body=None, bevel=1)


@KIT.asset("FloorCarpet200", "architecture", "Grey carpet floor tile, 2 x 2 m, 2 cm thick.", "floor carpet tile")
def _carpet(b: Builder) -> None:
    tile(b, "CarpetTile")


@KIT.asset("FloorPlanks200", "architecture", "Wooden plank floor tile, 2 x 2 m, 2 cm thick.", "floor wood planks tile")
def _planks(b: Builder) -> None:
    tile(b, "OfficePlanks")


@KIT.asset("CeilingTile200", "architecture", "Suspended ceiling tile, 2 x 2 m.", "ceiling tile")
def _ceiling(b: Builder) -> None:
    tile(b, "CeilingTile", thick=4)
