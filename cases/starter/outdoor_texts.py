"""The two outdoor texts of the starter suite, with their requirements."""

from __future__ import annotations

from cases.model import TextCase
from cases.requirements import EntitySpec, PredicateSpec, Quantity, RequirementSpec
from cases.starter import farm_scene, harbour_scene

HARBOUR, FARM = harbour_scene.PATHS, farm_scene.PATHS

HARBOUR_TEXT = (
    "Build a colourful northern harbour street on a clear day. A long stone quay runs straight along calm blue "
    "water, with a broad cobbled promenade beside it, then an asphalt road, then a pavement of pale stone. Behind "
    "the pavement stand roughly seventeen attached townhouses in one continuous row, in red and cream plaster and "
    "dark brick, with slate and tiled roofs. A narrow canal cuts through the row and is crossed by two stone "
    "bridges. On the promenade seven market stalls with striped awnings stand in a line facing the water, and cafe "
    "tables with parasols stand next to a green kiosk. A tall yellow crane and stacked shipping containers mark the "
    "working end of the quay beside a brick warehouse. Several fishing boats and sailing boats float on the water "
    "along the quay, and a wooden jetty reaches out between them. A red and white lighthouse stands at the far end "
    "of a stone mole. Add street lamps and benches along the promenade, leafy trees between the lamps, iron "
    "bollards at regular intervals along the edge, and a few parked cars on the road. Keep the quayside dense with "
    "barrels, crates and nets, but leave the road itself open."
)


