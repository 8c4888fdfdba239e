"""The indoor text-to-scene cases of the starter suite. The oracle of each saves the scene that its text describes."""

from __future__ import annotations

from typing import Final

from cases.model import TextCase
from cases.requirements import EntitySpec, PredicateSpec, Quantity, RequirementSpec
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
        EntitySpec("office", "An open-plan office", entity_type="region"),
        EntitySpec("walls", "Plain plaster walls", ("wall",), collection=True),
        EntitySpec("carpet", "grey carpet", ("floor carpet",), entity_type="surface"),
        EntitySpec("brick wall", "exposed brick", ("brick wall",)),
        EntitySpec("desks", "oak desks", ("desk",), collection=True),
        EntitySpec("desk partitions", "low felt partitions", ("felt divider",), collection=True),
        EntitySpec("screens", "a monitor or a laptop", ("monitor", "laptop"), collection=True),
        EntitySpec("mouse", "mouse", ("computer mouse",), collection=True),
        EntitySpec("task chairs", "blue task chair", ("task chair",), collection=True),
        EntitySpec("meeting room", "glazed meeting room", ("glass partition",), entity_type="region"),
        EntitySpec("meeting room floor", "wooden floor", ("floor planks",), entity_type="surface"),
        EntitySpec("meeting table", "long walnut meeting table"),
        EntitySpec("meeting chairs", "seven teal chairs", ("conference chair",), collection=True),
        EntitySpec("whiteboard", "whiteboard"),
        EntitySpec("lounge", "a lounge", entity_type="region"),
        EntitySpec("sofas", "two teal sofas", ("sofa",), collection=True),
        EntitySpec("rug", "striped rug"),
        EntitySpec("low table", "low table", ("side table",)),
        EntitySpec("tall plant", "tall plant"),
        EntitySpec("counter", "reception counter"),
        EntitySpec("door", "entrance door", ("door",)),
        EntitySpec("visitor chairs", "three orange chairs", ("visitor chair",), collection=True),
        EntitySpec("copier", "copier", ("printer",)),
        EntitySpec("filing cabinets", "filing cabinets", collection=True),
        EntitySpec("water cooler", "water cooler"),
        EntitySpec("coffee machine", "coffee machine"),
        EntitySpec("low cabinet", "low cabinet"),
    ),
    predicates=(
        PredicateSpec("scene_identity", "open-plan office", "An open-plan office on one floor", "office"),
        PredicateSpec(
            "attribute",
            "eighteen by twelve metres",
            "eighteen by twelve metres",
            "office",
            qualifiers=(("attribute", "eighteen by twelve metres"),),
        ),
        PredicateSpec("composition", "office without its ceiling", "shown without its ceiling", "office"),
        PredicateSpec(
            "environment",
            "walls around carpet",
            "Plain plaster walls with large windows enclose a grey carpet",
            "walls",
            "carpet",
            "encloses",
        ),
        PredicateSpec(
            "material",
            "brick in one corner",
            "one corner has exposed brick",
            "brick wall",
            qualifiers=(("material", "brick"),),
        ),
        PredicateSpec(
            "quantity", "twenty desks", "About twenty oak desks", "desks", quantity=Quantity("approximately", 20)
        ),
        PredicateSpec("material", "oak desks", "oak desks", "desks", qualifiers=(("material", "oak"),)),
        PredicateSpec("distribution", "clusters of four", "stand in clusters of four, two facing two", "desks"),
        PredicateSpec(
            "spatial_relation",
            "partitions between desks",
            "with low felt partitions between them",
            "desk partitions",
            "desks",
            "between",
        ),
        PredicateSpec(
            "quantity",
            "screen at every desk",
            "every desk has a monitor or a laptop",
            "screens",
            quantity=Quantity("approximately", 20),
        ),
        PredicateSpec("existence", "mouse", "a mouse", "mouse"),
        PredicateSpec(
            "attribute", "blue task chairs", "a blue task chair", "task chairs", qualifiers=(("color", "blue"),)
        ),
        PredicateSpec("existence", "glazed meeting room", "In one corner a glazed meeting room", "meeting room"),
        PredicateSpec(
            "material",
            "wooden floor in the meeting room",
            "a wooden floor",
            "meeting room floor",
            qualifiers=(("material", "wooden"),),
        ),
        PredicateSpec(
            "spatial_relation",
            "table in the meeting room",
            "holds a long walnut meeting table",
            "meeting table",
            "meeting room",
            "inside",
        ),
        PredicateSpec(
            "material",
            "walnut meeting table",
            "a long walnut meeting table",
            "meeting table",
            qualifiers=(("material", "walnut"), ("shape", "long")),
        ),
        PredicateSpec(
            "quantity", "seven chairs at the table", "seven teal chairs", "meeting chairs", quantity=Quantity(_EXACT, 7)
        ),
        PredicateSpec(
            "spatial_relation",
            "chairs around the table",
            "with seven teal chairs around it",
            "meeting chairs",
            "meeting table",
            "around",
        ),
        PredicateSpec(
            "spatial_relation", "whiteboard on the wall", "a whiteboard hangs on its wall", "whiteboard", "walls", "on"
        ),
        PredicateSpec(
            "spatial_relation", "lounge at the brick", "In the brick corner a lounge", "lounge", "brick wall", "near"
        ),
        PredicateSpec("quantity", "two sofas", "two teal sofas", "sofas", quantity=Quantity(_EXACT, 2)),
        PredicateSpec(
            "spatial_relation", "sofas on the rug", "at right angles on a striped rug", "sofas", "rug", "around"
        ),
        PredicateSpec("existence", "low table", "a low table between them", "low table"),
        PredicateSpec("existence", "tall plant", "a tall plant", "tall plant"),
        PredicateSpec(
            "spatial_relation",
            "counter near the door",
            "Near the entrance door a reception counter faces visitors",
            "counter",
            "door",
            "near",
        ),
        PredicateSpec(
            "quantity",
            "three visitor chairs",
            "three orange chairs",
            "visitor chairs",
            quantity=Quantity("at_least", 3),
        ),
        PredicateSpec(
            "spatial_relation",
            "visitor chairs along the wall",
            "three orange chairs along the wall",
            "visitor chairs",
            "walls",
            "along",
        ),
        PredicateSpec("existence", "copier", "A copier", "copier"),
        PredicateSpec("existence", "filing cabinets", "filing cabinets", "filing cabinets"),
        PredicateSpec(
            "spatial_relation",
            "cabinets along the far wall",
            "A copier and filing cabinets line the wall on the far side",
            "filing cabinets",
            "walls",
            "along",
        ),
        PredicateSpec(
            "spatial_relation",
            "water cooler next to the cabinet",
            "a water cooler stands next to a low cabinet",
            "water cooler",
            "low cabinet",
            "next_to",
        ),
        PredicateSpec("existence", "coffee machine", "a coffee machine", "coffee machine"),
    ),
)

