"""Word lists of plain English that the agent ``planner`` reads prompts with. None is about a case."""

from __future__ import annotations

from typing import Final

COLOURS: Final = frozenset(
    {
        "red", "blue", "green", "yellow", "orange", "purple", "violet", "pink", "brown", "black", "white", "grey",
        "gray", "cream", "beige", "ochre", "teal", "turquoise", "gold", "golden", "silver", "mustard", "rust", "dark",
        "light", "pale", "bright", "brick",
    }
)  # fmt: skip
SIZES: Final[dict[str, int]] = {
    **dict.fromkeys(["tall", "large", "long", "big", "wide", "broad", "huge", "massive", "great"], 1),
    **dict.fromkeys(["low", "small", "short", "little", "tiny", "narrow", "slim", "compact"], -1),
}
"""Adjectives that choose among assets by size: 1 the larger, -1 the smaller."""
MEASURES: Final = frozenset(
    {
        "tile", "row", "patch", "pile", "plank", "stack", "coil", "set", "ground", "path", "group", "cluster",
        "piece", "block", "grid", "line", "ring", "circle", "heap", "module", "panel", "post", "segment", "section",
        "clump", "bundle", "type",
    }
)  # fmt: skip
"""Words that say how much or in what form: ``corn row`` is corn, ``water tile`` is water."""
NUMBERS: Final[dict[str, int]] = {
    "one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7, "eight": 8, "nine": 9, "ten": 10,
    "eleven": 11, "twelve": 12,
    "a": 1, "an": 1, "single": 1, "pair": 2, "couple": 2, "both": 2, "dozen": 12, "fifteen": 15, "sixteen": 16,
    "eighteen": 18, "twenty": 20, "thirty": 30, "forty": 40, "fifty": 50, "sixty": 60, "eighty": 80, "hundred": 100,
    "few": 3, "several": 4, "some": 3, "many": 8, "numerous": 8, "multiple": 4,
}  # fmt: skip
EACH: Final = frozenset({"every", "each", "most"})
NEGATIONS: Final = frozenset({"no", "without"})
"""What is said behind one of these, up to a word that ends its list, is not to be there."""
BUILDING_WORDS: Final = frozenset(
    {
        "residential", "apartment", "urban", "housing", "office", "city", "tower", "highrise", "midrise", "lowrise",
        "storey", "story",
    }
)  # fmt: skip
"""Words before ``block`` or ``slab`` that say that it is a building."""
ADJECTIVES: Final = frozenset({"square"})
"""Nouns of places that are adjectives before anything but the end of their phrase."""
PLACES: Final = frozenset(
    {
        "yard", "courtyard", "court", "plaza", "square", "garden", "pasture", "meadow", "pen", "paddock", "enclosure",
        "orchard", "field", "hall", "kitchen", "bedroom", "bathroom", "lounge", "lobby", "corridor", "room", "market",
        "camp", "park", "forest", "grove", "terrace", "quayside", "shore", "beach", "island", "lawn",
    }
)  # fmt: skip
"""Nouns of places that hold things and need no asset of their own."""
INDOORS: Final = frozenset(
    {
        "room", "flat", "apartment", "office", "ceiling", "indoor", "interior", "bedroom", "bathroom", "kitchen",
        "hall", "lounge",
    }
)  # fmt: skip
PEOPLE: Final = frozenset(
    {
        "visitor", "customer", "guest", "shopper", "worker", "person", "people", "child", "passenger",
    }
)  # fmt: skip
STRIPS: Final = frozenset(
    {
        "road", "street", "track", "path", "lane", "promenade", "pavement", "sidewalk", "quay", "river", "canal",
        "stream", "avenue", "embankment", "water",
    }
)  # fmt: skip
"""Long things that run through the whole scene, and lanes of others on them."""
SYNONYMS: Final[dict[str, tuple[str, ...]]] = {
    "copier": ("printer",), "sofa": ("couch",), "couch": ("sofa",), "tv": ("television",), "lantern": ("lamp",),
    "promenade": ("cobble", "paving", "pavement", "walkway"), "pavement": ("paving", "sidewalk"),
    "sidewalk": ("pavement", "paving"), "road": ("asphalt", "street"), "street": ("road", "asphalt"),
    "lane": ("path", "road"), "track": ("path", "trail", "dirt", "gravel"), "canal": ("water", "river"),
    "river": ("water", "stream"), "stream": ("water", "river"), "sea": ("water",), "pond": ("water",),
    "pool": ("water",), "lake": ("water",), "quay": ("dock", "pier"), "jetty": ("pier", "dock"),
    "pier": ("jetty", "dock"), "building": ("house", "home", "townhouse"),
    "house": ("home", "building", "townhouse"), "tower": ("skyscraper",), "vehicle": ("car",),
    "footbridge": ("bridge",), "basin": ("sink",), "rock": ("boulder", "stone"), "awning": ("canopy", "cover"),
    "whiteboard": ("board",), "skyscraper": ("tower", "house"), "block": ("house", "building"),
    "townhouse": ("building", "house"), "cottage": ("house", "hut", "cabin"), "boulder": ("rock", "stone"),
    "outcrop": ("rock", "cliff"), "cliff": ("rock",), "shrub": ("bush", "hedge"), "cart": ("wagon", "waggon"),
    "wagon": ("waggon", "cart"), "shed": ("cabin", "hut", "outhouse"), "stall": ("stand", "booth", "kiosk"),
    "storefront": ("shop", "showcase"), "walkway": ("paving", "pavement", "floor", "path"),
    "platform": ("floor", "deck"), "parapet": ("railing", "balustrade"), "railing": ("fence", "balustrade"),
    "lamp": ("lantern", "light"), "bollard": ("post", "pillar"), "watchtower": ("tower",), "gatehouse": ("gate",),
    "minaret": ("tower",), "hay": ("haystack",), "crop": ("wheat", "corn"), "signboard": ("sign",),
    "sign": ("signboard",), "column": ("pillar",), "stair": ("stairs", "staircase"),
    "stairway": ("stairs", "stair"), "windmill": ("mill",), "container": ("crate",),
}  # fmt: skip
VERBS: Final = frozenset(
    {
        "stand", "stands", "lie", "lies", "is", "are", "was", "were", "rise", "rises", "float", "floats", "reach",
        "reaches", "mark", "marks", "pass", "passes", "hang", "hangs", "run", "runs", "sit", "sits", "pick", "picks",
        "rest", "rests", "grow", "grows", "look", "looks", "go", "goes", "keep", "come", "comes", "extend", "extends",
        "lead", "leads", "watch", "watched", "shown", "seen", "build", "place", "add", "put", "park", "let", "stack",
        "arrange", "distribute", "feed", "make", "give", "leave", "leaving", "surround", "keeping", "use", "include",
        "finish", "create", "set", "cut", "cuts", "crossed", "divide", "divides",
    }
)  # fmt: skip
STOPS: Final = frozenset(
    {
        "the", "a", "an", "and", "or", "but", "with", "of", "in", "on", "at", "to", "by", "from", "for", "as", "its",
        "it", "them", "they", "this", "that", "these", "those", "there", "here", "which", "who", "then", "also",
        "one", "all", "so", "not", "no", "than", "into", "onto", "out", "over", "under", "between", "beside",
        "behind", "along", "around", "near", "next", "above", "below", "beneath", "within", "inside", "outside",
        "across", "through", "throughout", "towards", "toward", "beyond", "while", "where", "whose", "off", "amid",
        "without",
    }
)  # fmt: skip
RELATIONS: Final[dict[str, str]] = {
    **dict.fromkeys(["on", "on top of", "atop", "upon", "over"], "on"),
    **dict.fromkeys(["near", "next to", "beside", "by", "at", "alongside", "against", "close to", "among"], "near"),
    **dict.fromkeys(["before", "in front of", "under", "at the end of", "at the far end of"], "near"),
    **dict.fromkeys(["on the far side", "at right angles", "from west to east", "from east to west"], ""),
    **dict.fromkeys(["from north to south", "from south to north"], ""),
}
"""Phrases that say that a thing stands ``on`` another or ``near`` it, or that hold such a word and say neither."""
