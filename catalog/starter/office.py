"""The pack ``c4s-office``: an open-plan office."""

from __future__ import annotations

from catalog.shapes import BlueprintPartSpec, BlueprintSpec, PackSpec
from catalog.starter import indoor_materials, office_equipment, office_furniture, office_rooms

CATEGORIES = {
    "architecture": "Wall, window and doorway modules, doors, partitions, columns, floor and ceiling tiles.",
    "desks": "Desks, tables and counters.",
    "seating": "Chairs, stools and sofas.",
    "storage": "Cabinets, shelves, lockers and stands.",
    "equipment": "Computers, phones, printers and machines.",
    "lighting": "Desk, floor, pendant and ceiling lamps.",
    "decor": "Plants, books, boards, clocks, bins and small things.",
    "sets": "Compositions of several assets.",
}

BLUEPRINTS = (
    BlueprintSpec(
        "DeskSet",
        "sets",
        "A desk with monitor, keyboard, mouse, drawers and a task chair in front of it.",
        ("desk", "set", "workplace"),
        (
            BlueprintPartSpec("OfficeDesk"),
            BlueprintPartSpec("Monitor", (0, -16, 74)),
            BlueprintPartSpec("Keyboard", (0, 16, 74)),
            BlueprintPartSpec("Mouse", (32, 16, 74)),
            BlueprintPartSpec("DrawerPedestal", (-52, 4, 0)),
            BlueprintPartSpec("TaskChair", (0, 78, 0), 180.0),
        ),
    ),
    BlueprintSpec(
        "MeetingSet",
        "sets",
        "A meeting table with six conference chairs.",
        ("meeting", "set", "table"),
        (
            BlueprintPartSpec("MeetingTable"),
            *(BlueprintPartSpec("ConferenceChair", (x, 100, 0), 180.0) for x in (-75, 0, 75)),
            *(BlueprintPartSpec("ConferenceChair", (x, -100, 0)) for x in (-75, 0, 75)),
        ),
    ),
    BlueprintSpec(
        "LoungeSet",
        "sets",
        "A two-seat sofa and a low table with books on a rug.",
        ("lounge", "sofa"),
        (
            BlueprintPartSpec("LoungeRug"),
            BlueprintPartSpec("OfficeSofa", (0, -60, 1)),
            BlueprintPartSpec("SideTable", (0, 45, 1)),
            BlueprintPartSpec("BookStack", (8, 45, 42)),
        ),
    ),
    BlueprintSpec(
        "ShelfWithBooks",
        "sets",
        "A tall bookshelf with three filled boards.",
        ("bookshelf", "books"),
        (
            BlueprintPartSpec("TallBookshelf"),
            BlueprintPartSpec("BookRow", (-8, 0, 44.5)),
            BlueprintPartSpec("BookRow", (6, 0, 82.5)),
            BlueprintPartSpec("BinderRow", (0, 0, 120.5)),
        ),
    ),
)


def pack() -> PackSpec:
    """The specification of the pack."""
    return PackSpec(
        pack_id="c4s-office",
        content_folder="C4SOffice",
        title="c4s starter pack: office",
        description="Furniture, equipment and room modules of an office, in real sizes.",
        materials=indoor_materials.OFFICE,
        assets=[*office_rooms.KIT.assets, *office_furniture.KIT.assets, *office_equipment.KIT.assets],
        blueprints=BLUEPRINTS,
        category_descriptions=CATEGORIES,
    )
