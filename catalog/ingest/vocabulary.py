"""Words of file names as people read and search them: compounds taken apart, kinds of things, other words for them."""

from __future__ import annotations

import re
from itertools import pairwise

from catalog.ingest.units import words

GROUPS: dict[str, str] = {
    "furniture": "chair armchair stool couch sofa bed desk table cabinet shelf bookcase wardrobe dresser drawer "
    "nightstand bench counter rug carpet pillow cushion mattress ottoman curtain mirror",
    "lighting": "lamp light lantern streetlight chandelier candle torch bulb",
    "vehicle": "car truck bus van taxi bike bicycle motorcycle boat ship train tractor forklift plane hatchback sedan "
    "stationwagon police",
    "plant": "tree bush plant flower grass cactus hedge fern palm pine log stump mushroom crop shrub",
    "building": "building house tower watertower shed barn garage skyscraper hut cabin church shop store warehouse",
    "road": "road street pavement sidewalk crossing junction bridge rail track path",
    "structure": "wall floor ceiling roof door doorway window pillar column beam stairs ramp slope ladder fence gate "
    "railing arch platform block tile border stage",
    "food": "food apple bread burger cheese carrot egg ham lettuce meat onion pickle potato steak tomato stew cake "
    "pizza fruit vegetable soup sauce icecream dinner",
    "kitchenware": "plate bowl pot pan mug cup glass knife fork spoon lid dishrack cuttingboard kettle jar bottle can "
    "ketchup mustard papertowel",
    "appliance": "fridge refrigerator oven stove extractorhood sink dishwasher microwave toaster washer television tv "
    "monitor computer laptop keyboard printer speaker",
    "container": "box crate barrel pallet bucket basket bag chest trash dumpster bin container shelf sack",
    "sign": "sign trafficlight signpost banner flag poster board",
    "street furniture": "bench firehydrant hydrant mailbox bollard cone parkingmeter",
    "decoration": "pictureframe picture painting vase statue trophy clock book ornament menu",
    "weapon": "weapon sword spear axe shield bow dagger gun arrow saw spikes trap",
    "pickup": "coin gem key heart star jewel crystal",
    "bathroom": "toilet bathtub shower washbasin towel",
    "person": "character person human man woman child dummy soldier avatar",
    "rock": "rock stone boulder cliff",
}
"""Kinds of things by the words that name them; the first kind that has a word counts."""

OTHER_WORDS: dict[str, tuple[str, ...]] = {
    "couch": ("sofa",),
    "sofa": ("couch",),
    "fridge": ("refrigerator",),
    "trash": ("garbage", "rubbish", "waste"),
    "dumpster": ("trash", "container"),
    "tv": ("television",),
    "streetlight": ("street lamp", "lamp post"),
    "trafficlight": ("traffic signal",),
    "rug": ("carpet",),
    "carpet": ("rug",),
    "car": ("automobile",),
    "hatchback": ("car",),
    "stationwagon": ("car", "estate"),
    "bush": ("shrub",),
    "stairs": ("steps", "staircase"),
    "shelf": ("rack",),
    "pillow": ("cushion",),
    "lamp": ("light",),
    "stove": ("cooker",),
    "crate": ("box",),
    "firehydrant": ("hydrant",),
    "pictureframe": ("picture", "painting"),
    "log": ("timber",),
    "bin": ("trash can",),
    "wardrobe": ("closet",),
    "pan": ("frying pan",),
    "extractorhood": ("range hood",),
    "monitor": ("screen",),
    "stool": ("seat",),
    "chair": ("seat",),
    "armchair": ("easy chair",),
    "house": ("home",),
    "rock": ("stone",),
}
WHOLE = {
    "armchair",
    "bookcase",
    "wardrobe",
    "nightstand",
    "cupboard",
    "doorway",
    "sidewalk",
    "television",
    "lighthouse",
    "warehouse",
    "skyscraper",
    "keyboard",
    "mailbox",
    "bathtub",
    "washbasin",
    "dishwasher",
    "hatchback",
    "forklift",
    "motorcycle",
    "mushroom",
    "microwave",
    "signpost",
    "carpet",
    "cabin",
    "window",
    "bathroom",
    "bedroom",
    "ketchup",
    "platform",
    "pavement",
    "corner",
    "pickle",
    "icecream",
}
"""Words that look put together and are one."""
SECOND = (
    "light",
    "lights",
    "hydrant",
    "tower",
    "frame",
    "counter",
    "table",
    "cabinet",
    "rack",
    "board",
    "wagon",
    "base",
    "hood",
    "towel",
    "cream",
    "corner",
    "chair",
    "lamp",
    "box",
    "shelf",
    "sign",
    "door",
    "wall",
    "tree",
    "house",
    "meter",
    "parking",
    "fence",
    "pot",
    "straight",
    "large",
    "small",
    "half",
    "long",
    "stop",
    "crossing",
    "split",
    "tile",
    "way",
    "post",
    "bin",
    "can",
    "basket",
    "bed",
    "desk",
    "lid",
    "handle",
    "bag",
    "book",
    "bench",
)
FIRST = (
    "street",
    "traffic",
    "fire",
    "water",
    "picture",
    "kitchen",
    "dish",
    "cutting",
    "station",
    "without",
    "with",
    "extractor",
    "paper",
    "ice",
    "inner",
    "outer",
    "parking",
    "no",
    "book",
    "office",
    "coffee",
    "dining",
    "side",
    "night",
    "floor",
    "table",
    "wall",
    "desk",
    "bath",
    "shower",
    "road",
    "t",
    "one",
    "two",
    "three",
    "trash",
    "bed",
    "bus",
    "mail",
    "garden",
    "park",
    "flower",
    "plant",
    "tree",
    "computer",
    "cooking",
    "door",
    "window",
)
HEADS = {"lamp", "light", "chair", "sign"}
_KIND = {word: kind for kind, row in reversed(GROUPS.items()) for word in row.split()}


