"""The rule judge on small scenes: grounding, counts, looks, relations, distributions, logic."""

from __future__ import annotations

import json
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.protocol.bundle import read_requirements
from c4s.protocol.words import head, singular
from c4s.semantics.binding import bind
from c4s.semantics.quantities import limits
from c4s.semantics.state import StateDecider
from tests.judge.small_scenes import CATALOG, bundle, decide, entity, predicate, thing
from tests.shared import SHARED

ALLEY = SHARED / "upstream/tests/fixtures/synthetic-alley.bundle.json"
BAZAAR = SHARED / "upstream/benchmark/public/text-to-scene/bazaar/requirements/bazaar.bundle.json"


@pytest.mark.parametrize(
    ("plural", "one"),
    [
        ("chairs", "chair"),
        ("benches", "bench"),
        ("boxes", "box"),
        ("glass", "glass"),
        ("shelves", "shelf"),
        ("bus", "bus"),
        ("ladies", "lady"),
        ("crates", "crate"),
        ("dishes", "dish"),
        ("houses", "house"),
    ],
)
def test_singular(plural, one):
    assert singular(plural) == one


@pytest.mark.parametrize(
    ("name", "wanted", "found"),
    [
        ("SM_Chair_Large_02", "chair", True),
        ("Table lamp", "table", False),
        ("Table lamp", "lamp", True),
        ("Barrel of apples", "apple", False),
        ("Barrel of apples", "barrels", True),
        ("Armchair", "chair", False),
        ("SM_FishingBoat", "fishing boats", True),
        ("SM_Boat", "fishing boat", False),
        ("CeilingLight01", "light", True),
    ],
)
def test_a_name_is_matched_by_its_whole_head_noun(name, wanted, found):
    catalog = {"/Game/P/SM_X.SM_X": {"name": name}}
    requirements = read_requirements(bundle([entity(wanted)], predicate("existence", wanted)))
    (bound,) = bind(requirements, catalog).entities.values()
    assert bool(bound.assets) is found


@given(st.text(max_size=40))
def test_any_text_has_a_head(text):
    assert isinstance(head(text), tuple)


@pytest.mark.parametrize(
    ("wanted", "status"),
    [
        (("office chair",), "MATCH"),
        (("chairs",), "MATCH"),
        (("stool", "seat"), "UNKNOWN"),
        (("stool", "chair"), "MATCH"),
        (("furniture",), "UNKNOWN"),
        (("armchair",), "UNKNOWN"),
        (("fishing boat",), "MISMATCH"),
        (("label of a",), "UNKNOWN"),
    ],
)
def test_existence_by_name_alias_tag_but_tags_and_relatives_leave_it_open_and_labels_say_nothing(wanted, status):
    scene = [thing("a", "Office chair", (0, 0, 50))]
    found = decide(scene, [entity(*wanted)], predicate("existence", wanted[0]))
    assert found.status == status
    assert (found.actors == ["a"]) is (status == "MATCH")


def test_what_no_asset_is_may_be_made_up_of_others():
    """A pavilion of walls, a pier of crates: the catalog says nothing against it."""
    scene = [thing("a", "Stone wall", (0, 0, 50)), thing("b", "Stone wall", (200, 0, 50))]
    found = decide(scene, [entity("pavilion")], predicate("existence", "pavilion"))
    assert (found.status, found.actors) == ("UNKNOWN", [])
    absent = decide(scene, [entity("pavilion")], predicate("existence", "pavilion", negative=True))
    assert absent.status == "UNKNOWN"


def test_unknown_assets_and_primitives_leave_absence_open():
    for path in ("/Engine/BasicShapes/Cube.Cube", "/Game/Other/SM_Thing.SM_Thing"):
        assert (
            decide([thing("a", path, (0, 0, 0))], [entity("tower")], predicate("existence", "tower")).status
            == "UNKNOWN"
        )


def test_a_region_has_to_be_seen_and_an_empty_scene_holds_nothing():
    plaza = [entity("plaza", region=True)], predicate("existence", "plaza")
    assert decide([thing("a", "Desk", (0, 0, 0))], *plaza).status == "UNKNOWN"
    assert decide([], *plaza).status == "MISMATCH"