def harbour_text() -> TextCase:
    """The harbour as a text."""
    entities = (
        EntitySpec("harbour street", "harbour street", ("harbour", "waterfront", "port"), "region"),
        EntitySpec("quay", "stone quay", ("quay wall", "embankment"), "object", True),
        EntitySpec("water", "blue water", ("water tile", "sea", "harbour basin"), "surface", True),
        EntitySpec("promenade", "cobbled promenade", ("cobble tile", "cobblestone"), "surface", True),
        EntitySpec("road", "asphalt road", ("road tile", "street", "crossing tile"), "surface", True),
        EntitySpec("pavement", "pavement of pale stone", ("paving tile", "sidewalk"), "surface", True),
        EntitySpec("townhouses", "attached townhouses", ("townhouse", "house", "building"), collection=True),
        EntitySpec("canal", "narrow canal", ("water tile", "canal water"), "region"),
        EntitySpec("bridges", "stone bridges", ("bridge", "stone bridge"), collection=True),
        EntitySpec("market stalls", "market stalls", ("stall", "market stall"), collection=True),
        EntitySpec("cafe tables", "cafe tables", ("cafe table", "table"), collection=True),
        EntitySpec("parasols", "parasols", ("parasol", "umbrella"), collection=True),
        EntitySpec("kiosk", "green kiosk", ("kiosk", "hut")),
        EntitySpec("crane", "yellow crane", ("harbour crane", "crane")),
        EntitySpec("containers", "shipping containers", ("cargo container", "container"), collection=True),
        EntitySpec("warehouse", "brick warehouse", ("warehouse",)),
        EntitySpec("fishing boats", "fishing boats", ("fishing boat", "trawler"), collection=True),
        EntitySpec("sailing boats", "sailing boats", ("sailing boat", "yacht"), collection=True),
        EntitySpec("jetty", "wooden jetty", ("jetty planks", "pier"), collection=True),
        EntitySpec("lighthouse", "lighthouse", ("lighthouse",)),
        EntitySpec("mole", "stone mole", ("breakwater",), "region"),
        EntitySpec("street lamps", "street lamps", ("street lamp", "lantern"), collection=True),
        EntitySpec("benches", "benches", ("bench",), collection=True),
        EntitySpec("trees", "leafy trees", ("street tree", "tree"), collection=True),
        EntitySpec("bollards", "iron bollards", ("bollard",), collection=True),
        EntitySpec("cars", "parked cars", ("car", "van", "vehicle"), collection=True),
        EntitySpec("barrels", "barrels", ("barrel",), collection=True),
        EntitySpec("crates", "crates", ("wooden crate", "crate"), collection=True),
        EntitySpec("nets", "nets", ("net pile", "fishing net"), collection=True),
    )
    has = _existence
    predicates = (
        PredicateSpec(
            "scene_identity", "scene is a northern harbour street", "northern harbour street", "harbour street"
        ),
        PredicateSpec(
            "environment", "clear day", "on a clear day", "harbour street", qualifiers=(("lighting", "clear day"),)
        ),
        PredicateSpec(
            "environment",
            "harbour is colourful",
            "colourful",
            "harbour street",
            qualifiers=(("atmosphere", "colourful"),),
        ),
        has("stone quay", "quay"),
        PredicateSpec(
            "spatial_relation",
            "quay along the water",
            "A long stone quay runs straight along calm blue water",
            "quay",
            "water",
            "along",
        ),
        has("calm blue water", "water"),
        PredicateSpec(
            "spatial_relation",
            "promenade beside the quay",
            "a broad cobbled promenade beside it",
            "promenade",
            "quay",
            "beside",
        ),
        has("asphalt road", "road"),
        has("pavement of pale stone", "pavement"),
        PredicateSpec(
            "quantity",
            "roughly seventeen townhouses",
            "roughly seventeen attached townhouses",
            "townhouses",
            quantity=Quantity("approximately", 17),
        ),
        PredicateSpec(
            "attribute",
            "townhouses are red and cream",
            "red and cream plaster",
            "townhouses",
            qualifiers=(("color", "red"), ("color", "cream")),
        ),
        PredicateSpec(
            "material",
            "townhouses of plaster and brick",
            "plaster and dark brick",
            "townhouses",
            qualifiers=(("material", "plaster"), ("material", "brick")),
        ),
        PredicateSpec(
            "material",
            "roofs of slate and tile",
            "slate and tiled roofs",
            "townhouses",
            qualifiers=(("material", "slate"), ("material", "tiled")),
        ),
        PredicateSpec(
            "distribution",
            "townhouses form one row",
            "in one continuous row",
            "townhouses",
            relation="in_row",
            qualifiers=(("layout", "row"),),
        ),
        PredicateSpec(
            "spatial_relation",
            "townhouses behind the pavement",
            "Behind the pavement stand roughly seventeen attached townhouses",
            "townhouses",
            "pavement",
            "behind",
        ),
        PredicateSpec(
            "spatial_relation",
            "canal through the row",
            "A narrow canal cuts through the row",
            "canal",
            "townhouses",
            "through",
        ),
        PredicateSpec("quantity", "two bridges", "two stone bridges", "bridges", quantity=Quantity("exact", 2)),
        PredicateSpec(
            "spatial_relation",
            "bridges cross the canal",
            "is crossed by two stone bridges",
            "bridges",
            "canal",
            "across",
        ),
        PredicateSpec(
            "quantity", "seven market stalls", "seven market stalls", "market stalls", quantity=Quantity("exact", 7)
        ),
        PredicateSpec(
            "attribute",
            "awnings are striped",
            "striped awnings",
            "market stalls",
            qualifiers=(("attribute", "striped"),),
        ),
        PredicateSpec(
            "distribution",
            "stalls in a line",
            "stand in a line facing the water",
            "market stalls",
            relation="in_line",
            qualifiers=(("layout", "line"),),
        ),
        PredicateSpec(
            "spatial_relation",
            "stalls on the promenade",
            "On the promenade seven market stalls",
            "market stalls",
            "promenade",
            "on",
        ),
        has("cafe tables", "cafe tables"),
        has("parasols", "parasols"),
        PredicateSpec(
            "spatial_relation", "cafe next to the kiosk", "stand next to a green kiosk", "cafe tables", "kiosk", "near"
        ),
        PredicateSpec("attribute", "kiosk is green", "green kiosk", "kiosk", qualifiers=(("color", "green"),)),
        has("tall yellow crane", "crane"),
        PredicateSpec("attribute", "crane is yellow", "yellow crane", "crane", qualifiers=(("color", "yellow"),)),
        has("stacked shipping containers", "containers"),
        PredicateSpec(
            "spatial_relation",
            "containers at the working end",
            "mark the working end of the quay",
            "containers",
            "quay",
            "near",
        ),
        PredicateSpec(
            "spatial_relation", "crane beside the warehouse", "beside a brick warehouse", "crane", "warehouse", "beside"
        ),
        PredicateSpec(
            "material", "warehouse of brick", "brick warehouse", "warehouse", qualifiers=(("material", "brick"),)
        ),
        PredicateSpec(
            "quantity",
            "several fishing boats",
            "Several fishing boats",
            "fishing boats",
            quantity=Quantity("qualitative", qualitative="several"),
        ),
        has("sailing boats", "sailing boats"),
        PredicateSpec("spatial_relation", "boats on the water", "float on the water", "fishing boats", "water", "on"),
        PredicateSpec("spatial_relation", "boats along the quay", "along the quay", "fishing boats", "quay", "along"),
        PredicateSpec(
            "spatial_relation",
            "jetty between the boats",
            "a wooden jetty reaches out between them",
            "jetty",
            "fishing boats",
            "between",
            references=("sailing boats",),
        ),
        PredicateSpec("material", "jetty of wood", "wooden jetty", "jetty", qualifiers=(("material", "wooden"),)),
        PredicateSpec(
            "quantity", "one lighthouse", "A red and white lighthouse", "lighthouse", quantity=Quantity("exact", 1)
        ),
        PredicateSpec(
            "attribute",
            "lighthouse is red and white",
            "red and white",
            "lighthouse",
            qualifiers=(("color", "red"), ("color", "white")),
        ),
        PredicateSpec(
            "spatial_relation",
            "lighthouse on the mole",
            "stands at the far end of a stone mole",
            "lighthouse",
            "mole",
            "on",
        ),
        has("street lamps", "street lamps"),
        has("benches", "benches"),
        PredicateSpec(
            "spatial_relation",
            "lamps along the promenade",
            "street lamps and benches along the promenade",
            "street lamps",
            "promenade",
            "along",
        ),
        has("leafy trees", "trees"),
        PredicateSpec(
            "spatial_relation",
            "trees between the lamps",
            "leafy trees between the lamps",
            "trees",
            "street lamps",
            "between",
        ),
        PredicateSpec(
            "distribution",
            "bollards at regular intervals",
            "iron bollards at regular intervals",
            "bollards",
            relation="regular",
            qualifiers=(("layout", "regular intervals"),),
        ),
        PredicateSpec("spatial_relation", "bollards along the edge", "along the edge", "bollards", "quay", "along"),
        PredicateSpec(
            "quantity", "a few cars", "a few parked cars", "cars", quantity=Quantity("qualitative", qualitative="few")
        ),
        PredicateSpec("spatial_relation", "cars on the road", "on the road", "cars", "road", "on"),
        has("barrels", "barrels"),
        has("crates", "crates"),
        has("nets", "nets"),
        PredicateSpec(
            "composition",
            "dense quayside, open road",
            "Keep the quayside dense with barrels, crates and nets, but leave the road itself open",
            "harbour street",
            qualifiers=(("density", "dense"), ("layout", "open")),
        ),
    )
    ground = [HARBOUR[name] for name in ("CobbleTile", "PavingTile", "RoadTile")]
    return TextCase(
        "text-harbour-street",
        harbour_scene.SCENE_ID,
        "Harbour street",
        HARBOUR_TEXT,
        RequirementSpec(entities, predicates),
        200.0,
        "hard",
        ground=ground,
        minimum_actors=20,
    )


