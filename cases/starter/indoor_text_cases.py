"""The indoor text-to-scene cases of the starter suite. The oracle of each saves the scene that its text describes."""

from __future__ import annotations

from typing import Final

from cases.model import TextCase
from cases.requirements import Entity, Predicate, Quantity, RequirementSpec
from cases.starter import flat_scene, office_scene

OFFICE_TEXT = (
    "An open-plan office on one floor, eighteen by twelve metres, shown without its ceiling. Plain plaster walls with "
    "large windows enclose a grey carpet; one corner has exposed brick. About twenty oak desks stand in clusters of "
    "four, two facing two with low felt partitions between them, and every desk has a monitor or a laptop, a mouse and "
    "a blue task chair. In one corner a glazed meeting room with a wooden floor holds a long walnut meeting table with "
    "seven teal chairs around it, and a whiteboard hangs on its wall. In the brick corner a lounge has two teal sofas "
    "at right angles on a striped rug, with a low table between them and a tall plant. Near the entrance door a "
    "reception counter faces visitors, with three orange chairs along the wall. A copier and filing cabinets line the "
    "wall on the far side, and a water cooler stands next to a low cabinet with a coffee machine."
)

FLAT_TEXT = (
    "A furnished flat for a family, twelve by eight metres, seen without its ceiling. White walls divide it into a "
    "large living room, a hall, a small bathroom, a bedroom and a child's room. The floors are parquet, with "
    "chequered tiles in the kitchen corner. There, sage green counters, a sink, a stove and a fridge stand in one row "
    "along the wall. An oak dining table with four chairs stands in the middle of the big room, with a bowl of fruit "
    "on it. A grey sofa faces a television on a low bench across a walnut coffee table and a red patterned rug; a "
    "mustard armchair stands beside the rug. The bedroom has a double bed between two bedside tables with lamps, and a "
    "large wardrobe. The child's room has a small bed, a writing desk with a globe under the window, and toys on a "
    "blue rug. The bathroom holds a bathtub, a toilet and a washbasin. Rust-coloured curtains hang at the windows."
)

_EXACT: Final = "exact"