@pytest.mark.parametrize(
    ("quantity", "status"),
    [
        ({"mode": "exact", "value": 4}, "MATCH"),
        ({"mode": "exact", "value": 5}, "MISMATCH"),
        ({"mode": "approximately", "value": 5}, "MATCH"),
        ({"mode": "approximately", "value": 12}, "MISMATCH"),
        ({"mode": "at_least", "value": 4}, "MATCH"),
        ({"mode": "range", "lower": 5, "upper": 9}, "MISMATCH"),
        ({"mode": "qualitative", "qualitative": "several"}, "MATCH"),
        ({"mode": "qualitative", "qualitative": "dense"}, "UNKNOWN"),
    ],
)
def test_quantities(quantity, status):
    scene = [thing(f"c{i}", "Office chair", (i * 100, 0, 50)) for i in range(4)]
    found = decide(scene, [entity("chairs", collection=True)], predicate("quantity", "chairs", quantity=quantity))
    assert found.status == status


def test_approximately_a_dozen():
    assert limits({"mode": "approximately", "value": 12}) == (9, 15)
    assert limits({"mode": "approximately", "value": 2}) == (1, 3)


@pytest.mark.parametrize(
    ("kind", "words", "status"),
    [
        ("material", "wooden", "MATCH"),
        ("material", "metal", "MISMATCH"),
        ("color", "red", "MATCH"),
        ("color", "blue", "MISMATCH"),
        ("style", "baroque", "UNKNOWN"),
        ("material", "sandstone", "MISMATCH"),
    ],
)
def test_looks(kind, words, status):
    scene = [thing("a", "Office chair", (0, 0, 50))]
    qualifier = {"kind": kind, "name": words}
    found = decide(scene, [entity("chair")], predicate("attribute", "chair", qualifiers=[qualifier]))
    assert found.status == status


DESK = thing("desk", "Desk", (0, 0, 40), (100, 60, 40))


@pytest.mark.parametrize(
    ("relation", "centre", "status"),
    [
        ("on", (20, 0, 90), "MATCH"),
        ("on", (300, 0, 10), "MISMATCH"),
        ("above", (0, 0, 200), "MATCH"),
        ("next_to", (350, 0, 10), "MATCH"),
        ("near", (900, 0, 10), "UNKNOWN"),
        ("near", (2000, 0, 10), "MISMATCH"),
        ("under", (0, 0, 5), "MATCH"),
        ("apart_from", (900, 0, 10), "MATCH"),
        ("inside", (0, 0, 40), "MATCH"),
        ("against", (125, 0, 10), "MATCH"),
        ("linked_by", (0, 0, 90), "UNKNOWN"),
    ],
)
def test_relations(relation, centre, status):
    lamp = thing("lamp", "Table lamp", centre, (10, 10, 10))
    found = decide(
        [DESK, lamp], [entity("lamp"), entity("desk")], predicate("spatial_relation", "lamp", "desk", relation=relation)
    )
    assert found.status == status


def test_a_missing_partner_is_a_mismatch():
    found = decide(
        [DESK], [entity("lamp"), entity("desk")], predicate("spatial_relation", "lamp", "desk", relation="on")
    )
    assert found.status == "MISMATCH"


def test_a_collection_gets_the_share_that_satisfies():
    lamps = [thing(f"lamp{i}", "Table lamp", (i * 25 if i else 900, 0, 90), (10, 10, 10)) for i in range(4)]
    found = decide(
        [DESK, *lamps],
        [entity("lamps", "lamp", collection=True), entity("desk")],
        predicate("spatial_relation", "lamps", "desk", relation="on"),
    )
    assert (found.status, found.score, len(found.actors)) == ("MATCH", 0.75, 3)


def ring(n: int, radius: float) -> list[tuple[float, float, float]]:
    return [(radius * math.cos(2 * math.pi * i / n), radius * math.sin(2 * math.pi * i / n), 50) for i in range(n)]


