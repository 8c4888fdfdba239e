"""Prompts of fantasy and toy places."""

from __future__ import annotations

WORDS = {
    "wizard-village": """
    {id|A village of wizards} {atmosphere|hums with quiet magic} {lighting|in warm evening light}.
    {layout|Everything in it turns about one point}: {fountain on cobbles|[a dark stone fountain|Fountain] on [a
    small round of 'cobbles|CobblePavement|cobbles]}. {stalls around fountain; stalls ring|[# stalls|*Stall]
    surround it}, {stalls attribute|hung with violet and blue cloth}, selling [spices|SpiceStall],
    [fruit|FruitStall], [pottery|PotteryStall] and [flowers|FlowerStall]. {lamps around fountain; lamps ring|A wider
    ring of [# lantern lamp_posts|LampPost|lamps] glows behind them}, and {layout|[flagstone
    paths|FlagstonePavement|paths] run out like the spokes of a wheel}.

    {houses around fountain|Two rings of houses follow, [# 'in all|/house|houses]}, some {houses attribute|crooked
    and steep-roofed}. {towers apart fountain|Among the outer ones rise [# slender towers|/tower|towers]}, [#
    bell_towers|BellTower] and [# spire_towers|SpireTower]. {barrels near stalls|[Barrels|Barrel]}, [oak
    wine_casks|WineCask|casks], [pine chests|Chest], [a heavy cauldron|Cauldron] and [#
    banner_poles|BannerPole|poles] make {density|the middle busy}.

    {mushrooms scattered|Between and behind the houses sprout [~ giant mushrooms|GiantMushroom]}, {mushrooms
    attribute|taller than a man, in yellow, red, violet and teal}, and {crystals scattered|[~
    crystal_clusters|CrystalCluster|crystals] in violet and blue}. {trees scattered|A loose wood of [~ trees|/tree]
    grows over it all}, {cherries near houses|[~ cherries|CherryTree]}, [~ plums|PlumTree] and [~ birches|BirchTree]
    among the limes, with [~ bushes|Bush], {boulders scattered|[~ boulders|Boulder]} and {ferns
    scattered|[ferns|Ferns], [sunflowers|Sunflowers] and [poppies|Poppies] below}. {trees on grass|The ground is
    [grass|GrassGround]}.
    """,
    "crystal-camp": """
    {atmosphere|Smoky, raw, glittering}: {id|a camp of crystal miners} {tents on ground|on [black
    cinder|CinderGround|ground]}. {logs around cauldron; logs ring|At its heart [# fallen logs|FallenLog] circle [a
    cauldron|Cauldron]}. {tents around cauldron; tents ring|[# striped tents|/tent] form the next ring}, and {poles
    around tents; poles ring|[# banner_poles|BannerPole|poles] the one after}. {crane apart cauldron|To one side
    works [a treadwheel_crane|TreadwheelCrane|crane]}, {keep apart crane|to the other stands [a square keep|Keep]}.
    {hearth apart crane|A smithy has [a forge_hearth|ForgeHearth|hearth], [# heavy anvils|Anvil], [#
    bellows|Bellows] and [a grindstone|Grindstone]}.

    {crystals near boulders|Farther out lie four diggings, rings of [~ boulders|Boulder] and [~
    great_boulders|GreatBoulder|rocks] with [~ crystal_clusters|CrystalCluster|crystals] inside}, {crystals
    color|violet} for the most part. {crates on ground|[Apple_crates|AppleCrate|crates]}, [# handcarts|Handcart],
    [barrels|Barrel] and [trunks|Trunk] wait around each. {mushrooms scattered|[~ giant mushrooms|GiantMushroom] and
    [~ thin 'trees|/tree|trees] are scattered between}. {palisades rows|[Plank palisades|PlankFence|palisades] close
    the camp on two sides}. {density|The middle is cluttered with tools}: [# wheelbarrows|Wheelbarrow],
    [plank_stacks|PlankStack|planks], [ladders|Ladder] and [flour_sacks|FlourSacks|sacks].
    """,
    "elf-river": """
    {id|The elves have built their town along both banks of a river}, and {layout|each bank mirrors the other}.
    {style|White, slender and bright; not one heavy line.}

    {bridges across river|[# limestone foot_bridges|FootBridge|bridges] cross [the calm river|WaterSurface|river]};
    {sailing_boats on river|[# sailing_boats|SailingBoat] in violet, teal and red} and {rowing_boats on river|[#
    rowing_boats|RowingBoat] drift on it}, {sailing_boats row; rowing_boats row|strung out along the stream}.
    {paving along river|[Stone paving|StonePavement|paving] follows the water on both sides}, {lamps on paving;
    lamps along river|with [# lanterns|LampPost|lamps]} and {planters on paving; planters along river|[#
    flower_planters|FlowerPlanter|planters] alternating upon it}.

    {houses rows|Behind the paving stand two long rows of houses, [# 'in all|/house|houses]}, {houses attribute|with
    blue and green roofs}: [# tall merchant_houses|MerchantHouse|merchants], [# town_houses|TownHouse], [#
    cottages|Cottage] and [# longhouses|Longhouse]. {spires near houses|[# spire_towers|SpireTower|spires]} and
    {belfries near houses|[# bell_towers|BellTower|belfries] break the roofline}.

    {fountains inside hedges|Farther back every quarter has its formal gardens, [# 'of 'them, 'each 'round a
    fountain|Fountain|fountains]}, [# marble|Fountain:Marble|marble_fountains] and [#
    limestone|Fountain:Limestone|stone_fountains]. {hedges around fountains|[Clipped hedges|ClippedHedge] border
    them}, {gravel near fountains|[gravel|GravelGround] paths cross in them}, {benches near fountains|[#
    benches|Bench] face the water jets}, and {beds near fountains|[~ limestone garden_beds|GardenBedGround|beds]}
    are planted with {marigolds near beds|[marigolds|Marigolds]}, {daisies near beds|[daisies|Daisies]}, {tulips on
    beds|[tulips|Tulips]} and {lavender near beds|[lavender|Lavender]}.

    {shrine apart river|At the very end of the central axis waits [a marble shrine|Shrine]}, {statues row; statues
    near shrine|its approach lined by [# statues|/statue]}, [# bronze lions|LionStatue] and [# marble
    figures|FigureStatue] included. {cherries scattered|Over everything leans a flowering wood}: [~
    cherry_trees|CherryTree|cherries], [~ birches|BirchTree] and [~ limes|LimeTree], {bushes scattered|with [~
    bushes|Bush]} and {ferns scattered|[~ ferns|Ferns] on [the grass|GrassGround] below}. {lighting|Golden light},
    {atmosphere|no crowd, no noise}.
    """,
    "toy-town": """
    {id|A toy town}, {style|bright, rounded and friendly as a picture book}. Put {fountain inside stands|[a granite
    fountain|Fountain] exactly in the centre}. {layout|Then draw circles around it.}

    {layout|Circle one}: {stands around fountain|[# sweet stalls and kiosks|*Stall+/kiosk|stands]}, {stalls near
    kiosks|[# stalls|*Stall|stalls] and [# kiosks|/kiosk|kiosks] in turn}. {layout|Circle two}: {houses around
    fountain|houses, [# 'in town counting the outskirts|/house|houses]}, {houses attribute|plastered blue, green,
    white and pink}, [# of them bungalows|Bungalow] and [# cottages|Cottage]. {layout|Circle three}: {cars ring|[#
    toy cars|/car] chase each other round, bumper to bumper}: [# red vans|DeliveryVan|vans], [#
    pickup_trucks|PickupTruck|pickups], [# hatchbacks|HatchbackCar], [# estates|EstateCar] and [a yellow
    taxi|TaxiCab]. {lamps ring|[# globe lamp_posts|LampPost:Globe|lamps] stand in a ring just behind them}.
    {layout|Circle four}: {towers apart fountain|[# spired towers|SpireTower]}, {mills apart fountain|[#
    windmills|Windmill|mills]}.

    {train on rails; train row|Along the bottom edge [a red steam_locomotive|SteamLocomotive|engine] pulls [#
    coaches|PassengerCoach|train]} on {rails row|[a straight track|TrackGround|rails]}. {circus apart fountain|One
    corner belongs to [a green striped circus_tent|CircusTent|circus]}. {slide near picket|The opposite one is a
    playground: [an orange slide|Slide], [a swing|Swing], [a seesaw|Seesaw], [a sandbox|Sandbox], [a pink
    climbing_frame|ClimbingFrame|frame] and [a roundabout|Roundabout]} inside {slide inside picket|[a grey
    picket_fence|PicketFence|picket]} {slide on rubber|on [soft rubber|RubberGround|rubber]}.

    {animals scattered|Let [# animals|/animal] stroll about}: [# dogs|Dog], [# brown cats|Cat], [# grey goats|Goat]
    and [# sheep|Sheep]. {flags scattered|Scatter [# little flags|FlagPole]}, [#
    flower_planters|FlowerPlanter|planters], [# benches|Bench] and [# giant mushrooms|GiantMushroom] in the gaps.
    {trees scattered|Round trees, [~ 'or so|/tree|trees]}, [~ bushes|/bush], [poppies|Poppies], [daisies|Daisies]
    and [marigolds|Marigolds] fill [the lawn|GrassGround|lawn]. {density|No empty corner!} {lighting|Noon, blue
    sky.}
    """,
    "winter-village": """
    {condition|Deep snow has closed the pass} above {id|this mountain village}. {houses on snow|[# houses|/house]
    with snowy roofs stand in two rows}, {houses rows|gable beside gable} on [white snow|SnowGround|snow];
    {layout|between them opens [a cobbled square|CobblePavement|square]}. {layout|In its middle grows [one 'great
    fir|FirTree|fir]}, {benches ring|ringed by [# benches|Bench]}. {layout|Left and right of the tree lies the
    Christmas market}: {stalls on square; stalls grid|[# stalls|*Stall] in red and green stripes}, with
    [pottery|PotteryStall], [fish|FishStall], [spices|SpiceStall] and [fruit|FruitStall], {crates near
    stalls|[apple_crates|AppleCrate|crates]}, [barrels|Barrel] and [fruit_baskets|FruitBasket|baskets]. {lamps
    rows|[# lanterns|LampPost|lamps] burn along both rows of houses}, {layout|between [wood_piles|WoodPile|wood],
    [firewood|Firewood] and [# handcarts|Handcart]}. {well apart houses|[A limestone well|DrawWell] is frozen over}.
    {dogs scattered|[# dogs|Dog], [# white goats|Goat], [# horses|Horse] and [# banner_poles|BannerPole|poles] share
    the space}. {hills apart square|[# snowy hills|TerrainHill] shut off the view}, and {conifers apart stalls|[~
    conifers|/conifer] climb towards them}, {spruces scattered|[~ spruces|SpruceTree]}, [~ pines|PineTree] and firs,
    {boulders scattered|with [~ boulders|Boulder] and [great_boulders|GreatBoulder]}. {lighting|Low winter sun},
    {atmosphere|amber windows, frost}.
    """,
}
