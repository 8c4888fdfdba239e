"""Words that say how a thing is and not what it is, and words whose things are kin."""

from __future__ import annotations

from c4s.protocol.words import VARIANTS, word_set
from c4s.semantics.looks import COLORS, MATERIAL_WORDS

COLOR_WORDS = COLORS | word_set("""
    cream ochre teal mustard rust navy turquoise cyan magenta tan maroon crimson golden silver gold sage olive amber
    bronze ivory coral indigo dark light pale bright vivid deep""")
_PARTS = word_set(
    "stone rock glass pane log plank brick masonry carpet cloth canvas paper cardboard clay rubber flagstone"
)
"""Materials whose word is a thing too: a ``Field Stone`` is a stone, a ``Wine Glass`` a glass."""
MATERIALS = frozenset().union(*MATERIAL_WORDS.values()) | word_set("earth dirt straw hay gravel iron gold")
_NAMED_LAST = word_set("hay straw gravel gold silver earth dirt")
POSTPOSED = (VARIANTS | COLORS | (MATERIALS - _PARTS)) - _NAMED_LAST | word_set("""
    type variant var version half angle angled pattern patterned rounded tall lower upper outer inner end middle
    long short round damaged destroyed intact empty full merged static""")
"""Words that stand behind a noun in names of assets and only tell a variant of it: ``Window Wood 01a`` is a window."""
DOUBTFUL = (COLOR_WORDS | _PARTS) - POSTPOSED - {"pane", "log", "plank"}
"""As ``POSTPOSED``, where a sibling in the catalog shows it: ``Table Stone`` beside ``Table Wood``."""
NUMBERS = word_set("""
    one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen seventeen eighteen
    nineteen twenty thirty forty fifty sixty eighty hundred dozen several few many some numerous various multiple pair
    couple every each all any roughly about around approximately nearly almost occasional additional other more
    a an the its their this that these those""")
"""Words of number and determiners: they never tell one kind of thing from another."""
VAGUE = word_set("""
    very quite rather extremely particularly slightly comparatively relatively stark dramatic colourful colorful
    beautiful simple typical ornate modest decorative elegant grand impressive massive monumental huge
    featureless ordinary plain surrounding central main nearby scattered regular irregular repeated continuous
    attached detached enclosing inner outer northern southern eastern western north south east west far near""")
"""Adjectives that hardly an asset says of itself; they are no part of what a thing is."""
SHAPES = word_set("""
    small little big large tiny short long wide narrow low high tall thick thin broad flat deep shallow square round
    slender circular rectangular oval cylindrical conical curved straight angular steep gently slim chunky bulky compact
    old new young modern ancient antique vintage worn weathered rusty dirty clean broken intact open closed empty full
    single double triple leafy mossy grassy rocky woolly sunny shady calm plain striped checked chequered tiled paved
    plastered painted weathered ruined rusted aged parked stacked ploughed fenced trodden""")
DESCRIBING = COLOR_WORDS | MATERIALS | SHAPES
"""Words before a noun that describe it: an asset that says them is preferred to one that does not."""
FORMS = word_set("tile plane module segment section piece strip mesh panel")
"""A ``Road Tile`` is a piece of road: as good as its content for a surface or a region."""
COLLECTIVES = word_set("""
    row stack set pile heap cluster group bunch clump patch bundle collection assortment line pair""")
"""A ``Book Stack`` holds books; how many books it is, it does not say."""
GATHERINGS = COLLECTIVES | word_set("ring circle grid array")
"""In prose: ``rows of corn`` are corn."""
PRIVATIVE = word_set("toy model miniature teddy doll dummy fake painted plush replica")
"""Before a noun they make it another thing: a ``Toy Train`` is no train."""
ODD_COMPOUNDS = frozenset(
    tuple(text.split())
    for text in (
        "computer tower", "rocking horse", "clothe horse", "television wall", "hot dog", "ice cream", "computer mouse",
        "saw horse", "hand truck", "chess knight", "bar code", "pommel horse", "hobby horse",
    )
)  # fmt: skip
"""Compounds whose last word alone does not name them."""
SAME = {
    "stairway": "stair",
    "staircase": "stair",
    "refrigerator": "fridge",
    "tv": "television",
    "couch": "sofa",
    "settee": "sofa",
    "bike": "bicycle",
    "waggon": "wagon",
    "lorry": "truck",
    "automobile": "car",
    "drape": "curtain",
    "gray": "grey",
}
"""Words for one and the same thing, each as it is compared."""
RELATED = tuple(
    word_set(line)
    for line in """
    house home building townhouse cottage farmhouse mansion villa residence dwelling tenement block
    hut cabin shack shed kiosk
    tower skyscraper highrise turret watchtower minaret spire campanile
    stall stand booth kiosk cabin shop storefront counter
    stair stairs stairway staircase step ladder flight
    street road lane alley path track trail walkway avenue pavement sidewalk roadway passage
    lamp light lantern lamppost streetlight sconce torch chandelier
    plant palm cactus fern flower
    tree palm oak poplar pine fir conifer birch sapling
    bush shrub hedge plant planter
    plant flower foliage fern ivy weed reed grass
    rock boulder stone pebble cliff outcrop rubble
    car vehicle sedan automobile van truck taxi microbus bus
    boat ship vessel yacht dinghy trawler barge canoe
    bin trash garbage can dumpster wastebasket container
    fence railing rail barrier parapet balustrade
    wall partition rampart parapet
    partition screen divider
    gate door doorway entrance archway arch portal opening shutter hatch
    crate box chest case container carton
    barrel cask keg drum
    sofa couch settee loveseat
    chair seat stool armchair bench
    table desk counter workbench worktop
    cupboard cabinet wardrobe closet locker dresser sideboard
    shelf bookcase bookshelf rack shelving
    rug carpet mat runner
    picture painting poster print frame artwork
    tv television screen monitor display
    fridge refrigerator freezer
    stove oven cooker range hob
    sink basin washbasin washstand
    bathtub bath tub
    floor ground pavement tile terrain plaza
    awning canopy cover parasol umbrella tarp marquee
    sign signboard billboard signage neon
    well fountain trough cistern
    cart wagon waggon wheelbarrow barrow trolley handcart
    field meadow pasture grassland lawn grass
    barn shed stable coop outbuilding hut
    water sea river stream pond lake canal pool basin
    bridge walkway footbridge overpass
    mill windmill watermill
    dome cupola vault
    pillar column post pole pilaster bollard
    platform terrace deck dock pier jetty quay wharf
    pot vase urn jar planter claypot
    basket hamper bowl
    curtain drape blind
    """.strip().splitlines()
)
"""Groups of words whose things could stand for each other; they propose and never name."""
