"""Prompts of places of work."""

from __future__ import annotations

WORDS = {
    "brickworks": """
    {id|An old brickworks}, {atmosphere|dusty and red}. {halls row|Along the back stand [# red brick
    works_halls|/hall|halls]}, and {chimneys row; chimneys apart track|behind them smoke [#
    factory_chimneys|FactoryChimney|chimneys]}. {track row|[A narrow railway|TrackGround|track] crosses the yard
    from side to side}; {engine on track|on it [a yellow steam_locomotive|SteamLocomotive|engine] draws} {hoppers on
    track; hoppers row|[# hopper_wagons|HopperWagon|hoppers]} and [# flat_wagons|FlatWagon|flats]. {pallets
    grid|South of the rails spreads a great field of fired bricks, [~ brick_pallets|BricksPallet|pallets]} and [~
    brick_stacks|BrickStack|stacks] set out {layout|in a strict grid}; {heaps grid|beside it lie [#
    gravel_heaps|GravelHeap|heaps]} and [# grey sand_heaps|SandHeap|sand]. {trucks row|[#
    dump_trucks|DumpTruck|trucks], [# green tractors|Tractor] and [# orange forklifts|Forklift] are lined up along
    the rails}. {houses row|[# brick houses|/house] of the workers stand at the edge} {wall row|before [a red brick
    wall|GardenWall]}. {barrows scattered|[# wheelbarrows|Wheelbarrow|barrows]}, {crates scattered|[# pine
    crates|Crate]}, {churns scattered|[# milk_churns|MilkChurn|churns]} and {ladders scattered|[# ladders|Ladder]
    lie wherever they were dropped}. {pallets on cinder|Underfoot is [cinder|CinderGround]}. {density|Crowded in
    front, empty behind.}
    """,
    "refinery": """
    {id|An oil refinery}, {style|all steel and paint}: {tanks grid|[# storage_tanks|StorageTank|tanks] in a dense
    grid on one side}, {fuel grid; fuel apart tanks|[# horizontal_tanks|HorizontalTank|fuel] in another on the other
    side}. {racks rows|[~ pipe_racks|PipeRack|racks] run in two straight lines across the site}; {layout|between
    them a maze of [# pipe_valves|PipeValve|valves]}, [# pipe_bends|PipeBend|bends], [# water_pumps|WaterPump|pumps]
    and [# compressors|Compressor]. {holders row|[# tall gas_holders|GasHolder|holders] stand in a row}, {chimneys
    apart tanks|[# red brick chimneys|FactoryChimney]} and {towers row|[# concrete
    cooling_towers|CoolingTower|towers] tower over the rest}. {wagons on track; wagons row|A goods train of [#
    tank_wagons|TankWagon|wagons]}, {loco near wagons|hauled by [a white diesel_locomotive|DieselLocomotive|loco]},
    {track row|waits on [a track|TrackGround]}. {trucks on asphalt; trucks row|[# tanker_trucks|TankerTruck|trucks]}
    and {pickups on asphalt|[# silver pickup_trucks|PickupTruck|pickups] use [the asphalt
    road|AsphaltRoad|asphalt]}. {halls row|At the far end stand [# halls|/hall]}, and {fence row|[an iron
    fence|IronFence|fence] guards the near one}. {lamps row|[# twin lamp_posts|LampPost|lamps] stand along the
    railway}. {drums scattered|[~ oil_drums|OilDrum|drums]}, {sacks scattered|[~ sack_pallets|SacksPallet|sacks]}
    and {ladders scattered|[# ladders|Ladder] are spread} {drums on gravel|over [the gravel|GravelGround|gravel]}.
    {lighting|Flat noon light}, {atmosphere|heat, no people}.
    """,
    "building-site": """
    Welcome to {id|a large building site}. {layout|Two unfinished buildings face each other} {cranes near
    pillars|under [# tower_cranes|TowerCrane|cranes]}, {cranes attribute|one orange, one red}. {layout|Their outer
    walls are up, [low concrete walls|GardenWall]}; {pillars grid; pillars inside walls|within stand [# square
    concrete pillars|SquarePillar] in a grid}, and {scaffolds row; scaffolds near walls|[# orange
    scaffolds|Scaffold] lean along the fronts}.

    {diggers row|In the open half the machines are parked in a line}: [# excavators|Excavator|diggers], [#
    forklifts|Forklift] and [a green road_roller|RoadRoller|rollers]. {layout|[# sand_heaps|SandHeap|sand] and [#
    gravel_heaps|GravelHeap|gravel] lie next to them}. {layout|The stores are laid out in ranks}: [# full
    brick_pallets|BricksPallet|bricks], [# timber_pallets|TimberPallet|timber], [# cable_drums|CableDrum|drums], [#
    plank_stacks|PlankStack|planks] and [# steel_beams|SteelBeams|beams]. {containers row|[#
    freight_containers|FreightContainer|containers] in a row}, {huts row|[# site_huts|SiteHut|huts] and [#
    portable_toilets|PortableToilet|toilets] serve the crew at one side}; {trucks row|[#
    dump_trucks|DumpTruck|trucks]}, [# yellow lorries|Lorry] and [# orange hatchbacks|HatchbackCar] {layout|stand by
    the gate}.

    {walls inside fence; cranes inside fence|[A plank fence|PlankFence|fence] surrounds everything}. {cones
    scattered|[# traffic_cones|TrafficCone|cones]}, {mixers scattered|[# cement_mixers|CementMixer|mixers]},
    {barriers scattered|[# barriers|Barrier]}, {barrows scattered|[# wheelbarrows|Wheelbarrow|barrows]}, {bottles
    scattered|[# gas_bottles|GasBottle|bottles]}, [# ladders|Ladder] and [# cardboard_boxes|CardboardBox|boxes] are
    strewn {cones on soil|over [the bare soil|SoilGround|soil]}. {atmosphere|Noise, dust, haste}; {density|no tidy
    corner}; {lighting|glaring sun}.
    """,
    "sawmill": """
    {atmosphere|It smells of resin} at {id|the sawmill in the woods}. {layout|[A red boarded saw_mill|SawMill|mill]
    and [a drying_shed|DryingShed|drying] flank [a 'yard of soil|SoilGround|yard]}. {wood_piles grid; wood_piles on
    yard|One half of the yard holds [# wood_piles|WoodPile] in a grid}, {planks grid; planks on yard|the other [#
    plank_stacks|PlankStack|planks]} and {timber grid|[# timber_pallets|TimberPallet|timber]}. {crane on yard; crane
    near wood_piles|[A blue treadwheel_crane|TreadwheelCrane|crane] stands between the ranks}. {layout|In one line
    work [# green band_saws|BandSaw|saws], [# conveyor_belts|ConveyorBelt|belts], [# old grindstones|Grindstone] and
    [a sawhorse|Sawhorse]}; {lorries near wagons|in the next wait [# yellow lorries|Lorry] and [# covered
    wagons|CoveredWagon]}. {pond apart mill|To one side glints [a mill_pond|WaterSurface|pond]}, {houses row|to the
    other stand [# plank houses|/house] in a row}. {butts on yard|[Rain_butts|RainButt|butts]}, [crates|Crate],
    [firewood|Firewood] and [# wheelbarrows|Wheelbarrow] clutter the ground. {mill inside trees|All round grows a
    dense forest of [~ conifers|/conifer|trees]}, {layout|open only where the soil track comes in}; {stumps
    scattered|[~ tree_stumps|TreeStump|stumps]}, {logs scattered|[~ fallen logs|FallenLog]}, {ferns scattered|[~
    ferns|Ferns]} and {boulders scattered|[~ boulders|Boulder+GreatBoulder]} lie on [the grass|GrassGround|grass].
    {lighting|Soft forest light.}
    """,
    "power-station": """
    {id|A coal-fired power station}, {layout|arranged from the cooling towers down to the canal}. {towers grid|[#
    concrete cooling_towers|CoolingTower|towers] stand in two ranks at the top left}; {chimneys row|to the right
    rise [# red brick factory_chimneys|FactoryChimney|chimneys] above [# turbine_halls|TurbineHall|halls]}, {halls
    row|which stand in line}. {generators regular|Below hum [~ generators|Generator]} and {boxes near generators|[#
    electric_boxes|ElectricBox|boxes]}, {generators attribute|blue, orange and yellow}, in rows. {racks row; racks
    apart towers|[A pipe_bridge|PipeRack|racks] runs straight across}, and {lamps row|[# arm
    lamp_posts|LampPost|lamps] follow it}. {hoppers on tracks; hoppers rows|On [two parallel tracks|TrackGround]
    stand [# hopper_wagons|HopperWagon|hoppers]} {locos on tracks|with [# blue
    diesel_locomotives|DieselLocomotive|locos]}. {coal grid|The coal yard beyond is [~ black heaps|GravelHeap|coal]
    in even rows}, {dozers apart towers|with [# bulldozers|Bulldozer|dozers]} and [# excavators|Excavator] at work.
    {barges row; barges on canal|[# barges|Barge] lie in line on [a calm canal|WaterSurface]}. {fence row|[An iron
    fence|IronFence|fence] closes the top}. {drums scattered|[Drum_pallets|DrumsPallet|drums]}, {barrels
    scattered|[# barrels|Barrel]} and {mixers scattered|[# cement_mixers|CementMixer|mixers] stand about}
    {generators on gravel|on [the gravel|GravelGround]}. {lighting|Overcast}, {atmosphere|heavy and hot}.
    """,
}
