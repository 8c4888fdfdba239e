"""Prompts of places where people come and go."""

from __future__ import annotations

WORDS = {
    "city-crossing": """
    {id|Rush hour at a big city crossing}. {density|Nothing stands still here}, {layout|and everything follows the
    cross of two avenues}.

    The roads: {layout|[straight carriageways|RoadStraight|roads] meet from four sides} {zebras on middle|on [a
    'square of asphalt|AsphaltRoad|middle]}; {zebras ring|[# zebra crossings|RoadZebraCrossing|zebras] frame it},
    and {signals near zebras|[# traffic_signals|TrafficSignal|signals] watch the corners}. {layout|[Stone
    paving|StonePavement|pavement] runs along every kerb}.

    The traffic: {buses on roads|[# city_buses|CityBus|buses]}, [# of them yellow|CityBus:Yellow|yellow_buses];
    {taxis on roads|[# yellow taxis|TaxiCab]}; {vans on roads|[# delivery_vans|DeliveryVan|vans], mostly white};
    {pickups on roads|[# teal pickup_trucks|PickupTruck|pickups]}; {estates on roads|[#
    estate_cars|EstateCar|estates]}; {hatchbacks on roads|[# blue hatchbacks|HatchbackCar]}; {police on roads|[#
    white police_cars|PoliceCar|police]}. {cars on roads|Park or queue them, [~ cars|/car] together, along the
    kerbs}.

    The buildings: {shops near pavement|[# shops|/shop] with their fronts on the street}, among them {tea_houses
    near shops|[# tea_houses|TeaHouse]}, [# pharmacies|Pharmacy], [a bakery|Bakery], [a bank|Bank] and [a
    tailor_shop|TailorShop|tailor]; and {blocks apart statue|[# tall blocks|/block]}, [# flat-roofed
    office_blocks|OfficeBlock|offices], [# apartment_blocks|ApartmentBlock|apartments] and [a red brick
    hospital|Hospital].

    The pavement: {lamps on pavement; lamps regular|[# lamp_posts|LampPost|lamps] at even distances}, {trees on
    pavement|[# street_trees|/tree|trees] between them}. {density|Clutter everywhere}: {meters on pavement|[#
    parking_meters|ParkingMeter|meters]}, {booths on pavement|[# red phone_booths|PhoneBooth|booths]}, {bins on
    pavement|[# waste_bins|WasteBin|bins]}, {planters on pavement|[# flower_planters|FlowerPlanter|planters]},
    {benches on pavement|[# garden benches|Bench]}, {bicycles on pavement|[# bicycles|*Bicycle]}, {signs on
    pavement|[# street_name_signs|StreetNameSign|signs]}, {parking on pavement|[#
    parking_signs|ParkingSign|parking]} and {boxes on pavement|[# green electric_boxes|ElectricBox|boxes]}. {statue
    apart signals|On one corner [a lion|LionStatue|statue] looks down on it all}. {lighting|Hazy daylight},
    {atmosphere|noise, haste}.
    """,
    "tram-street": """
    {id|Take the tram down the shopping street}! {rails rows|Two straight [tracks|TrackGround|rails] run side by
    side} {rails on paving|over [pale stone paving|StonePavement|paving]}, and {trams on rails; trams rows|[#
    trams|Tram] travel on them}, [# yellow|Tram:Yellow|yellow_trams] and [# silver|Tram:Silver|silver_trams].
    {shelters near rails; shelters along rails|At the stops wait [# steel shelters|TramShelter]}, {boards near
    shelters|with [# timetable_boards|TimetableBoard|boards] beside them}.

    {shops rows|Shop fronts line the street on both sides, [~ 'in all|/shop|shops]}: [# butcheries|Butchery], [#
    bakeries|Bakery], [# tailors|TailorShop], [# barbers|BarberShop], [# bookshops|Bookshop], [# cafes|Cafe] and [#
    flower_shops|FlowerShop]. {blocks apart rails|Behind them rise taller houses}, [#
    apartment_blocks|ApartmentBlock|blocks] and [# pink hotels|Hotel|hotels].

    {chairs around tables; chairs near tables|People sit outside: [~ metal chairs|MetalChair] gather round [#
    parasol_tables|ParasolTable|tables]}, {tables rows; tables near shops|which stand in front of the windows}.
    {trees rows|[# street_trees|/tree|trees]}, {lamps along rails|[# lamp_posts|LampPost|lamps]} and {planters on
    paving|[~ flower_planters|FlowerPlanter|planters] form a line on either side of the rails}. {benches on paving;
    benches scattered|[# garden benches|Bench]}, {bins scattered|[# recycling_bins|RecyclingBin|bins]}, {boxes
    scattered|[# electric_boxes|ElectricBox|boxes]}, {notices scattered|[# red notice_boards|NoticeBoard|notices]},
    [# red hydrants|Hydrant] and [# cargo_bicycles|CargoBicycle|bicycles] are {density|sprinkled over the pavement}.
    {lighting|A sunny Saturday}, {atmosphere|lively but unhurried}.
    """,
    "bus-terminal": """
    {id|A suburban bus terminal}, {layout|long and orderly}. {buses rows|[# city_buses|CityBus|buses] wait in lines}
    {islands under canopies|beside four paved islands} of [stone paving|StonePavement|islands], {canopies rows;
    canopies on islands|each under a row of [aluminium canopies|PlatformCanopy]}. {boards under canopies; boards on
    islands|[# timetable_boards|TimetableBoard|boards]}, [# white flower_planters|FlowerPlanter|planters], [#
    recycling_bins|RecyclingBin|bins] and [# blue waiting_benches|WaitingBench|benches] serve the passengers.
    {building apart buses|At the head stands [a grey terminal_building|TerminalBuilding|building] of two storeys};
    {tickets near building|before it [# ticket_machines|TicketMachine|tickets], [a
    vending_machine|VendingMachine|vending]} and {kiosks near building|[# kiosks|/kiosk]}. {shops rows|[# small
    shops|/shop] close both sides} in two rows. {taxis on asphalt|[# yellow taxis|TaxiCab] queue} under [#
    lamp_posts|LampPost|lamps]. {cars on bays|At the front spreads a car park with [~ cars|/car]} on [marked
    parking_bays|RoadParkingBays|bays]: [# pickup_trucks|PickupTruck|pickups], [# estate_cars|EstateCar|estates], [#
    hatchbacks|HatchbackCar] and [# white saloon_cars|SaloonCar|saloons]. {layout|[# trees|/tree] and [#
    parking_signs|ParkingSign|signs] edge it}. {buses on asphalt|The rest is [bare asphalt|AsphaltRoad|asphalt]},
    {lighting|grey morning light}, {atmosphere|functional}.
    """,
    "country-station": """
    {id|A railway halt deep in the country, in the age of steam}. {lighting|Bright, breezy weather.} {coaches row;
    coaches on track|On the nearer track [a yellow steam_locomotive|SteamLocomotive|engine] has pulled in [#
    passenger_coaches|PassengerCoach|coaches]}; {engine near coaches|steam up}, {engine on track|it blocks [the
    line|TrackGround|track]}. {wagons on track|On the second stand goods wagons}: [# flat_wagons|FlatWagon|wagons],
    [# box_wagons|BoxWagon|boxes] and [a red tank_wagon|TankWagon|tank].

    {platform along track; platform row|[A long platform|StationPlatform] of five pieces lies beside the rails}.
    {benches on platform|It carries [# benches|Bench]}, {planters on platform|[#
    flower_planters|FlowerPlanter|planters]}, {lamps on platform; lamps row|[# lamp_posts|LampPost|lamps]}, {trunks
    on platform|[# travelling_trunks|Trunk|trunks]} and {churns on platform|[# blue milk_churns|MilkChurn|churns]}.
    {house near platform|Behind it stands [the red brick station_house|StationHouse|house]}, with {box apart
    house|[a wooden signal_box|SignalBox|box] to one side} and {tower apart box|[a yellow
    water_tower|WaterTower|tower] to the other}. {signals along track; signals row|[#
    rail_signals|RailSignal|signals]} and [# switch_levers|SwitchLever|levers] accompany the line, and {barriers
    near track|[# white level_crossing_barriers|LevelCrossingBarrier|barriers]} guard {lane apart tower|[a soil
    lane|SoilGround|lane]} that crosses it.

    {cottages rows|Along this lane lie the houses of the village, [# 'all told|House+Longhouse+Cottage|cottages]},
    {cottages material|in red brick}. {carts row|[# carts|/cart]} and {bicycles near carts|[# bicycles|*Bicycle]
    stand by [the gravel|GravelGround|gravel] path to the station}.

    Around it, farmland. {wheat rows; wheat on furrows|[Wheat|WheatRow]} and {cabbages rows; cabbages on
    furrows|[cabbages|CabbageRow] grow in rows on [furrows|FurrowsGround]}. {horses inside rails|[# brown
    horses|Horse], [# cream cows|Cow] and [# brown sheep|Sheep] share a paddock behind [split
    rails|RailFence|rails]}. {planks along track|[A plank fence|PlankFence|planks] follows the tracks}. {trees
    scattered|[~ trees|/tree] make scattered woods}, [~ limes|LimeTree], [~ oaks|OakTree] and [~ ashes|AshTree],
    {bushes scattered|with [~ bushes|Bush] and [~ yellow rose_bushes|YellowRoseBush|roses] beneath}.
    {atmosphere|Nobody hurries}; {density|meadow everywhere}, {trees on grass|[green grass|GrassGround|grass]}.
    """,
    "airfield": """
    {id|A small airfield} {lighting|on a hot dry afternoon}. {planes grid; planes on apron|[#
    light_aircraft|LightAircraft|planes] are parked in two ranks on [a concrete apron|ConcreteGround|apron]},
    {planes attribute|white, red, blue, silver and yellow}. {runway apart hangars|Past them runs the asphalt
    [runway|RoadStraight]}, {bollards along runway; bollards rows|its edges set with [~ steel bollards|Bollard]}.
    {hangars row; hangars near apron|[# hangars|Hangar] open towards the apron}; {tower near terminal|next in line
    come [a square control_tower|ControlTower|tower]} and [a concrete terminal|Terminal], {chairs around
    tables|where [~ shell_chairs|ShellChair|chairs] stand about [# parasol_tables|ParasolTable|tables]}. {trucks
    row; trucks near apron|[# silver tanker_trucks|TankerTruck|trucks]} and {pickups near apron|[#
    pickup_trucks|PickupTruck|pickups]} serve the machines; {tanks row; tanks apart hangars|[# horizontal
    fuel_tanks|HorizontalTank|tanks] lie in a row at the end}. {flags row|[# flag_poles|FlagPole|flags] and
    [warning_signs|WarningSign|signs] mark the taxiway}. {pallets on apron|[Pallets|/pallet]}, [#
    oil_drums|OilDrum|drums], [crates|Crate] and [# orange portable_toilets|PortableToilet|toilets] lie about.
    {fence row|[An iron fence|IronFence|fence] closes the grounds}, {trees scattered|[~ trees|/tree] are scattered
    over [the dry grass|DryGrassGround|grass] beyond}. {atmosphere|Sleepy}, {layout|wide open}.
    """,
}
