"""Prompts of places where people live, learn and rest."""

from __future__ import annotations

WORDS = {
    "park-lake": """
    {id|A large city park around a lake} {lighting|on the first warm Sunday of the year}.

    {rowing_boats on lake|[# rowing_boats|RowingBoat]} and {sailing_boats on lake|[# black
    sailing_boats|SailingBoat] are out on [the calm lake|WaterSurface|lake]}; {jetty near lake|[a dark plank
    jetty|PlankJetty] juts into it}, {reeds near lake|[~ reeds|Reeds] grow at the shore}. {layout|[Gravel
    paths|GravelGround|gravel] go all round the water}, {lamps near gravel|[# lamp_posts|LampPost|lamps]}, {benches
    near gravel|[~ benches|Bench]} and {bins near benches|[# litter and waste_bins|/bin|bins] beside them}.

    {bandstand apart lake|South of the lake stands [a red tiled bandstand|Bandstand]}, {layout|ringed by part of the
    benches}. {kiosks apart bandstand|Two kiosks face the water, [a blue news_kiosk|NewsKiosk|news] and [a black
    coffee_kiosk|CoffeeKiosk|kiosks]}; {tables rows|before them [# parasol_tables|ParasolTable|tables] form two
    rows}, {chairs near tables|with [# metal chairs|MetalChair] drawn up}, [# 'of them
    yellow|MetalChair:Yellow|yellow_chairs].

    {layout|West lies a formal garden}: {fountain inside hedge|[a granite fountain|Fountain] in its middle}, [a
    clipped hedge|ClippedHedge|hedge] around it, {beds inside hedge|[# fieldstone garden_beds|GardenBedGround|beds]}
    of [tulips|Tulips], [marigolds|Marigolds], [sunflowers|Sunflowers] and [ferns|Ferns]. {slide inside picket|East
    is the playground behind [a walnut picket_fence|PicketFence|picket]}: {slide on rubber|[a yellow slide|Slide] on
    [rubber|RubberGround]}, [a swing|Swing], [a seesaw|Seesaw], [a teal sandbox|Sandbox], [a teal
    climbing_frame|ClimbingFrame|frame] and [a yellow play_house|PlayHouse]. {statues row|Along the southern edge [#
    statues|/statue] stand in a row}, [# lions|LionStatue] among them.

    {bicycles scattered|[# bicycles|*Bicycle]}, [# brown dogs|Dog] and [# white ducks|Duck] are dotted about.
    {density|The rest is parkland, dense at the edges and open near the water}: [~ ashes|AshTree], [~ oaks|OakTree],
    [~ limes|LimeTree] and [~ conifers|/conifer], {trees on grass|[~ trees|/tree+/conifer] in all} on
    [lawn|GrassGround|grass], {bushes scattered|with [~ bushes|Bush] and [~ rose_bushes|*RoseBush|roses]}.
    {atmosphere|Cheerful}.
    """,
    "allotments": """
    {id|Allotment gardens, twenty-four plots in all}, {layout|in a grid of six by four}, {style|every plot alike and
    yet each its own}. {paths on grass|Two [gravel paths|GravelGround] cross in the middle on [green
    grass|GrassGround|grass]}.

    {hedges near beds|Half the plots are framed by [low clipped hedges|ClippedHedge]}, {fences near beds|the other
    half by [picket fences|PicketFence]}, {fences material|grey wood, pine and walnut}. {beds inside fences; beds
    regular|Each has five beds}, [# brick garden_beds|GardenBedGround|beds] altogether, and each bed has one crop:
    {cabbages on beds|[# 'rows of cabbages|CabbageRow]}, {pumpkins on beds|[# of pumpkins|PumpkinRow]}, {maize on
    beds|[# of maize|MaizeRow]}, {lettuce on beds|[# of lettuce|LettuceRow]}, {leeks on beds|[# of leeks|LeekRow]},
    {carrots on beds|[# of carrots|CarrotRow]} and {strawberries on beds|[# of strawberries|StrawberryRow]}. {tulips
    near beds|[Tulips|Tulips]}, [poppies|Poppies], [daisies|Daisies], [ferns|Ferns] and [sunflowers|Sunflowers] edge
    the vegetables.

    {huts near butts|At the back of every plot stands a shed}: [# green or grey huts|Hut|plain_huts], [#
    fishing_huts|FishingHut], [# saunas|Sauna] and [# woodsheds|Woodshed], [# 'buildings in all|/shed|huts]. {butts
    near huts|Beside each shed waits [a rain_butt|RainButt|butt]}, [# 'of them|RainButt|butts]. {pergolas near
    huts|[# pergolas|Pergola]} and {greenhouses near huts|[# greenhouses|Greenhouse] share the remaining corners}.

    {style|People have furnished their plots}: {tables near beds|[# parasol_tables|ParasolTable|tables]}, [# 'of
    them orange|ParasolTable:Orange|orange_tables], {benches near beds|[# benches|Bench]}, [~
    flower_planters|FlowerPlanter|planters], [# wheelbarrows|Wheelbarrow|barrows], [# large
    coal_sacks|CoalSack|sacks] and [# laundry_baskets|LaundryBasket|baskets]. {trees near beds|[~ young
    fruit_trees|/tree|trees] give shade}. {bicycles near paths; bicycles row|[# bicycles|*Bicycle]} and {bins near
    paths|[# blue waste_bins|WasteBin|bins] stand by the main path}. {density|Fill every plot, keep the paths free.}
    {lighting|Late summer, soft light}, {atmosphere|diligent and homely}.
    """,
    "quiet-close": """
    {id|A cul-de-sac in a leafy suburb}: {layout|a straight road in, a round turning place, houses like petals
    around it}. {planters ring; planters on asphalt|In the middle of [the asphalt|AsphaltRoad|asphalt] [#
    flower_planters|FlowerPlanter|planters] make a ring}. {houses around planters|[# family houses|/house] look at
    it}, {houses attribute|boarded, bricked or plastered}: {bungalows near paths|[# bungalows|Bungalow]}, [#
    townhouses|Townhouse] and [# cottages|Cottage]. {paths near houses|Each has [a flagstone
    path|FlagstonePavement|paths]} and {drives near paths|[a concrete drive|ConcreteGround|drives]}, {cars on
    drives|with a car upon it}: [# cars|/car], [# white hatchbacks|HatchbackCar] and [# yellow taxis|TaxiCab] among
    them. {boxes near paths|[# post_boxes|PostBox|boxes] stand at the garden gates}; {roses near paths|[white
    rose_bushes|WhiteRoseBush|roses]}, [clipped bushes|Bush:Clipped|bushes] and [tall grass|TallGrass|tufts] fill
    the front gardens. {sheds apart planters|Behind the houses are [# sheds|/shed]}, [#
    parasol_tables|ParasolTable|tables], [# roundabouts|Roundabout], [# yellow sandboxes|Sandbox] and [# red
    slides|Slide] for the children. {lamps near asphalt|[# lamp_posts|LampPost|lamps] light the road and the
    circle}. {trees scattered|[~ trees|/tree], oaks, limes and ashes, are scattered} {trees on grass|over [the
    grass|GrassGround|grass]}. {lighting|Sunday morning sun}, {atmosphere|safe, sleepy}.
    """,
    "camping": """
    {id|A holiday camp site on the shore of a lake}. {lighting|High summer.} {layout|Water at the top, then beach,
    then grass.}

    {jetties near sand|[# plank jetties|PlankJetty] run from [a sand beach|SandGround|sand] into [the
    lake|WaterSurface|lake]}; {rowing_boats on lake|[# rowing_boats|RowingBoat]}, {motor_boats near jetties|[#
    motor_boats|MotorBoat]} and {sailing_boats on lake|[# sailing_boats|SailingBoat] are tied up on both sides}.
    {parasols on sand|On the beach [# parasol_tables|ParasolTable|parasols]}, {benches on sand|[# benches|Bench]}
    and {rings on sand|[# life_rings|LifeRing|rings] stand in one line}.

    {tents on grass|The pitches cover the meadow: [~ tents|/tent]}, [# ridge_tents|RidgeTent] and [#
    round_tents|RoundTent], {tents attribute|striped blue or green, orange or teal}. {cars near tents|Next to each
    parks a car, [~ 'of them|/car|cars]}: [# vans|DeliveryVan], [# estate_cars|EstateCar|estates] and [# blue
    hatchbacks|HatchbackCar]. {tables near tents|Behind each is [a trestle_table|TrestleTable|table]}, [# 'of
    these|TrestleTable|tables] in oak, walnut and birch, {chairs near tables|with four chairs, [~
    'altogether|/chair|chairs]}, [~ metal_chairs|MetalChair|metal] and [~ navy
    upholstered_chairs|UpholsteredChair|upholstered] included. {plates on tables|Breakfast is served: [~ porcelain
    plates|Plate]}, {bottles on tables|[~ bottles|Bottle]}, {cups on tables|[~ blue cups|Cup]} and {bowls on
    tables|[~ fruit_bowls|FruitBowl|bowls]}.

    {layout|[Gravel paths|GravelGround] cross in the middle}; {lamps near paths|[# lamp_posts|LampPost|lamps]},
    {bins near paths|[# litter_bins|LitterBin|bins]} and {bicycles near paths|[# bicycles|*Bicycle] stand beside
    them}. {wash apart logs|[A pale plank wash_house|WashHouse|wash]} and {kiosk near paths|[a black
    coffee_kiosk|CoffeeKiosk|kiosk]} serve the guests. {logs around cauldron; logs ring|[# fallen logs|FallenLog]
    ring [a cauldron|Cauldron]}. {slide inside picket|A playground has [a birch picket_fence|PicketFence|picket]},
    {slide on rubber|[a blue slide|Slide]}, {swing on rubber|[a teal swing|Swing]}, [a white seesaw|Seesaw] and [a
    yellow roundabout|Roundabout] on [rubber|RubberGround]. {trees on grass|[~ trees|/tree+/conifer] shade [the
    grass|GrassGround|grass]}, [~ pines|PineTree] and [~ oaks|OakTree] above all, {boulders scattered|with [~
    boulders|Boulder+GreatBoulder]} and [~ bushes|Bush]. {atmosphere|Relaxed, a little untidy.}
    """,
    "school-grounds": """
    {id|The grounds of a suburban school}, {layout|seen with the buildings at the back and the gate in front}.
    {layout|[A red brick school|School] of three storeys and [its sports_hall|SportsHall|hall] stand side by side}.
    {layout|Before them lies [the school yard|AsphaltRoad|yard]}, {racks row|with [#
    bicycle_racks|BicycleRack|racks]} and {bicycles near racks|[# bicycles|*Bicycle] in a line}, {tables grid;
    tables on yard|[# square tables|SquareTable] in a grid}, {planters on yard|[#
    flower_planters|FlowerPlanter|planters]}, {flags on yard|[# flag_poles|FlagPole|flags]} and [# blue
    spring_horses|SpringHorse|horses].

    {slide inside picket|Left of the yard is a playground with [a walnut picket_fence|PicketFence|picket]}: {slide
    on rubber|[a blue slide|Slide]}, {swing on rubber|[a blue swing|Swing]}, {seesaw on rubber|[a seesaw|Seesaw]},
    [a red sandbox|Sandbox], [a yellow climbing_frame|ClimbingFrame|frame], [a red roundabout|Roundabout] and [a
    blue play_house|PlayHouse] on [soft rubber|RubberGround].

    {goals on pitch; goals apart school|The sports field is [a striped lawn|LawnStripesGround|pitch] with [# red
    goal_frames|GoalFrame|goals]}, {benches rows|and [# benches|Bench] line its edge and the gardens}. {layout|The
    school garden lies opposite inside [clipped hedges|ClippedHedge|hedge]}: {well inside hedge|[a concrete
    well|DrawWell]}, {beds inside hedge|[# oak garden_beds|GardenBedGround|beds]}, {marigolds on
    beds|[marigolds|Marigolds]}, [sunflowers|Sunflowers], [lavender|Lavender], [tulips|Tulips], [reeds|Reeds] and
    [ferns|Ferns], {layout|where [gravel paths|GravelGround|gravel] cross}. {layout|[A white greenhouse|Greenhouse]
    stands next to it}. {paving apart well|[A paved walk|StonePavement|paving] leads from the gate to the yard}.

    {cars near bus|Behind the school [# cars|/car] and [a lime bus|CityBus] wait by [a
    bus_shelter|BusShelter|shelter]}. {school inside fence|[An iron fence|IronFence|fence] goes round the whole
    plot}. {trees scattered|[~ trees|/tree], ashes and oaks, are scattered on [the grass|GrassGround|grass]},
    {bushes scattered|with [~ bushes|Bush] and [# yellow rose_bushes|YellowRoseBush|roses]}. {atmosphere|Break
    time}; {density|the yard busy, the field empty}; {lighting|bright, clear}.
    """,
    "business-park": """
    {id|A business park out of town}, {style|new, smooth, expensive}. {pond inside paths|At its centre lies [a
    pond|WaterSurface]}, {paths around pond; paths near pond|and [paved walks|StonePavement|paths] run round it}.
    {reeds row; reeds near pond|[# reeds|Reeds] in a line edge the water}. {benches rows|Above and below it [#
    benches|Bench]}, {lamps rows|[# lamp_posts|LampPost|lamps] and young trees stand in rows}. {offices apart
    pond|[# office_blocks|OfficeBlock|offices] keep their distance on all sides}, {offices attribute|plain,
    flat-roofed and pale}; {planters near flags; planters near offices|before every entrance are [#
    flower_planters|FlowerPlanter|planters]} and {flags near offices|[# flag_poles|FlagPole|flags]}.

    {tables row|For lunch there are [# parasol_tables|ParasolTable|tables] in a row}, {chairs around tables; chairs
    near tables|with [# shell_chairs|ShellChair|chairs]}, [# 'of them teal|ShellChair:Teal|teal_chairs], {obelisk
    apart pond|and [a granite obelisk|Obelisk] for art}. {cars on asphalt; cars rows|Most ground goes to cars, [~
    'of them|/car|cars]}, {cars on bays|parked in [marked bays|RoadParkingBays|bays]} on
    [asphalt|AsphaltRoad|asphalt]: [# hatchbacks|HatchbackCar], [# vans|DeliveryVan], [#
    saloon_cars|SaloonCar|saloons], [# yellow taxis|TaxiCab], [# blue estate_cars|EstateCar|estates] and [# white
    police_cars|PoliceCar|police]. {shelter apart pond|[A bus_shelter|BusShelter|shelter] waits at the far edge}.
    {bicycles scattered|[~ bicycles|*Bicycle]}, {signs scattered|[# teal parking_signs|ParkingSign|signs]}, {bushes
    scattered|[~ bushes|Bush] and [# yellow rose_bushes|YellowRoseBush|roses] are dotted about}, {trees scattered;
    trees on lawn|as are [~ trees|/tree]} {trees apart pond|on [the striped lawn|LawnStripesGround|lawn]}.
    {lighting|Cool daylight}, {atmosphere|tidy, anonymous}, {density|generous empty lawns}.
    """,
}