FLAT_REQUIREMENTS = RequirementSpec(
    entities=(
        EntitySpec("flat", "A furnished flat", entity_type="region"),
        EntitySpec("walls", "White walls", ("wall",), collection=True),
        EntitySpec("living room", "large living room", entity_type="region"),
        EntitySpec("bathroom", "The bathroom", entity_type="region"),
        EntitySpec("bedroom", "The bedroom", entity_type="region"),
        EntitySpec("child's room", "The child's room", entity_type="region"),
        EntitySpec("window", "the window", entity_type="region"),
        EntitySpec("floors", "parquet", ("floor",), entity_type="surface"),
        EntitySpec("kitchen tiles", "chequered tiles", ("floor kitchen",), entity_type="surface"),
        EntitySpec("counters", "sage green counters", ("counter",), collection=True),
        EntitySpec("sink", "a sink"),
        EntitySpec("stove", "a stove"),
        EntitySpec("fridge", "a fridge"),
        EntitySpec("dining table", "oak dining table"),
        EntitySpec("dining chairs", "four chairs", ("dining chair",), collection=True),
        EntitySpec("fruit bowl", "bowl of fruit"),
        EntitySpec("sofa", "grey sofa"),
        EntitySpec("television", "television", ("tv",)),
        EntitySpec("bench", "low bench", ("media bench",)),
        EntitySpec("coffee table", "walnut coffee table"),
        EntitySpec("red rug", "red patterned rug", ("persian rug",)),
        EntitySpec("armchair", "mustard armchair"),
        EntitySpec("double bed", "double bed"),
        EntitySpec("bedside tables", "two bedside tables", ("bedside table", "bedside set"), collection=True),
        EntitySpec("wardrobe", "large wardrobe"),
        EntitySpec("child bed", "small bed"),
        EntitySpec("writing desk", "writing desk"),
        EntitySpec("globe", "globe"),
        EntitySpec("toys", "toys", ("teddy bear", "toy train", "toy blocks"), collection=True),
        EntitySpec("blue rug", "blue rug"),
        EntitySpec("bathtub", "a bathtub"),
        EntitySpec("toilet", "a toilet"),
        EntitySpec("washbasin", "a washbasin"),
        EntitySpec("curtains", "curtains", ("curtain",), collection=True),
    ),
    predicates=(
        PredicateSpec("scene_identity", "furnished flat", "A furnished flat for a family", "flat"),
        PredicateSpec(
            "attribute",
            "twelve by eight metres",
            "twelve by eight metres",
            "flat",
            qualifiers=(("attribute", "twelve by eight metres"),),
        ),
        PredicateSpec("composition", "flat without its ceiling", "seen without its ceiling", "flat"),
        PredicateSpec(
            "composition",
            "rooms divided by walls",
            "White walls divide it into a large living room, a hall, a small bathroom, a bedroom and a child's room",
            "walls",
        ),
        PredicateSpec(
            "material", "parquet floors", "The floors are parquet", "floors", qualifiers=(("material", "parquet"),)
        ),
        PredicateSpec(
            "attribute",
            "chequered kitchen tiles",
            "chequered tiles in the kitchen corner",
            "kitchen tiles",
            qualifiers=(("style", "chequered"),),
        ),
        PredicateSpec(
            "attribute", "sage green counters", "sage green counters", "counters", qualifiers=(("color", "sage green"),)
        ),
        PredicateSpec(
            "distribution", "kitchen in one row", "stand in one row along the wall", "counters", "walls", "along"
        ),
        PredicateSpec("existence", "sink", "a sink", "sink"),
        PredicateSpec("existence", "stove", "a stove", "stove"),
        PredicateSpec("existence", "fridge", "a fridge", "fridge"),
        PredicateSpec(
            "material", "oak dining table", "An oak dining table", "dining table", qualifiers=(("material", "oak"),)
        ),
        PredicateSpec(
            "spatial_relation",
            "dining table in the big room",
            "stands in the middle of the big room",
            "dining table",
            "living room",
            "inside",
        ),
        PredicateSpec(
            "quantity",
            "four dining chairs",
            "An oak dining table with four chairs",
            "dining chairs",
            quantity=Quantity("at_least", 4),
        ),
        PredicateSpec(
            "spatial_relation", "fruit on the table", "with a bowl of fruit on it", "fruit bowl", "dining table", "on"
        ),
        PredicateSpec(
            "spatial_relation", "sofa faces television", "A grey sofa faces a television", "sofa", "television", "faces"
        ),
        PredicateSpec(
            "spatial_relation", "television on bench", "a television on a low bench", "television", "bench", "on"
        ),
        PredicateSpec("existence", "coffee table", "across a walnut coffee table", "coffee table"),
        PredicateSpec("attribute", "red rug", "a red patterned rug", "red rug", qualifiers=(("color", "red"),)),
        PredicateSpec(
            "spatial_relation",
            "armchair beside the rug",
            "a mustard armchair stands beside the rug",
            "armchair",
            "red rug",
            "beside",
        ),
        PredicateSpec(
            "spatial_relation",
            "double bed in the bedroom",
            "The bedroom has a double bed",
            "double bed",
            "bedroom",
            "inside",
        ),
        PredicateSpec(
            "spatial_relation",
            "bed between bedside tables",
            "a double bed between two bedside tables",
            "double bed",
            "bedside tables",
            "between",
        ),
        PredicateSpec(
            "quantity",
            "two bedside tables",
            "two bedside tables with lamps",
            "bedside tables",
            quantity=Quantity(_EXACT, 2),
        ),
        PredicateSpec("existence", "wardrobe", "a large wardrobe", "wardrobe"),
        PredicateSpec(
            "spatial_relation",
            "small bed in the child's room",
            "The child's room has a small bed",
            "child bed",
            "child's room",
            "inside",
        ),
        PredicateSpec(
            "spatial_relation", "desk under the window", "under the window", "writing desk", "window", "under"
        ),
        PredicateSpec(
            "spatial_relation", "globe on the desk", "a writing desk with a globe", "globe", "writing desk", "on"
        ),
        PredicateSpec("spatial_relation", "toys on the rug", "toys on a blue rug", "toys", "blue rug", "on"),
        PredicateSpec(
            "spatial_relation",
            "bathtub in the bathroom",
            "The bathroom holds a bathtub",
            "bathtub",
            "bathroom",
            "inside",
        ),
        PredicateSpec("existence", "toilet", "a toilet", "toilet"),
        PredicateSpec("existence", "washbasin", "a washbasin", "washbasin"),
        PredicateSpec("existence", "curtains", "Rust-coloured curtains hang at the windows", "curtains"),
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
