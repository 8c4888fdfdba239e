"""Stage 1 passes on what geometry does not truly decide: scenes in which it once said yes or no and could not know."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import pytest

from c4s.protocol.bundle import read_requirements
from c4s.records.evidence import catalog_facts
from c4s.records.pack import MANIFEST, Pack
from c4s.semantics.state import StateDecider
from tests.built import built_packs
from tests.judge.small_scenes import asset, bundle, entity, predicate, thing

Record = dict[str, Any]


def shape(name: str, color: Any = None, material: str = "M_X") -> tuple[str, Record]:
    facts, path = asset(name, name.lower(), (), color, material)
    return path, facts


CATALOG: dict[str, Record] = dict(
    shape(name)
    for name in (
        "Armchair", "Bench", "Bridge", "Castle", "Chair", "Desk", "Flower", "House", "Lamp", "Moat", "Parasol", "Pot",
        "Sign", "Table", "Tree", "Wall",
    )
)  # fmt: skip
CATALOG |= dict([shape("Grey Box", [0.5, 0.5, 0.5], "M_Plaster"), shape("Pale Box", [0.62, 0.62, 0.62], "M_Wood")])
PATHS = {facts["name"]: path for path, facts in CATALOG.items()}
CUBE = "/Engine/BasicShapes/Cube.Cube"
MINE = "/Game/Mine/M_Red.M_Red"


def put(
    what: str, *places: tuple[float, float, float], half: tuple[float, float, float] = (50, 50, 50)
) -> list[Record]:
    return [thing(f"{what} {at}", PATHS.get(what, what), at, half) for at in places]


def line(count: int, x: float, step: float = 200.0) -> list[tuple[float, float, float]]:
    return [(x + step * n, 0.0, 50.0) for n in range(count)]


def ring(count: int, radius: float) -> list[tuple[float, float, float]]:
    turns = [2 * math.pi * n / count for n in range(count)]
    return [(radius * math.cos(turn), radius * math.sin(turn), 50.0) for turn in turns]


def many(name: str, *aliases: str) -> Record:
    return entity(name, *aliases, collection=True)


def related(relation: str, *named: str, negative: bool = False) -> Record:
    return predicate("spatial_relation", *named, relation=relation, negative=negative)


def counted(name: str, count: int) -> Record:
    return predicate("quantity", name, quantity={"mode": "exact", "value": count})


def said(scene: list[Record], entities: list[Record], claim: Record) -> str:
    requirements = read_requirements(bundle(entities, claim))
    return StateDecider(requirements, {"actors": scene}, CATALOG).decide("p0").status


DESK = put("Desk", (0, 0, 40), half=(100, 60, 40))
TABLE = put("Table", (0, 0, 40), half=(60, 60, 40))
CASTLE = put("Castle", (0, 0, 500), half=(800, 800, 500))
MOAT = put("Moat", (0, 0, -10), half=(400, 4000, 10))
BRIDGE = put("Bridge", (0, 0, 100), half=(600, 150, 150))
POTS = put("Pot", (0, 0, 20), (900, 0, 20), (900, 900, 20), (0, 900, 20), half=(20, 20, 20))
LAMPS = put("Lamp", (-20, 0, 90), (20, 0, 90), half=(8, 8, 10)) + put("Lamp", *line(8, 3000), half=(8, 8, 50))


@pytest.mark.parametrize(
    ("scene", "entities", "claim", "status"),
    [
        pytest.param(
            DESK + LAMPS,
            [many("lamps", "lamp"), entity("desk")],
            related("on", "lamps", "desk", negative=True),
            "UNKNOWN",
            id="no lamps on the desk, and two of ten are",
        ),
        pytest.param(
            DESK + LAMPS[2:],
            [many("lamps", "lamp"), entity("desk")],
            related("on", "lamps", "desk", negative=True),
            "MATCH",
            id="no lamps on the desk, and none is",
        ),
        pytest.param(
            put("House", (0, 0, 400), half=(500, 500, 400)) + put("Sign", (0, -508, 300), half=(60, 8, 30)),
            [entity("sign"), entity("house")],
            related("mounted_on", "sign", "house"),
            "UNKNOWN",
            id="a sign on the front of a house",
        ),
        pytest.param(
            TABLE + put("Parasol", (0, 0, 125), half=(100, 100, 125)),
            [entity("parasol"), entity("table")],
            related("over", "parasol", "table"),
            "UNKNOWN",
            id="a parasol that stands under its own roof",
        ),
        pytest.param(
            MOAT + BRIDGE,
            [entity("bridge"), entity("moat")],
            related("over", "bridge", "moat"),
            "UNKNOWN",
            id="a bridge with its piers in the water",
        ),
        pytest.param(
            MOAT + BRIDGE,
            [entity("bridge"), entity("moat")],
            related("under", "moat", "bridge"),
            "UNKNOWN",
            id="water under a bridge with its piers in it",
        ),
        pytest.param(
            MOAT + BRIDGE,
            [entity("bridge"), entity("moat")],
            related("spans", "bridge", "moat"),
            "MATCH",
            id="a bridge from bank to bank",
        ),
        pytest.param(
            MOAT + put("Bridge", (-390, 0, 20), half=(50, 50, 20)),
            [entity("bridge"), entity("moat")],
            related("spans", "bridge", "moat"),
            "UNKNOWN",
            id="a bridge that only touches the water",
        ),
        pytest.param(
            POTS + put("Flower", (450, 450, 20), half=(5, 5, 20)),
            [entity("flower"), many("pots", "pot")],
            related("in", "flower", "pots"),
            "UNKNOWN",
            id="a flower among pots and in none",
        ),
        pytest.param(
            CASTLE + put("Wall", *ring(20, 5000), half=(200, 200, 150)),
            [many("walls", "wall"), entity("castle")],
            related("surrounds", "walls", "castle"),
            "UNKNOWN",
            id="walls around a castle, far from it",
        ),
        pytest.param(
            TABLE + put("Tree", *ring(4, 600), *line(6, 9000)),
            [many("trees", "tree"), entity("table")],
            related("around", "trees", "table"),
            "UNKNOWN",
            id="trees around a table, and more elsewhere",
        ),
        pytest.param(
            TABLE + put("Chair", (-150, 0, 50), (150, 0, 50), *line(20, 6000)),
            [many("two chairs", "chair"), many("dining chairs", "chair"), entity("table")],
            related("near", "two chairs", "table"),
            "UNKNOWN",
            id="two chairs by a table, and twenty that another entity means",
        ),
        pytest.param(
            put("Bench", *line(5, 0, 1000)),
            [many("gate benches", "bench"), many("pond benches", "bench")],
            counted("gate benches", 2),
            "UNKNOWN",
            id="two benches here and three there",
        ),
        pytest.param(
            put("Bench", *line(5, 0, 1000)),
            [many("benches", "bench")],
            counted("benches", 2),
            "MISMATCH",
            id="five benches are not two",
        ),
        pytest.param(
            put("Chair", *line(4, 0)) + put("Armchair", *line(2, 2000)),
            [many("chairs", "chair")],
            counted("chairs", 6),
            "UNKNOWN",
            id="six chairs of which two are armchairs",
        ),
        pytest.param(
            put("Chair", *line(4, 0)) + put(CUBE, *line(2, 2000)),
            [many("chairs", "chair")],
            counted("chairs", 6),
            "UNKNOWN",
            id="six chairs of which two are made of cubes",
        ),
        pytest.param(
            put("Chair", *line(3, 0)) + put("Armchair", *line(2, 2000)),
            [many("chairs", "chair")],
            counted("chairs", 6),
            "MISMATCH",
            id="whatever they are, they are five",
        ),
        pytest.param(
            put("House", (0, 0, 50)),
            [entity("house")],
            predicate("quantity", "house", quantity={"mode": "exact", "value": 3, "unit": "storeys"}),
            "UNKNOWN",
            id="a house of three storeys is not three houses",
        ),
        pytest.param(
            put("Chair", *line(3, 0)),
            [many("chairs", "chair")],
            predicate("quantity", "chairs", quantity={"mode": "exact", "value": 3, "unit": "chairs"}),
            "MATCH",
            id="three chairs, counted in chairs",
        ),
        pytest.param(
            put("Chair", *ring(3, 300)),
            [many("chairs", "chair")],
            predicate("distribution", "chairs", relation="in_circle"),
            "UNKNOWN",
            id="a circle of three",
        ),
        pytest.param(
            put("Tree", *line(8, 0, 800)),
            [many("trees", "tree")],
            predicate("distribution", "trees", relation="spread_along"),
            "UNKNOWN",
            id="spread along a street is no scatter",
        ),
        pytest.param(
            put("Tree", *line(8, 0, 800)),
            [many("trees", "tree")],
            dict(predicate("distribution", "trees", relation="evenly_spaced"), text="evenly spaced on the ring road"),
            "MATCH",
            id="a ring road is no ring",
        ),
    ],
)
def test_what_geometry_does_not_decide_is_passed_on(
    scene: list[Record], entities: list[Record], claim: Record, status: str
) -> None:
    assert said(scene, entities, claim) == status


def test_a_negated_operand_of_which_a_part_holds_is_open() -> None:
    part = related("on", "lamps", "desk")
    none_of = predicate("logic", logic={"operator": "not", "requirement_ids": ["p0"]})
    asked = read_requirements(bundle([many("lamps", "lamp"), entity("desk")], part, none_of))
    decider = StateDecider(asked, {"actors": DESK + LAMPS}, CATALOG)
    assert [decider.decide(node).status for node in ("p0", "p1")] == ["MISMATCH", "UNKNOWN"]


def test_where_two_compasses_suit_as_well_a_side_that_only_one_of_them_has_is_open() -> None:
    """One thing east of the desk, one north; the third, by one compass south and by the other north, stands north."""
    beside = put("Chair", (2000, 0, 50)) + put("Tree", (0, 2000, 50)) + put("Bench", (200, 2000, 50))
    things = [entity(name) for name in ("desk", "chair", "tree", "bench")]
    claims = [related(f"{side}_of", name, "desk") for name, side in (("chair", "east"), ("tree", "north"))]
    asked = read_requirements(bundle(things, *claims, related("south_of", "bench", "desk")))
    decider = StateDecider(asked, {"actors": DESK + beside}, CATALOG)
    assert [decider.decide(node).status for node in ("p0", "p1", "p2")] == ["MATCH", "UNKNOWN", "UNKNOWN"]


def engine_actor(class_path: str, extent: float) -> Record:
    bounds = {"origin_cm": [0, 0, 0], "extent_cm": [extent, extent, 10]}
    return {"name": class_path, "class": class_path, "bounds": bounds, "c4s": {"components": [{"mesh": None}]}}


@pytest.mark.parametrize(
    ("scene", "asked", "status"),
    [
        ([engine_actor("/Script/Landscape.Landscape", 5000)], entity("meadow", region=True), "UNKNOWN"),
        ([engine_actor("/Script/Landscape.Landscape", 5000)], entity("bench"), "MISMATCH"),
        ([engine_actor("/Script/Engine.SpotLight", 10), *DESK], entity("spotlight"), "UNKNOWN"),
        ([engine_actor("/Script/Engine.SkyLight", 10), *DESK], entity("bench"), "MISMATCH"),
        ([], entity("meadow", region=True), "MISMATCH"),
    ],
)
def test_what_has_no_mesh_may_still_be_there(scene: list[Record], asked: Record, status: str) -> None:
    assert said(scene, [asked], predicate("existence", asked["name"])) == status


NOWHERE = thing("nowhere", PATHS["Chair"], (math.nan, 0, 50))


@pytest.mark.parametrize(
    ("scene", "claim", "status"),
    [
        ([NOWHERE], predicate("existence", "desk"), "UNKNOWN"),
        ([NOWHERE, *put("Chair", *line(3, 0))], predicate("existence", "desk"), "UNKNOWN"),
        (put("Chair", *line(3, 0)), predicate("existence", "desk"), "MISMATCH"),
        ([NOWHERE, *put("Chair", *line(3, 0))], counted("chair", 4), "UNKNOWN"),
        ([NOWHERE, *put("Chair", *line(3, 0))], counted("chair", 5), "MISMATCH"),
    ],
)
def test_what_is_shown_at_no_place_is_no_proof_of_absence(scene: list[Record], claim: Record, status: str) -> None:
    assert said(scene, [entity("desk"), entity("chair")], claim) == status


@pytest.fixture(scope="module")
def shipped(tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, Mapping[str, Any]]:
    """The catalogs of two packs, as the judge has them."""
    names = ("c4s-home", "c4s-harbour")
    return catalog_facts([Pack.read(built_packs(tmp_path_factory, name) / name / MANIFEST) for name in names])


@pytest.mark.parametrize(
    ("name", "colors", "status"),
    [
        ("Kettle", "black", "UNKNOWN"),
        ("Flower Vase", "pink", "UNKNOWN"),
        ("Flower Vase", "white", "MATCH"),
        ("Fruit Bowl", "orange", "UNKNOWN"),
        ("Lighthouse", "red", "UNKNOWN"),
        ("Flower Vase", "pink white", "MATCH"),
        ("Harbour Crane", "yellow", "MATCH"),
        ("Fishing Boat", "blue", "MATCH"),
    ],
)
def test_the_colour_of_a_part_is_not_that_of_the_thing(
    shipped: Mapping[str, Mapping[str, Any]], name: str, colors: str, status: str
) -> None:
    """Of shipped assets, by their descriptions alone: ``Steel kettle with a black handle``."""
    bare = {path: {**facts, "materials": []} for path, facts in shipped.items() if facts["name"] == name}
    claim = predicate("attribute", name, qualifiers=[{"kind": "color", "name": color} for color in colors.split()])
    asked = read_requirements(bundle([entity(name)], claim))
    scene = [thing("it", next(iter(bare)), (0, 0, 50))]
    assert StateDecider(asked, {"actors": scene}, bare).decide("p0").status == status


def test_what_the_editor_hides_is_in_no_picture_and_not_there() -> None:
    hidden = [dict(one, export_diagnostics={"hidden_in_editor": True}) for one in DESK]
    scene = hidden + put("Chair", *line(3, 0))
    assert said(scene, [entity("desk")], predicate("existence", "desk")) == "MISMATCH"


@pytest.mark.parametrize(
    ("what", "shown", "qualifier", "status"),
    [
        ("Pale Box", [], ("color", "white"), "MATCH"),
        ("Grey Box", [], ("color", "red"), "MISMATCH"),
        ("Grey Box", [MINE], ("color", "red"), "UNKNOWN"),
        ("Pale Box", [MINE], ("color", "white"), "UNKNOWN"),
        ("Pale Box", [MINE], ("material", "wood"), "UNKNOWN"),
        ("Pale Box", [MINE], ("material", "metal"), "UNKNOWN"),
        ("Pale Box", [], ("material", "metal"), "MISMATCH"),
        ("Pale Box", ["/Game/P/M_Plaster.M_Plaster", MINE], ("material", "wood"), "UNKNOWN"),
    ],
)
def test_a_material_that_the_agent_made_says_nothing_and_hides_the_asset_s_own(
    what: str, shown: list[str], qualifier: tuple[str, str], status: str
) -> None:
    scene: list[Mapping[str, Any]] = [dict(one, material_paths=shown) for one in put(what, (0, 0, 50))]
    kind, words = qualifier
    claim = predicate("attribute", "box", qualifiers=[{"kind": kind, "name": words}])
    assert said([dict(one) for one in scene], [entity("box")], claim) == status
