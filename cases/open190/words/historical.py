"""Prompts of historical places."""

from __future__ import annotations

WORDS = {
    "market-town": """
    It is {id|market day in a small medieval town}, and {density|the square is packed}. {stalls on square|[#
    market_stalls|*Stall|stalls] in striped and plain cloth stand back to back on worn
    [cobbles|CobblePavement|square]}, {stalls grid|a neat block of rows that sells [pottery|PotteryStall],
    [spices|SpiceStall], [books|BookStall] and [bread|BreadStall]}. {houses around stalls|[#
    town_houses|/house|houses] close the square on every side}, {houses attribute|roofed with tile or thatch}, [#
    'of them red brick|/house:RedBrick|red_houses]. {chapel near houses|A granite [chapel|Chapel] hides among them}.

    People draw water from [a deep granite well|DrawWell]; {benches around well; benches ring|[# plain
    benches|Bench] stand in a ring round it}, while [a statue|FigureStatue|mayor] {mayor attribute|of a forgotten
    mayor} looks on. {poles row|[# banner_poles|BannerPole|poles] in a line mark the southern edge}.
    {layout|Everywhere between lie} [barrels|Barrel], [coal_sacks|CoalSack], [small baskets|Basket], [pine
    chests|Chest] and [# handcarts|Handcart]. {animals scattered|[# loose animals|/animal] wander about}, among them
    [# white horses|Horse], [# goats|Goat] and [# brown hens|Hen].

    {trees scattered|To the north [~ broad trees|/tree], oaks, limes and ashes, form an irregular wood} with [#
    clipped bushes|Bush:Clipped|bushes] and [boulders|Boulder] beneath. {wheat rows; wheat on furrows|To the south
    [ripe wheat|WheatRow] grows in straight rows on [brown furrows|FurrowsGround]}, {layout|and a cobbled road leads
    out between the fields}.
    """,
    "mountain-monastery": """
    {id|A monastery high in dry mountains}, {lighting|under a clear sun}, {atmosphere|silent and austere}.
    {layout|Build it from the church downwards.} {church on terrace|[A limestone church|Church] stands on [a raised
    grassy terrace|*TerrainTerrace|terrace]}; {stairs near terrace|[a broad sandstone
    stair_flight|StairFlight|stairs] climbs up to it}. {tower apart stairs|West of the steps rises [a square
    stair_tower|StairTower|tower]}.

    {layout|Below lies the cloister}, {well inside wall|shut in by [a low limestone garden_wall|GardenWall|wall]}.
    {columns regular|[# stone columns|Column] run around an open court at even distances}. {layout|[Gravel
    paths|GravelGround] cross in its middle}, {well inside columns|where [a limestone well|DrawWell] stands}, and
    {beds inside columns; beds near paths|[# oak garden_beds|GardenBedGround|beds] lie in the four quarters}.
    {tulips on beds|They hold [tulips|Tulips]}, [sunflowers|Sunflowers], [poppies|Poppies], [ferns|Ferns] and
    [lavender|Lavender]. {young_trees inside columns|[# young trees|/tree|young_trees] shade the beds}, and {benches
    near church|[# benches|Bench] await the monks, most of them up by the church}. [#
    flower_planters|FlowerPlanter|planters], [# handcarts|Handcart], [flour_sacks|FlourSacks], [crates|Crate] and [#
    wine_casks|WineCask|casks] {density|stand about the yard without crowding it}.

    {graves grid|Beside the terrace lie [# graves|/tomb] in straight ranks}: [# plain gravestones|Gravestone], [#
    stone crosses|GraveCross|crosses] and [# stone tombs|StoneTomb|tombs]. {vines rows; vines on furrows|Outside the
    wall [the vines|VineRow] grow in long rows on [furrows|FurrowsGround]}, {layout|one plot left and one right of
    the path that leads straight to the cloister}. {conifers scattered|Behind the church a dark forest of [~
    conifers|/conifer] spreads without order}, [~ spruces|SpruceTree], [~ firs|FirTree] and [~ pines|PineTree], and
    {boulders scattered; boulders near conifers|[# boulders|Boulder] lie strewn among the trunks}. {columns on
    ground|All of it stands on [dry grass|DryGrassGround|ground]}.
    """,
    "viking-harbour": """
    Imagine {id|a Viking harbour} {lighting|on a bright morning}: {layout|[calm water|WaterSurface] meets [a 'strip
    of pale sand|SandGround|sand]}, and {jetties on water|[# grey plank jetties|PlankJetty] reach out in pairs}.
    {longships near jetties; longships on water|[# longships|Longship], brown, green and maroon, lie moored there}
    together with {rowing_boats near jetties; rowing_boats on water|[# rowing_boats|RowingBoat]}. {casks on
    jetties|The planks are loaded with [oak wine_casks|WineCask|casks]}, [chests|Chest] and [dark trunks|Trunk];
    [barrels|Barrel] are everywhere.

    {poles row|[# banner_poles|BannerPole|poles] in a line stand above the beach}. {gear on sand; gear row|Along the
    sand somebody has laid out [boat_gear|/boat-gear|gear]}: [# grey net_heaps|NetHeap|nets], [# old
    anchors|Anchor], [# lobster_pots|LobsterPot|pots] and [# fish_racks|FishRack|racks]. {longhouses apart
    water|Inland [# plank longhouses|Longhouse] of one storey stand in two loose lines}, {longhouses attribute|some
    of them thatched}. {hall apart longships|Farthest from the sea lies [a large plank mead_hall|MeadHall|hall]}.
    {hearth near anvil|Before it works the smith with [a heavy forge_hearth|ForgeHearth|hearth], [an old
    anvil|Anvil]}, [bellows|Bellows], [an old grindstone|Grindstone] and [a sawhorse|Sawhorse]. {logs around
    cauldron; logs ring|[# fallen logs|FallenLog] make a ring round [a cauldron|Cauldron]}. {palisade row|[A plank
    palisade|PlankFence] closes the settlement in one straight line}, and {conifers near palisade|beyond it stand [~
    conifers|/conifer], pine, fir and cypress}. {animals scattered|['Goats, 'sheep, 'hens and 'dogs|/animal|animals]
    roam between the houses}, with [handcarts|Handcart] and [wood_piles|WoodPile]. {style|All wood, straw and cloth;
    nothing is newer than the tenth century.}
    """,
    "caravanserai": """
    Somewhere on the silk road: {id|a fortified desert caravanserai}. {walls on sand|[High sandstone
    curtain_walls|CurtainWall|walls] rise from [bare sand|SandGround]}, {towers near walls|with [# round
    towers|/tower] at the corners} and {gatehouse near walls|[a sandstone gatehouse|Gatehouse] in the front}.
    {layout|[Red sand|RedSandGround|road] marks the road that runs in through it}.

    {atmosphere|Inside it is cool and busy.} {pool inside walls|In the centre of the court lies [a calm
    pool|WaterSurface]}, {pool on flags|set in [flagstones|FlagstonePavement|flags]}. {stalls grid; stalls inside
    walls; stalls on flags|On one side [# bazaar stalls|/stall] form two rows}, with [spices|SpiceStall],
    [cloth|ClothStall] and [cheese|CheeseStall]; {columns row|on the other [# columns|Column] of an arcade stand in
    a line}. {rugs on flags|[# rugs|Rug] are spread out for sale}, {rugs near sacks|beside [full
    grain_sacks|GrainSack|sacks]} and [coal_sacks|CoalSack]. [# donkeys|Donkey], [# white horses|Horse] and [# grey
    goats|Goat] wait among [pine trunks|Trunk], [laundry_baskets|LaundryBasket] and [# handcarts|Handcart].

    {layout|Not everybody found room inside.} {ridge_tents apart pool|Out on the sand camp the caravans: [#
    ridge_tents|RidgeTent] in circles}, {wagons near ridge_tents|around [# covered wagons|CoveredWagon]}.
    {round_tents near pool|[# round_tents|RoundTent] in yellow, blue, red and teal} complete the camp. {palms
    scattered; palms on sand|[~ palm_trees|PalmTree|palms], coconut, fan and date, are dotted over the desert}, and
    {boulders scattered|so are [~ 'weathered boulders|Boulder+GreatBoulder|boulders]} and [tufts of 'tall
    grass|TallGrass|grass].
    """,
    "windmill-village": """
    {id|A flat Dutch village of windmills} {lighting|on a mild spring day}. {layout|Think of it as bands running
    from west to east.}

    First {canal near mills|[a calm canal|WaterSurface]}. {bridges across canal; bridges row|[# limestone
    foot_bridges|FootBridge|bridges] cross it, evenly spaced}, and {barges on canal|[# maroon barges|Barge]} and
    {rowing_boats on canal|[# rowing_boats|RowingBoat] lie between them}. {mills row; mills along canal|On the far
    bank [# windmills|Windmill|mills] stand in one row}, [# 'of them red brick|Windmill:RedBrick|brick_mills] and [#
    'whitewashed|Windmill:WhitePlaster|white_mills].

    Next the fields. {red_tulips rows; red_tulips on soil|[Tulips|TulipRow|red_tulips] grow in ruler-straight rows
    on [dark soil|DarkSoilGround]}, {yellow_tulips rows|strip beside strip with [yellow
    tulips|YellowTulipRow|yellow_tulips]}, {pink_tulips rows|[pink tulips|PinkTulipRow|pink_tulips]} and {lavender
    rows|[lavender|LavenderRow]}, {style|so that the land looks like a striped cloth}.

    On the near side of the water comes {layout|[a 'street of red paving|RedPavement|street]}. {houses row|[#
    houses|/house] face it in one loose row}, built of {houses attribute|painted boards}, except [# 'red-brick
    ones|/house:RedBrick|brick_houses]. {lamps row; lamps near street|[# lamp_posts|LampPost|lamps] light it at
    regular steps}, and {bicycles near street|[# bicycles|*Bicycle]}, {benches near street|[# benches|Bench]} and
    {planters near street|[# flower_planters|FlowerPlanter|planters]} are left along it.

    Last the common. {stalls grid|[# market_stalls|*Stall|stalls] in two rows} sell [cheese|CheeseStall],
    [pottery|PotteryStall], [fruit|FruitStall] and [flowers|FlowerStall] {church apart mills|before [a granite
    church|Church]}. {cows scattered|[# white cows|Cow]}, {sheep scattered|[# white sheep|Sheep]} and {horses
    scattered|[# brown horses|Horse] graze all over the grass}, {cows on grass|which is [open
    meadow|GrassGround|grass]}, {bushes scattered|under [~ trees|/tree] and among [~ berry
    bushes|Bush:Berry|bushes]}. {density|Leave the meadow airy, keep the street lively.}
    """,
    "vineyard": """
    {id|An estate in wine country}; {lighting|late afternoon light}; {atmosphere|calm, well kept, prosperous}.
    {villa near garden|At its head stands [an ochre villa|Villa] of two storeys above [a formal garden of 'flower
    beds|GardenBedGround|garden]}. {layout|[A sandstone fountain|Fountain] marks the middle of it}, {fountain inside
    hedges|[clipped hedges|ClippedHedge] frame it}, {benches near fountain|[# benches|Bench] look at the water}, and
    {marigolds near garden|[marigolds|Marigolds]}, [poppies|Poppies], [sunflowers|Sunflowers] and [ferns|Ferns] fill
    the beds.

    {layout|[A gravel drive|GravelGround|gravel] leads up to the house}, {cypresses rows; cypresses near
    gravel|lined on both sides by [~ slim conifers|/conifer|cypresses]}. To the left and right of it, {layout|as far
    as one can see}, {vines rows; vines on furrows|[vines|VineRow] stand in long parallel rows on [ploughed
    furrows|FurrowsGround]}.

    The work is done beside the house: {winery apart villa|on one side [an ochre winery|Winery]}, {casks grid|with
    [# wine_casks|WineCask|casks] set out in a grid in its yard} and {wagons near winery; wagons row|[#
    wagons|/cart] drawn up in a row}; {cask_house apart winery|on the other [a cask_house|CaskHouse]}, {press apart
    villa|[an old wine_press|WinePress|press]}, {baskets apart villa|[large fruit_baskets|FruitBasket|baskets]},
    {barrels scattered|[barrels|Barrel]}, {trunks scattered|[grey trunks|Trunk]}, [chests|Chest] and [#
    handcarts|Handcart]. {orchard_gate near wall|[a garden_wall|GardenWall|wall] with [a bronze
    gate|OpenGate|orchard_gate] encloses an orchard behind the villa}, {trees apart villa|and [~ broad trees|/tree]
    close the view}. [A bust|BustStatue] and [a marble obelisk|Obelisk] {bust near villa|guard the front of the
    house}.
    """,
    "roman-forum": """
    {id|The forum of a Roman provincial town}, {lighting|in hard midday sun}. {layout|Everything is symmetrical
    about one axis.} {layout|[Flagstones|FlagstonePavement|flags] pave a rectangle}; {obelisk inside columns|on its
    centre stands [a marble obelisk|Obelisk:Marble|obelisk]}, {fountains on flags|with [# sandstone
    fountains|Fountain] behind it}. {temples apart obelisk|[# pillared temples|Temple] look down on it from three
    sides}, [# 'of them marble|Temple:Marble|marble_temples]. {columns regular|Double ranks of [~ stone
    columns|Column], evenly set, stretch along the edges}.

    {stalls grid; stalls on flags|Trade has moved in: [# stalls|*Stall] in three rows} offer [spices|SpiceStall],
    [cloth|ClothStall], [fish|FishStall], [cheese|CheeseStall] and [fruit|FruitStall] under {stalls attribute|red
    and yellow awnings}, {sacks near stalls|with [grain_sacks|GrainSack|sacks]}, [coal_sacks|CoalSack],
    [apple_crates|AppleCrate] and [trunks|Trunk] behind. {statues on flags|[Statues|/statue] line up along the top
    of the square}: [# bronze lions|LionStatue], [# bronze busts|BustStatue], [# figures|FigureStatue] and [an
    urn|UrnStatue]. {benches on flags|[# benches|Bench]} and {planters on flags|[#
    flower_planters|FlowerPlanter|planters] share another line}. [# dogs|Dog], [a white donkey|Donkey] and [#
    handcarts|Handcart] {dogs on flags|get in the way}.

    {houses row|On the open side follows a row of [# town_houses|/house|houses]}, {houses attribute|tiled and
    plastered}. {broken apart obelisk|Away from the paving older times lie about: [~ broken
    columns|BrokenColumn|broken]}, {rubble scattered|[# rubble_heaps|RubbleHeap|rubble]}, [#
    stone_piles|StonePile|piles] and [a ruined wall|RuinedWall], {bushes scattered|half hidden by [~ bushes|Bush]}
    and {conifers scattered|[~ 'pines and 'firs|/conifer|conifers]}.
    """,
    "war-camp": """
    {id|An army camps beneath a castle}. {atmosphere|Tense, colourful, muddy.}

    {layout|The castle comes first.} {layout|[Granite curtain_walls|CurtainWall|walls] enclose a ward}, {towers near
    walls|[# round towers|/tower:Round|towers] hold the corners} and {gatehouse near walls|[a dark stone
    gatehouse|Gatehouse] faces the camp}. {keep inside walls|Inside stands [a square great_keep|GreatKeep|keep]},
    {keep attribute|taller than all else}.

    Then the camp. {tents apart keep|In the field before the gate [# tents|/tent] are pitched in lines}, {tents
    attribute|striped green, red, yellow and blue}: [# 'long ridge_tents|RidgeTent|ridge_tents] and [#
    round_tents|RoundTent|round_tents]. {banners near tents|Beside each flies a banner, [# 'banner_poles in
    all|BannerPole|banners]}. {cauldrons apart keep|Between the rows [# heavy cauldrons|Cauldron] hang}, {logs
    around cauldrons; logs near cauldrons|ringed by [# fallen logs|FallenLog] to sit on}. {crates scattered|[~
    crates|Crate]}, {barrels scattered|[# barrels|Barrel]}, {sacks scattered|[# grain_sacks|GrainSack|sacks]},
    [fruit_baskets|FruitBasket], [# wine_casks|WineCask|casks] and [# handcarts|Handcart] lie about in heaps.
    {wagons row|[# wagons|/cart] stand in a line behind the last tents}.

    {layout|[A soil road|SoilGround|road] cuts straight through the camp to the gate}. {horses inside rails; horses
    scattered|West of it [# horses|Horse] graze in a paddock} {rails around horses|of [split rails|RailFence]}; east
    of it {hearth near anvil|the armourers keep [a forge_hearth|ForgeHearth|hearth], [a heavy anvil|Anvil]},
    [bellows|Bellows] and [a grindstone|Grindstone]. {trees scattered; trees apart tents|[~ 'oaks and
    'ashes|/tree|trees] crowd round the castle}, with [boulders|Boulder] and [flat field_stones|FieldStone] under
    them.
    """,
    "cemetery-hill": """
    {id|An old walled cemetery} {condition|in autumn}. {graves grid|[Graves|/tomb] stand in strict rows}: [~ plain
    gravestones|Gravestone], [~ stone crosses|GraveCross|crosses] and [~ heavy tombs|StoneTomb|tombs] {graves
    material|of granite, mossy and dark stone}. {wall around graves|[A garden_wall|GardenWall|wall] runs around
    them}. {layout|[Gravel paths|GravelGround] cross in the middle}; {firs near paths|[# firs|FirTree]} and {lamps
    near paths|[# lanterns|LampPost|lamps] accompany the main one}, {layout|which ends at [a mossy stone
    chapel|Chapel]}. {benches row; benches near paths|[# benches|Bench] line the cross path}. {statues near
    wall|[Statues|/statue] stand along the back wall}, [# granite lions|LionStatue], [# marble urns|UrnStatue] and
    [# marble riders|RiderStatue] among them, with [# obelisks|Obelisk]. {planters near graves|[#
    flower_planters|FlowerPlanter|planters]}, [tulips|Tulips] and [tall grass|TallGrass|grass] soften the stones.
    {trees scattered|Inside and outside the wall [~ trees|/tree] are scattered}: [~ birches|BirchTree], [~
    oaks|OakTree] and [~ maples|MapleTree], {atmosphere|quiet, golden, a little neglected}. {ground under
    graves|[Grass|GrassGround|ground] covers the ground between.}
    """,
}