OFFICE_REQUIREMENTS = RequirementSpec(
    entities=(
        Entity("office", "An open-plan office", entity_type="region"),
        Entity("walls", "Plain plaster walls", ("wall",), collection=True),
        Entity("carpet", "grey carpet", ("floor",), entity_type="surface"),
        Entity("desks", "oak desks", ("desk",), collection=True),
        Entity("partitions", "low felt partitions", ("partition", "divider"), collection=True),
        Entity("screens", "a monitor or a laptop", ("monitor", "laptop"), collection=True),
        Entity("task chairs", "blue task chair", ("task chair",), collection=True),
        Entity("meeting room", "glazed meeting room", ("glass partition",), entity_type="region"),
        Entity("meeting table", "long walnut meeting table"),
        Entity("meeting chairs", "seven teal chairs", ("conference chair",), collection=True),
        Entity("whiteboard", "whiteboard"),
        Entity("sofas", "two teal sofas", ("sofa",), collection=True),
        Entity("rug", "striped rug"),
        Entity("low table", "low table", ("side table",)),
        Entity("plant", "tall plant"),
        Entity("counter", "reception counter"),
        Entity("door", "entrance door", ("door",)),
        Entity("visitor chairs", "three orange chairs", ("visitor chair",), collection=True),
        Entity("copier", "copier", ("printer",)),
        Entity("filing cabinets", "filing cabinets", collection=True),
        Entity("water cooler", "water cooler"),
        Entity("coffee machine", "coffee machine"),
        Entity("low cabinet", "low cabinet"),
    ),
    predicates=(
        Predicate("scene_identity", "open-plan office", "An open-plan office on one floor", "office"),
        Predicate(
            "environment",
            "walls around carpet",
            "Plain plaster walls with large windows enclose a grey carpet",
            "walls",
            "carpet",
            "encloses",
        ),
        Predicate(
            "quantity", "twenty desks", "About twenty oak desks", "desks", quantity=Quantity("approximately", 20)
        ),
        Predicate("material", "oak desks", "oak desks", "desks", qualifiers=(("material", "oak"),)),
        Predicate("distribution", "clusters of four", "stand in clusters of four", "desks"),
        Predicate(
            "spatial_relation",
            "partitions between desks",
            "with low felt partitions between them",
            "partitions",
            "desks",
            "between",
        ),
        Predicate(
            "quantity",
            "screen at every desk",
            "every desk has a monitor or a laptop",
            "screens",
            quantity=Quantity("approximately", 20),
        ),
        Predicate("attribute", "blue task chairs", "a blue task chair", "task chairs", qualifiers=(("color", "blue"),)),
        Predicate("existence", "glazed meeting room", "a glazed meeting room", "meeting room"),
        Predicate(
            "material",
            "walnut meeting table",
            "a long walnut meeting table",
            "meeting table",
            qualifiers=(("material", "walnut"), ("shape", "long")),
        ),
        Predicate(
            "quantity", "seven chairs at the table", "seven teal chairs", "meeting chairs", quantity=Quantity(_EXACT, 7)
        ),
        Predicate(
            "spatial_relation",
            "chairs around the table",
            "with seven teal chairs around it",
            "meeting chairs",
            "meeting table",
            "around",
        ),
        Predicate(
            "spatial_relation", "whiteboard on the wall", "a whiteboard hangs on its wall", "whiteboard", "walls", "on"
        ),
        Predicate("quantity", "two sofas", "two teal sofas", "sofas", quantity=Quantity(_EXACT, 2)),
        Predicate("spatial_relation", "sofas on the rug", "at right angles on a striped rug", "sofas", "rug", "around"),
        Predicate("existence", "low table", "a low table between them", "low table"),
        Predicate("existence", "tall plant", "a tall plant", "plant"),
        Predicate(
            "spatial_relation",
            "counter near the door",
            "Near the entrance door a reception counter",
            "counter",
            "door",
            "near",
        ),
        Predicate(
            "quantity",
            "three visitor chairs",
            "three orange chairs",
            "visitor chairs",
            quantity=Quantity("at_least", 3),
        ),
        Predicate("existence", "copier and cabinets", "A copier and filing cabinets", "copier", "filing cabinets"),
        Predicate(
            "spatial_relation",
            "water cooler next to the cabinet",
            "a water cooler stands next to a low cabinet",
            "water cooler",
            "low cabinet",
            "next_to",
        ),
        Predicate("existence", "coffee machine", "a coffee machine", "coffee machine"),
    ),
)

