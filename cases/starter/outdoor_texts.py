"""The two outdoor texts of the starter suite, with their requirements."""

from __future__ import annotations

from cases.model import TextCase
from cases.requirements import Entity, Predicate, Quantity, RequirementSpec
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
        Entity("harbour street", "harbour street", ("harbour", "waterfront", "port"), "region"),
        Entity("quay", "stone quay", ("quay wall", "embankment"), "object", True),
        Entity("water", "blue water", ("water tile", "sea", "harbour basin"), "surface", True),
        Entity("promenade", "cobbled promenade", ("cobble tile", "cobblestone"), "surface", True),
        Entity("road", "asphalt road", ("road tile", "street", "crossing tile"), "surface", True),
        Entity("pavement", "pavement of pale stone", ("paving tile", "sidewalk"), "surface", True),
        Entity("townhouses", "attached townhouses", ("townhouse", "house", "building"), collection=True),
        Entity("canal", "narrow canal", ("water tile", "canal water"), "region"),
        Entity("bridges", "stone bridges", ("bridge", "stone bridge"), collection=True),
        Entity("market stalls", "market stalls", ("stall", "market stall"), collection=True),
        Entity("cafe tables", "cafe tables", ("cafe table", "table"), collection=True),
        Entity("parasols", "parasols", ("parasol", "umbrella"), collection=True),
        Entity("kiosk", "green kiosk", ("kiosk", "hut")),
        Entity("crane", "yellow crane", ("harbour crane", "crane")),
        Entity("containers", "shipping containers", ("cargo container", "container"), collection=True),
        Entity("warehouse", "brick warehouse", ("warehouse",)),
        Entity("fishing boats", "fishing boats", ("fishing boat", "trawler"), collection=True),
        Entity("sailing boats", "sailing boats", ("sailing boat", "yacht"), collection=True),
        Entity("jetty", "wooden jetty", ("jetty planks", "pier"), collection=True),
        Entity("lighthouse", "lighthouse", ("lighthouse",)),
        Entity("street lamps", "street lamps", ("street lamp", "lantern"), collection=True),
        Entity("benches", "benches", ("bench",), collection=True),
        Entity("trees", "leafy trees", ("street tree", "tree"), collection=True),
        Entity("bollards", "iron bollards", ("bollard",), collection=True),
        Entity("cars", "parked cars", ("car", "van", "vehicle"), collection=True),
        Entity("barrels", "barrels", ("barrel",), collection=True),
        Entity("crates", "crates", ("wooden crate", "crate"), collection=True),
        Entity("nets", "nets", ("net pile", "fishing net"), collection=True),
    )
    has = _existence
    predicates = (
        Predicate("scene_identity", "scene is a northern harbour street", "northern harbour street", "harbour street"),
        Predicate(
            "environment", "clear day", "on a clear day", "harbour street", qualifiers=(("lighting", "clear day"),)
        ),
        Predicate(
            "environment",
            "harbour is colourful",
            "colourful",
            "harbour street",
            qualifiers=(("atmosphere", "colourful"),),
        ),
        has("stone quay", "quay"),
        has("calm blue water", "water"),
        has("broad cobbled promenade", "promenade"),
        has("asphalt road", "road"),
        has("pavement of pale stone", "pavement"),
        Predicate(
            "quantity",
            "roughly seventeen townhouses",
            "roughly seventeen attached townhouses",
            "townhouses",
            quantity=Quantity("approximately", 17),
        ),
        Predicate(
            "attribute",
            "townhouses are red and cream",
            "red and cream plaster",
            "townhouses",
            qualifiers=(("color", "red"), ("color", "cream")),
        ),
        Predicate(
            "material",
            "townhouses of plaster and brick",
            "plaster and dark brick",
            "townhouses",
            qualifiers=(("material", "plaster"), ("material", "brick")),
        ),
        Predicate(
            "material",
            "roofs of slate and tile",
            "slate and tiled roofs",
            "townhouses",
            qualifiers=(("material", "slate"), ("material", "tiled")),
        ),
        Predicate(
            "distribution",
            "townhouses form one row",
            "in one continuous row",
            "townhouses",
            relation="in_row",
            qualifiers=(("layout", "row"),),
        ),
        Predicate(
            "spatial_relation",
            "townhouses behind the pavement",
            "Behind the pavement stand roughly seventeen attached townhouses",
            "townhouses",
            "pavement",
            "behind",
        ),
        has("narrow canal", "canal"),
        Predicate("quantity", "two bridges", "two stone bridges", "bridges", quantity=Quantity("exact", 2)),
        Predicate(
            "spatial_relation",
            "bridges cross the canal",
            "is crossed by two stone bridges",
            "bridges",
            "canal",
            "across",
        ),
        Predicate(
            "quantity", "seven market stalls", "seven market stalls", "market stalls", quantity=Quantity("exact", 7)
        ),
        Predicate(
            "attribute",
            "awnings are striped",
            "striped awnings",
            "market stalls",
            qualifiers=(("attribute", "striped"),),
        ),
        Predicate(
            "distribution",
            "stalls in a line",
            "stand in a line facing the water",
            "market stalls",
            relation="in_line",
            qualifiers=(("layout", "line"),),
        ),
        Predicate(
            "spatial_relation",
            "stalls on the promenade",
            "On the promenade seven market stalls",
            "market stalls",
            "promenade",
            "on",
        ),
        has("cafe tables", "cafe tables"),
        has("parasols", "parasols"),
        Predicate(
            "spatial_relation", "cafe next to the kiosk", "next to a green kiosk", "cafe tables", "kiosk", "near"
        ),
        Predicate("attribute", "kiosk is green", "green kiosk", "kiosk", qualifiers=(("color", "green"),)),
        has("tall yellow crane", "crane"),
        Predicate("attribute", "crane is yellow", "yellow crane", "crane", qualifiers=(("color", "yellow"),)),
        has("stacked shipping containers", "containers"),
        Predicate(
            "spatial_relation", "crane beside the warehouse", "beside a brick warehouse", "crane", "warehouse", "beside"
        ),
        Predicate(
            "material", "warehouse of brick", "brick warehouse", "warehouse", qualifiers=(("material", "brick"),)
        ),
        Predicate(
            "quantity",
            "several fishing boats",
            "Several fishing boats",
            "fishing boats",
            quantity=Quantity("qualitative", qualitative="several"),
        ),
        has("sailing boats", "sailing boats"),
        Predicate("spatial_relation", "boats on the water", "float on the water", "fishing boats", "water", "on"),
        Predicate("spatial_relation", "boats along the quay", "along the quay", "fishing boats", "quay", "along"),
        has("wooden jetty", "jetty"),
        Predicate("material", "jetty of wood", "wooden jetty", "jetty", qualifiers=(("material", "wooden"),)),
        Predicate(
            "quantity", "one lighthouse", "A red and white lighthouse", "lighthouse", quantity=Quantity("exact", 1)
        ),
        Predicate(
            "attribute",
            "lighthouse is red and white",
            "red and white",
            "lighthouse",
            qualifiers=(("color", "red"), ("color", "white")),
        ),
        has("street lamps", "street lamps"),
        has("benches", "benches"),
        Predicate(
            "spatial_relation",
            "lamps along the promenade",
            "street lamps and benches along the promenade",
            "street lamps",
            "promenade",
            "along",
        ),
        has("leafy trees", "trees"),
        Predicate(
            "spatial_relation",
            "trees between the lamps",
            "leafy trees between the lamps",
            "trees",
            "street lamps",
            "between",
        ),
        Predicate(
            "distribution",
            "bollards at regular intervals",
            "iron bollards at regular intervals",
            "bollards",
            relation="regular",
            qualifiers=(("layout", "regular intervals"),),
        ),
        Predicate("spatial_relation", "bollards along the edge", "along the edge", "bollards", "quay", "along"),
        Predicate(
            "quantity", "a few cars", "a few parked cars", "cars", quantity=Quantity("qualitative", qualitative="few")
        ),
        Predicate("spatial_relation", "cars on the road", "on the road", "cars", "road", "on"),
        has("barrels", "barrels"),
        has("crates", "crates"),
        has("nets", "nets"),
        Predicate(
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
        Entity("farm", "small sunny farm", ("farm", "farmstead"), "region"),
        Entity("yard", "yard of trodden earth", ("earth ground", "courtyard"), "surface", True),
        Entity("well", "stone well", ("well",)),
        Entity("farmhouse", "farmhouse", ("farmhouse", "house")),
        Entity("barn", "red barn", ("barn",)),
        Entity("silos", "steel silos", ("silo",), collection=True),
        Entity("windmill", "stone windmill", ("windmill", "mill")),
        Entity("track", "gravel track", ("gravel path", "path"), "surface", True),
        Entity("fields", "ploughed fields", ("field tile", "soil"), "surface", True),
        Entity("corn", "corn", ("corn row", "maize"), collection=True),
        Entity("cabbages", "cabbages", ("cabbage row", "cabbage"), collection=True),
        Entity("pumpkins", "pumpkins", ("pumpkin row", "pumpkin"), collection=True),
        Entity("wheat", "golden wheat", ("wheat patch", "grain"), collection=True),
        Entity("scarecrow", "scarecrow", ("scarecrow",)),
        Entity("fence", "wooden fence", ("wood fence", "fence"), collection=True),
        Entity("pasture", "green pasture", ("grass tile", "meadow"), "surface", True),
        Entity("cows", "cows", ("cow", "cattle"), collection=True),
        Entity("sheep", "sheep", ("sheep",), collection=True),
        Entity("horses", "horses", ("horse",), collection=True),
        Entity("trough", "wooden water trough", ("water trough", "trough")),
        Entity("apple trees", "apple trees", ("apple tree", "fruit tree"), collection=True),
        Entity("pond", "pond", ("pond tile",)),
        Entity("boulders", "boulders", ("boulder", "rock"), collection=True),
        Entity("bushes", "bushes", ("bush", "shrub"), collection=True),
        Entity("tractor", "red tractor", ("tractor red", "tractor")),
        Entity("hay cart", "hay cart", ("hay cart", "cart")),
        Entity("pigs", "pigs", ("pig",), collection=True),
        Entity("hens", "white hens", ("hen", "chicken"), collection=True),
        Entity("coop", "chicken coop", ("chicken coop", "hen house")),
        Entity("hay bales", "hay bales", ("hay bale", "bale"), collection=True),
        Entity("shed", "tool shed", ("tool shed", "shed")),
        Entity("poplars", "tall poplars", ("poplar",), collection=True),
    )
    has = _existence
    predicates = (
        Predicate("scene_identity", "scene is a small farm", "small sunny farm", "farm"),
        Predicate(
            "environment",
            "late summer sun",
            "sunny farm seen in late summer",
            "farm",
            qualifiers=(("lighting", "sunny"), ("atmosphere", "late summer")),
        ),
        has("yard of trodden earth", "yard"),
        Predicate("quantity", "one well", "a round stone well", "well", quantity=Quantity("exact", 1)),
        Predicate("material", "well of stone", "stone well", "well", qualifiers=(("material", "stone"),)),
        Predicate("spatial_relation", "well in the middle of the yard", "in the middle", "well", "yard", "in"),
        has("white two-storey farmhouse", "farmhouse"),
        Predicate(
            "attribute",
            "farmhouse is white",
            "white two-storey farmhouse",
            "farmhouse",
            qualifiers=(("color", "white"),),
        ),
        Predicate(
            "material",
            "farmhouse roof is tiled",
            "red tiled roof",
            "farmhouse",
            qualifiers=(("color", "red"), ("material", "tiled")),
        ),
        Predicate(
            "spatial_relation",
            "farmhouse north of the yard",
            "on the north side of the yard",
            "farmhouse",
            "yard",
            "north_of",
        ),
        has("large red barn", "barn"),
        Predicate("attribute", "barn is red", "red barn", "barn", qualifiers=(("color", "red"),)),
        Predicate("spatial_relation", "barn east of the yard", "red barn on the east side", "barn", "yard", "east_of"),
        Predicate("quantity", "two silos", "Two steel silos", "silos", quantity=Quantity("exact", 2)),
        Predicate("material", "silos of steel", "steel silos", "silos", qualifiers=(("material", "steel"),)),
        has("stone windmill", "windmill"),
        Predicate(
            "spatial_relation", "silos and windmill behind the barn", "rise behind the barn", "silos", "barn", "behind"
        ),
        has("gravel track", "track"),
        Predicate(
            "spatial_relation", "track south of the yard", "passes south of the yard", "track", "yard", "south_of"
        ),
        has("ploughed fields", "fields"),
        Predicate(
            "spatial_relation",
            "fields west of the farmhouse",
            "West of the farmhouse lie ploughed fields",
            "fields",
            "farmhouse",
            "west_of",
        ),
        Predicate(
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
        Predicate("attribute", "wheat is golden", "golden wheat", "wheat", qualifiers=(("color", "golden"),)),
        has("scarecrow", "scarecrow"),
        Predicate(
            "spatial_relation",
            "fence encloses the pasture",
            "a wooden fence encloses a green pasture",
            "fence",
            "pasture",
            "encloses",
        ),
        Predicate("attribute", "pasture is green", "green pasture", "pasture", qualifiers=(("color", "green"),)),
        Predicate("quantity", "four cows", "four cows", "cows", quantity=Quantity("exact", 4)),
        Predicate(
            "quantity",
            "several sheep",
            "several sheep",
            "sheep",
            quantity=Quantity("qualitative", qualitative="several"),
        ),
        Predicate("quantity", "two horses", "two horses", "horses", quantity=Quantity("exact", 2)),
        Predicate(
            "spatial_relation", "animals around the trough", "around a wooden water trough", "sheep", "trough", "around"
        ),
        has("apple trees", "apple trees"),
        Predicate(
            "distribution",
            "orchard is a grid",
            "A regular grid of apple trees",
            "apple trees",
            relation="grid",
            qualifiers=(("layout", "regular grid"),),
        ),
        Predicate(
            "spatial_relation",
            "orchard east of the pasture",
            "to the east of the pasture",
            "apple trees",
            "pasture",
            "east_of",
        ),
        has("pond", "pond"),
        Predicate(
            "spatial_relation",
            "boulders at the pond",
            "a pond with boulders and bushes on its bank",
            "boulders",
            "pond",
            "near",
        ),
        Predicate("attribute", "tractor is red", "red tractor", "tractor", qualifiers=(("color", "red"),)),
        Predicate("spatial_relation", "tractor in the yard", "a red tractor in the yard", "tractor", "yard", "in"),
        Predicate("spatial_relation", "cart on the track", "a hay cart on the track", "hay cart", "track", "on"),
        Predicate("spatial_relation", "pigs in a fenced pen", "pigs in a fenced pen", "pigs", "fence", "inside"),
        has("white hens", "hens"),
        Predicate(
            "spatial_relation",
            "hens around the coop",
            "white hens pick around a chicken coop",
            "hens",
            "coop",
            "around",
        ),
        Predicate(
            "spatial_relation",
            "hay bales near the shed",
            "Stack hay bales near the tool shed",
            "hay bales",
            "shed",
            "near",
        ),
        Predicate(
            "distribution",
            "poplars line the northern edge",
            "line the northern edge with tall poplars",
            "poplars",
            relation="in_line",
            qualifiers=(("layout", "line"),),
        ),
        Predicate(
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


def _existence(words: str, subject: str) -> Predicate:
    return Predicate("existence", f"there is {words}", words, subject)