def test_around_between_along_and_inside_a_ring():
    chairs = [thing(f"c{i}", "Office chair", place) for i, place in enumerate(ring(6, 300))]
    words = [entity("chairs", collection=True), entity("desk"), entity("walls", "wall", collection=True)]
    assert (
        decide([DESK, *chairs], words, predicate("spatial_relation", "chairs", "desk", relation="around")).status
        == "MATCH"
    )
    assert (
        decide([DESK, *chairs[:3]], words, predicate("spatial_relation", "chairs", "desk", relation="around")).status
        == "UNKNOWN"
    )
    far = [thing(f"c{i}", "Office chair", (3000 + 100 * i, 0, 50)) for i in range(4)]
    assert (
        decide([DESK, *far], words, predicate("spatial_relation", "chairs", "desk", relation="around")).status
        == "MISMATCH"
    )
    assert (
        decide([DESK, *chairs], words, predicate("spatial_relation", "desk", "chairs", relation="inside")).status
        == "MATCH"
    )
    walls = [thing(f"w{i}", "Stone wall", (x, 0, 50), (10, 400, 100)) for i, x in enumerate((-500, 500))]
    assert (
        decide([DESK, *walls], words, predicate("spatial_relation", "desk", "walls", relation="between")).status
        == "MATCH"
    )
    line = [thing(f"c{i}", "Office chair", (420, i * 150 - 300, 50), (30, 30, 50)) for i in range(4)]
    assert (
        decide([*walls, *line], words, predicate("spatial_relation", "chairs", "walls", relation="along")).status
        == "MATCH"
    )


@pytest.mark.parametrize(
    ("places", "words", "status"),
    [
        ([(i * 200, i, 50) for i in range(5)], "in a row", "MATCH"),
        (ring(6, 500), "row", "MISMATCH"),
        (ring(6, 500), "ring", "MATCH"),
        ([(i * 200, i, 50) for i in range(5)], "circle", "MISMATCH"),
        ([(i % 3 * 120, i // 3 * 110, 50) for i in range(9)], "clustered", "MATCH"),
        ([(i * 3000, i % 2 * 4000, 50) for i in range(6)], "clustered", "MISMATCH"),
        (
            [(0, 0, 50), (900, 300, 50), (400, 1000, 50), (1500, 1200, 50), (1300, 200, 50), (200, 1700, 50)],
            "scattered",
            "MATCH",
        ),
        (ring(6, 500), "layered", "UNKNOWN"),
        ([(0, 0, 50), (100, 0, 50)], "row", "UNKNOWN"),
    ],
)
def test_distributions(places, words, status):
    scene = [thing(f"c{i}", "Office chair", place) for i, place in enumerate(places)]
    found = decide(
        scene,
        [entity("chairs", collection=True)],
        predicate("distribution", "chairs", qualifiers=[{"kind": "layout", "name": words}]),
    )
    assert found.status == status


def test_logic_and_polarity():
    scene = [DESK]
    words = [entity("desk"), entity("lamp"), entity("plaza", region=True)]
    yes, no, open_ = predicate("existence", "desk"), predicate("existence", "lamp"), predicate("existence", "plaza")

    def logic(*operands):
        return predicate("logic", logic={"operator": "any_of", "requirement_ids": list(operands)})

    found = decide(
        scene,
        words,
        yes,
        no,
        open_,
        logic("p0", "p2"),
        logic("p1", "p2"),
        logic("p1"),
        predicate("existence", "lamp", negative=True),
        logic("p7"),
    )
    assert [d.status for d in found] == [
        "MATCH",
        "MISMATCH",
        "UNKNOWN",
        "MATCH",
        "UNKNOWN",
        "MISMATCH",
        "MATCH",
        "UNKNOWN",
    ]


def test_scene_wide_requirements_are_unknown():
    for kind in ("scene_identity", "environment", "style_bundle", "composition", "boundary"):
        assert decide([DESK], [entity("desk")], predicate(kind, "desk")).status == "UNKNOWN"


@pytest.mark.parametrize("path", [ALLEY, BAZAAR])
def test_published_bundles_are_read_and_decided(path):
    if not path.exists():
        pytest.skip("the published bundles are not on this machine")
    requirements = read_requirements(json.loads(path.read_text()))
    judge = StateDecider(requirements, {"actors": [DESK]}, CATALOG)
    decisions = [judge.decide(node) for node in requirements.scored]
    assert len(decisions) in (13, 42)
    assert all(d.status in ("MISMATCH", "UNKNOWN") for d in decisions)


EMPTY = {"prompt": "", "nodes": [], "edges": []}


@pytest.mark.parametrize(
    "broken", [{}, {"graph": {}}, {"graph": EMPTY}, [], {"graph": EMPTY, "requirements": [{"node_id": 1}]}]
)
def test_a_broken_bundle_is_one_line(broken):
    with pytest.raises(BadInput):
        read_requirements(broken)