FLAT_REQUIREMENTS = RequirementSpec(
    entities=(
        Entity("flat", "A furnished flat", entity_type="region"),
        Entity("walls", "White walls", ("wall",), collection=True),
        Entity("floors", "parquet", ("floor",), entity_type="surface"),
        Entity("kitchen tiles", "chequered tiles", ("floor kitchen",), entity_type="surface"),
        Entity("counters", "sage green counters", ("counter",), collection=True),
        Entity("sink", "a sink"),
        Entity("stove", "a stove"),
        Entity("fridge", "a fridge"),
        Entity("dining table", "oak dining table"),
        Entity("dining chairs", "four chairs", ("dining chair",), collection=True),
        Entity("fruit bowl", "bowl of fruit"),
        Entity("sofa", "grey sofa"),
        Entity("television", "television", ("tv",)),
        Entity("bench", "low bench", ("media bench",)),
        Entity("coffee table", "walnut coffee table"),
        Entity("red rug", "red patterned rug", ("persian rug",)),
        Entity("armchair", "mustard armchair"),
        Entity("double bed", "double bed"),
        Entity("bedside tables", "two bedside tables", ("bedside table", "bedside set"), collection=True),
        Entity("wardrobe", "large wardrobe"),
        Entity("child bed", "small bed"),
        Entity("writing desk", "writing desk"),
        Entity("globe", "globe"),
        Entity("toys", "toys", ("teddy bear", "toy train", "toy blocks"), collection=True),
        Entity("blue rug", "blue rug"),
        Entity("bathtub", "a bathtub"),
        Entity("toilet", "a toilet"),
        Entity("washbasin", "a washbasin"),
        Entity("curtains", "curtains", ("curtain",), collection=True),
    ),
    predicates=(
        Predicate("scene_identity", "furnished flat", "A furnished flat for a family", "flat"),
        Predicate(
            "composition",
            "rooms divided by walls",
            "White walls divide it into a large living room, a hall, a small bathroom, a bedroom and a child's room",
            "walls",
        ),
        Predicate(
            "material", "parquet floors", "The floors are parquet", "floors", qualifiers=(("material", "parquet"),)
        ),
        Predicate(
            "attribute",
            "chequered kitchen tiles",
            "chequered tiles in the kitchen corner",
            "kitchen tiles",
            qualifiers=(("style", "chequered"),),
        ),
        Predicate(
            "attribute", "sage green counters", "sage green counters", "counters", qualifiers=(("color", "sage green"),)
        ),
        Predicate(
            "distribution", "kitchen in one row", "stand in one row along the wall", "counters", "walls", "along"
        ),
        Predicate("existence", "sink", "a sink", "sink"),
        Predicate("existence", "stove", "a stove", "stove"),
        Predicate("existence", "fridge", "a fridge", "fridge"),
        Predicate(
            "quantity",
            "four dining chairs",
            "An oak dining table with four chairs",
            "dining chairs",
            quantity=Quantity("at_least", 4),
        ),
        Predicate(
            "spatial_relation", "fruit on the table", "with a bowl of fruit on it", "fruit bowl", "dining table", "on"
        ),
        Predicate(
            "spatial_relation", "sofa faces television", "A grey sofa faces a television", "sofa", "television", "faces"
        ),
        Predicate(
            "spatial_relation", "television on bench", "a television on a low bench", "television", "bench", "on"
        ),
        Predicate("existence", "coffee table", "a walnut coffee table", "coffee table"),
        Predicate("attribute", "red rug", "a red patterned rug", "red rug", qualifiers=(("color", "red"),)),
        Predicate(
            "spatial_relation",
            "armchair beside the rug",
            "a mustard armchair stands beside the rug",
            "armchair",
            "red rug",
            "beside",
        ),
        Predicate(
            "spatial_relation",
            "bed between bedside tables",
            "a double bed between two bedside tables",
            "double bed",
            "bedside tables",
            "between",
        ),
        Predicate(
            "quantity",
            "two bedside tables",
            "two bedside tables with lamps",
            "bedside tables",
            quantity=Quantity(_EXACT, 2),
        ),
        Predicate("existence", "wardrobe", "a large wardrobe", "wardrobe"),
        Predicate("existence", "child bed", "a small bed", "child bed"),
        Predicate(
            "spatial_relation", "globe on the desk", "a writing desk with a globe", "globe", "writing desk", "on"
        ),
        Predicate("spatial_relation", "toys on the rug", "toys on a blue rug", "toys", "blue rug", "on"),
        Predicate("existence", "bathtub", "a bathtub", "bathtub"),
        Predicate("existence", "toilet", "a toilet", "toilet"),
        Predicate("existence", "washbasin", "a washbasin", "washbasin"),
        Predicate("existence", "curtains", "Rust-coloured curtains hang at the windows", "curtains"),
    ),
)

INDOOR_TEXT_CASES: list[TextCase] = [
    TextCase(
        "text-office-open-plan",
        office_scene.SCENE_ID,
        "Open-plan office",
        OFFICE_TEXT,
        OFFICE_REQUIREMENTS,
        200.0,
        "hard",
        minimum_actors=60,
    ),
    TextCase(
        "text-flat-family",
        flat_scene.SCENE_ID,
        "Flat for a family",
        FLAT_TEXT,
        FLAT_REQUIREMENTS,
        130.0,
        "medium",
        minimum_actors=40,
    ),
]