def spoken(name: str) -> list[str]:
    """A file name as the words that a person would say, numbers and single letters among them.

    ``kitchencounter_straight_A`` as ``kitchen counter straight A``, ``Street_3Way`` as ``street 3 way``.
    """
    split = re.sub(r"(?<=[^\W\d_])(?=\d)|(?<=\d)(?=[^\W\d_])|(?<=[a-z])(?=[A-Z])", " ", re.sub(r"[\W_]+", " ", name))
    found: list[str] = []
    for word in split.split():
        if len(word) == 1 and word.isalpha():
            found.append(word.upper())
        else:
            found += _apart(word.lower())
    return found


def _apart(word: str) -> list[str]:
    if word in WHOLE or len(word) < 6:
        return [word]
    for first in FIRST:
        rest = word.removeprefix(first)
        if rest != word and rest in SECOND:
            return [first, rest]
    return [word]


def readable(name: str) -> str:
    """A file name as a name for people: ``Kitchen counter straight A``; the name itself when it has no words."""
    text = " ".join(spoken(name))
    return text[:1].upper() + text[1:] if text else name


def kind_of(name: str) -> str | None:
    """The kind of thing that a name tells (``furniture``); ``None`` when it has no word of a kind.

    Names of assets put the thing first (``crate_tomatoes``), but for the words of ``HEADS`` (``table_lamp``).
    """
    said = [word.lower() for word in spoken(name)]
    joined = ["".join(pair) for pair in pairwise(said)]
    telling = [word for word in [*joined, *words(name), *said] if _form(word)]
    ordered = sorted(telling, key=lambda word: (word not in joined, _form(word) not in HEADS))
    return _KIND[_form(ordered[0])] if ordered else None


def is_compound(pair: list[str]) -> bool:
    """Whether two words are one thing: traffic light."""
    return len(pair) == 2 and bool(_form("".join(pair).lower()))


def _form(word: str) -> str:
    """A word, or its singular, that tells a kind; nothing for one that does not."""
    return next((form for form in (word, word.removesuffix("s"), word.removesuffix("es")) if form in _KIND), "")


def search_words(name: str) -> list[str]:
    """Tags of a name: its words, the kind of thing, and other words for it."""
    plain = [*(word.lower() for word in spoken(name) if len(word) > 1 and not word.isdigit()), *words(name)]
    kind = kind_of(name)
    other = [
        more for word in words(name) for more in OTHER_WORDS.get(word, OTHER_WORDS.get(word.removesuffix("s"), ()))
    ]
    return [word for word in dict.fromkeys([*plain, *([kind] if kind else []), *other]) if len(word) > 1]
