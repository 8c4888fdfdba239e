"""The pack ``c4s-home``: a flat."""

from __future__ import annotations

from catalog.shapes import BlueprintPartSpec, BlueprintSpec, PackSpec
from catalog.starter import home_decor, home_kitchen_bath, home_living, home_rooms, indoor_materials

CATEGORIES = {
    "architecture": "Wall, window and doorway modules, doors and floor tiles.",
    "seating": "Sofas, chairs and stools.",
    "tables": "Dining, coffee and bedside tables, a desk.",
    "bedroom": "Beds, wardrobes and drawers.",
    "storage": "Shelves and media furniture.",
    "kitchen": "Counters, appliances and kitchenware.",
    "bathroom": "Bath, toilet, basin and what belongs to them.",
    "lighting": "Lamps.",
    "decor": "Rugs, curtains, pictures, plants, books, toys and small things.",
    "sets": "Compositions of several assets.",
}

BLUEPRINTS = (
    BlueprintSpec(
        "DiningSet",
        "sets",
        "A dining table with four chairs and a bowl of fruit.",
        ("dining", "table"),
        (
            BlueprintPartSpec("DiningTable"),
            BlueprintPartSpec("FruitBowl", (0, 0, 75)),
            *(BlueprintPartSpec("DiningChair", (x, 62, 0), 180.0) for x in (-40, 40)),
            *(BlueprintPartSpec("DiningChair", (x, -62, 0)) for x in (-40, 40)),
        ),
    ),
    BlueprintSpec(
        "BedsideSet",
        "sets",
        "A bedside table with a lamp and a book.",
        ("bedside", "lamp"),
        (
            BlueprintPartSpec("BedsideTable"),
            BlueprintPartSpec("TableLamp", (0, -6, 50)),
            BlueprintPartSpec("OpenBook", (2, 9, 50), 20.0),
        ),
    ),
    BlueprintSpec(
        "TvWall",
        "sets",
        "A media bench with a television on it.",
        ("tv", "media"),
        (BlueprintPartSpec("MediaBench"), BlueprintPartSpec("Television", (0, 0, 45))),
    ),
    BlueprintSpec(
        "FilledBookcase",
        "sets",
        "A bookcase with two rows of books and a vase.",
        ("bookcase", "books"),
        (
            BlueprintPartSpec("Bookcase"),
            BlueprintPartSpec("BookRowShort", (0, 0, 42.5)),
            BlueprintPartSpec("BookRowShort", (-6, 0, 78.5)),
            BlueprintPartSpec("TallVase", (8, 0, 114.5), scale=(0.8, 0.8, 0.8)),
        ),
    ),
)


def pack() -> PackSpec:
    """The specification of the pack."""
    return PackSpec(
        pack_id="c4s-home",
        content_folder="C4SHome",
        title="c4s starter pack: home",
        description="Furniture, fittings and room modules of a flat, in real sizes.",
        materials=indoor_materials.HOME,
        assets=[*home_rooms.KIT.assets, *home_living.KIT.assets, *home_kitchen_bath.KIT.assets, *home_decor.KIT.assets],
        blueprints=BLUEPRINTS,
        category_descriptions=CATEGORIES,
    )