FARM_TEXT = (
    "Build a small sunny farm seen in late summer. At its heart lies a yard of trodden earth with a round stone "
    "well in the middle. A white two-storey farmhouse with a red tiled roof stands on the north side of the yard "
    "and a large red barn on the east side. Two steel silos and a stone windmill rise behind the barn. A gravel "
    "track passes south of the yard from west to east. West of the farmhouse lie ploughed fields with long straight "
    "rows of corn, cabbages and pumpkins and patches of golden wheat, watched over by a scarecrow. South of the "
    "track a wooden fence encloses a green pasture with four cows, several sheep and two horses around a wooden "
    "water trough. A regular grid of apple trees forms an orchard to the east of the pasture, and a pond with "
    "boulders and bushes on its bank lies between them. Park a red tractor in the yard and a hay cart on the track, "
    "put pigs in a fenced pen, and let white hens pick around a chicken coop. Stack hay bales near the tool shed "
    "and line the northern edge with tall poplars. The yard should look busy and the fields orderly."
)


def farm_text() -> TextCase:
    """The farm as a text."""
    entities = (
        EntitySpec("farm", "small sunny farm", ("farm", "farmstead"), "region"),
        EntitySpec("yard", "yard of trodden earth", ("earth ground", "courtyard"), "surface", True),
        EntitySpec("well", "stone well", ("well",)),
        EntitySpec("farmhouse", "farmhouse", ("farmhouse", "house")),
        EntitySpec("barn", "red barn", ("barn",)),
        EntitySpec("silos", "steel silos", ("silo",), collection=True),
        EntitySpec("windmill", "stone windmill", ("windmill", "mill")),
        EntitySpec("track", "gravel track", ("gravel path", "path"), "surface", True),
        EntitySpec("fields", "ploughed fields", ("field tile", "soil"), "surface", True),
        EntitySpec("corn", "corn", ("corn row", "maize"), collection=True),
        EntitySpec("cabbages", "cabbages", ("cabbage row", "cabbage"), collection=True),
        EntitySpec("pumpkins", "pumpkins", ("pumpkin row", "pumpkin"), collection=True),
        EntitySpec("wheat", "golden wheat", ("wheat patch", "grain"), collection=True),
        EntitySpec("scarecrow", "scarecrow", ("scarecrow",)),
        EntitySpec("fence", "wooden fence", ("wood fence", "fence"), collection=True),
        EntitySpec("pasture", "green pasture", ("grass tile", "meadow"), "surface", True),
        EntitySpec("cows", "cows", ("cow", "cattle"), collection=True),
        EntitySpec("sheep", "sheep", ("sheep",), collection=True),
        EntitySpec("horses", "horses", ("horse",), collection=True),
        EntitySpec("trough", "wooden water trough", ("water trough", "trough")),
        EntitySpec("apple trees", "apple trees", ("apple tree", "fruit tree"), collection=True),
        EntitySpec("pond", "pond", ("pond tile",)),
        EntitySpec("boulders", "boulders", ("boulder", "rock"), collection=True),
        EntitySpec("bushes", "bushes", ("bush", "shrub"), collection=True),
        EntitySpec("red tractor", "red tractor"),
        EntitySpec("hay cart", "hay cart", ("hay cart", "cart")),
        EntitySpec("pigs", "pigs", ("pig",), collection=True),
        EntitySpec("hens", "white hens", ("hen", "chicken"), collection=True),
        EntitySpec("coop", "chicken coop", ("chicken coop", "hen house")),
        EntitySpec("hay bales", "hay bales", ("hay bale", "bale"), collection=True),
        EntitySpec("shed", "tool shed", ("tool shed", "shed")),
        EntitySpec("poplars", "tall poplars", ("poplar",), collection=True),
    )
    has = _existence
    predicates = (
        PredicateSpec("scene_identity", "scene is a small farm", "small sunny farm", "farm"),
        PredicateSpec(
            "environment",
            "late summer sun",
            "sunny farm seen in late summer",
            "farm",
            qualifiers=(("lighting", "sunny"), ("atmosphere", "late summer")),
        ),
        PredicateSpec(
            "spatial_relation",
            "yard at the heart of the farm",
            "At its heart lies a yard of trodden earth",
            "yard",
            "farm",
            "in",
        ),
        PredicateSpec("quantity", "one well", "a round stone well", "well", quantity=Quantity("exact", 1)),
        PredicateSpec("material", "well of stone", "stone well", "well", qualifiers=(("material", "stone"),)),
        PredicateSpec("spatial_relation", "well in the middle of the yard", "in the middle", "well", "yard", "in"),
        has("white two-storey farmhouse", "farmhouse"),
        PredicateSpec(
            "attribute",
            "farmhouse is white",
            "white two-storey farmhouse",
            "farmhouse",
            qualifiers=(("color", "white"),),
        ),
        PredicateSpec(
            "material",
            "farmhouse roof is tiled",
            "red tiled roof",
            "farmhouse",
            qualifiers=(("color", "red"), ("material", "tiled")),
        ),
        PredicateSpec(
            "spatial_relation",
            "farmhouse north of the yard",
            "stands on the north side of the yard",
            "farmhouse",
            "yard",
            "north_of",
        ),
        has("large red barn", "barn"),
        PredicateSpec("attribute", "barn is red", "red barn", "barn", qualifiers=(("color", "red"),)),
        PredicateSpec(
            "spatial_relation", "barn east of the yard", "red barn on the east side", "barn", "yard", "east_of"
        ),
        PredicateSpec("quantity", "two silos", "Two steel silos", "silos", quantity=Quantity("exact", 2)),
        PredicateSpec("material", "silos of steel", "steel silos", "silos", qualifiers=(("material", "steel"),)),
        has("stone windmill", "windmill"),
        PredicateSpec(
            "spatial_relation", "silos and windmill behind the barn", "rise behind the barn", "silos", "barn", "behind"
        ),
        has("gravel track", "track"),
        PredicateSpec(
            "spatial_relation",
            "track south of the yard",
            "passes south of the yard from west to east",
            "track",
            "yard",
            "south_of",
        ),
        has("ploughed fields", "fields"),
        PredicateSpec(
            "spatial_relation",
            "fields west of the farmhouse",
            "West of the farmhouse lie ploughed fields",
            "fields",
            "farmhouse",
            "west_of",
        ),
        PredicateSpec(
            "distribution",
            "crops in straight rows",
            "long straight rows of corn, cabbages and pumpkins",
            "corn",
            relation="in_rows",
            qualifiers=(("layout", "straight rows"),),
        ),
        has("corn", "corn"),
        has("cabbages", "cabbages"),
        has("pumpkins", "pumpkins"),
        has("patches of golden wheat", "wheat"),
        PredicateSpec("attribute", "wheat is golden", "golden wheat", "wheat", qualifiers=(("color", "golden"),)),
        PredicateSpec(
            "spatial_relation", "scarecrow at the fields", "watched over by a scarecrow", "scarecrow", "fields", "near"
        ),
        PredicateSpec(
            "spatial_relation",
            "fence south of the track",
            "South of the track a wooden fence",
            "fence",
            "track",
            "south_of",
        ),
        PredicateSpec(
            "spatial_relation",
            "fence encloses the pasture",
            "a wooden fence encloses a green pasture",
            "fence",
            "pasture",
            "encloses",
        ),
        PredicateSpec("attribute", "pasture is green", "green pasture", "pasture", qualifiers=(("color", "green"),)),
        PredicateSpec("quantity", "four cows", "four cows", "cows", quantity=Quantity("exact", 4)),
        PredicateSpec(
            "quantity",
            "several sheep",
            "several sheep",
            "sheep",
            quantity=Quantity("qualitative", qualitative="several"),
        ),
        PredicateSpec("quantity", "two horses", "two horses", "horses", quantity=Quantity("exact", 2)),
        PredicateSpec(
            "spatial_relation", "animals around the trough", "around a wooden water trough", "sheep", "trough", "around"
        ),
        has("apple trees", "apple trees"),
        PredicateSpec(
            "distribution",
            "orchard is a grid",
            "A regular grid of apple trees",
            "apple trees",
            relation="grid",
            qualifiers=(("layout", "regular grid"),),
        ),
        PredicateSpec(
            "spatial_relation",
            "orchard east of the pasture",
            "forms an orchard to the east of the pasture",
            "apple trees",
            "pasture",
            "east_of",
        ),
        PredicateSpec(
            "spatial_relation",
            "pond between pasture and orchard",
            "a pond with boulders and bushes on its bank lies between them",
            "pond",
            "pasture",
            "between",
            references=("apple trees",),
        ),
        PredicateSpec(
            "spatial_relation", "boulders at the pond", "boulders and bushes on its bank", "boulders", "pond", "near"
        ),
        PredicateSpec(
            "spatial_relation", "bushes at the pond", "boulders and bushes on its bank", "bushes", "pond", "near"
        ),
        PredicateSpec("attribute", "tractor is red", "red tractor", "red tractor", qualifiers=(("color", "red"),)),
        PredicateSpec(
            "spatial_relation", "tractor in the yard", "Park a red tractor in the yard", "red tractor", "yard", "in"
        ),
        PredicateSpec("spatial_relation", "cart on the track", "a hay cart on the track", "hay cart", "track", "on"),
        PredicateSpec("spatial_relation", "pigs in a fenced pen", "pigs in a fenced pen", "pigs", "fence", "inside"),
        has("white hens", "hens"),
        PredicateSpec(
            "spatial_relation",
            "hens around the coop",
            "white hens pick around a chicken coop",
            "hens",
            "coop",
            "around",
        ),
        PredicateSpec(
            "spatial_relation",
            "hay bales near the shed",
            "Stack hay bales near the tool shed",
            "hay bales",
            "shed",
            "near",
        ),
        PredicateSpec(
            "distribution",
            "poplars line the northern edge",
            "line the northern edge with tall poplars",
            "poplars",
            relation="in_line",
            qualifiers=(("layout", "line"),),
        ),
        PredicateSpec(
            "composition",
            "busy yard, orderly fields",
            "The yard should look busy and the fields orderly",
            "farm",
            qualifiers=(("density", "busy"), ("layout", "orderly")),
        ),
    )
    ground = [FARM[name] for name in ("GrassTile", "GravelPath", "FieldTile")]
    return TextCase(
        "text-small-farm",
        farm_scene.SCENE_ID,
        "Small farm",
        FARM_TEXT,
        RequirementSpec(entities, predicates),
        130.0,
        "medium",
        ground=ground,
        minimum_actors=20,
    )


def _existence(words: str, subject: str) -> PredicateSpec:
    return PredicateSpec("existence", f"there is {words}", words, subject)
