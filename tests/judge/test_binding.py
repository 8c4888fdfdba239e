"""Entities bound to assets: head nouns name, everything else proposes; on the starter texts and published palettes."""

from __future__ import annotations

import json
from collections.abc import Mapping
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.protocol.bundle import Entity, Requirements, read_requirements
from c4s.records.binding import Binding, ReviewedBindings, ReviewedEntity
from c4s.records.evidence import catalog_facts
from c4s.records.pack import MANIFEST, Pack
from c4s.semantics.binding import bind, binding_of
from cases.code4scene.tasks import palette, read_task
from cases.requirements import bundle
from cases.starter.suite import definition
from tests.built import built_packs
from tests.shared import SHARED

CHECKED = Path(__file__).parent / "bindings"
PUBLISHED = SHARED / "upstream/benchmark/public/text-to-scene"


def asking(*entities: Entity) -> Requirements:
    return Requirements("", {entity.id: entity for entity in entities}, {}, (), {}, {})


def named(*names: str, kind: str = "object", members: tuple[str, ...] = ()) -> Entity:
    return Entity("e", names, kind, "actor", False, members)


def bound(catalog: list[str] | Mapping[str, Any], *names: str, kind: str = "object") -> tuple[list[str], list[str]]:
    """What an entity of these names is, and what is proposed, of a catalog of names or of facts by name."""
    facts = {name: {"name": name, **(catalog[name] if isinstance(catalog, Mapping) else {})} for name in catalog}
    found = bind(asking(named(*names, kind=kind)), facts).entities["e"]
    return found.assets, [row.asset for row in found.proposed]


@pytest.mark.parametrize(
    ("asset", "wanted", "names"),
    [
        ("Chair Large 02", "chair", True),
        ("Table Lamp", "table", False),
        ("Table Lamp", "lamps", True),
        ("Barrel of apples", "barrels", True),
        ("Barrel of apples", "apple", False),
        ("Apple Barrel", "barrel of apples", True),
        ("Chest Of Drawers", "chest of drawers", True),
        ("Fishing Boat", "boats", True),
        ("Boat", "fishing boat", False),
        ("Sailing Boat", "fishing boat", False),
        ("Armchair", "chair", False),
        ("Street Light", "streetlights", True),
        ("Streetlight", "street light", True),
        ("Lighthouse", "house", False),
        ("Toy Train", "train", False),
        ("Toy Train", "toy train", True),
        ("Computer Tower", "towers", False),
        ("Window Wood 01a", "windows", True),
        ("Field Stone", "stones", True),
        ("Field Stone", "field", False),
        ("Wine Glass", "glass", True),
        ("Bookshelf", "bookshelves", True),
        ("Café Table", "cafe tables", True),
        ("Child's Bed", "child bed", True),
        ("Book Stack", "books", False),
        ("Stairway", "stairs", True),
        ("Tree Base", "trees", False),
        ("House 02 A", "a dozen small white houses", True),
        ("Tower", "minaret-like towers", False),
        ("Gate", "gate-like openings", False),
        ("Boat Rings", "broad irregular ring", False),
        ("Candle Cluster", "tight clusters", False),
        ("Row of cabbages", "cabbage row", True),
        ("Tree", "rows of trees", True),
        ("Bench", "chairs and benches", True),
        ("Candle Cluster", "central cluster", False),
        ("Candle Cluster", "candle clusters", True),
    ],
)
def test_a_head_noun_names(asset, wanted, names):
    assert bool(bound([asset], wanted)[0]) is names


@pytest.mark.parametrize(
    ("facts", "wanted"),
    [
        ({"tags": ["pens", "cup", "desk"]}, "oak desks"),
        ({"category": "desks"}, "desk"),
        ({"description": "Cup with pens, for a desk"}, "desks"),
    ],
)
def test_a_tag_a_category_or_a_description_only_proposes(facts, wanted):
    assert bound({"Pen Cup": facts}, wanted) == ([], ["Pen Cup"])


def test_related_and_misspelled_words_only_propose():
    assert bound(["House 01"], "buildings") == ([], ["House 01"])
    assert bound(["Waterffall"], "waterfalls") == ([], ["Waterffall"])
    assert bound(["Air conditioning 02"], "air conditioning units") == ([], ["Air conditioning 02"])


def test_the_described_asset_goes_first_and_another_colour_is_none():
    beds = ["Double Bed", "Child Bed"]
    assert bound(beds, "double bed") == (["Double Bed"], ["Child Bed"])
    assert bound(beds, "beds")[0] == beds
    assert bound(beds, "huge bed")[0] == beds
    assert bound(["Plastic Crate", "Crate"], "wooden crates") == (["Crate"], ["Plastic Crate"])
    assert bound({"Desk": {"description": "Desk with oak top"}, "Work Desk": {}}, "oak desk")[0] == ["Desk"]


def test_a_noun_that_stands_first_is_told_by_the_description_or_a_sibling():
    floor = {"Floor Kitchen": {"description": "Chequered kitchen floor tile, 2 x 2 m", "tags": ["kitchen", "floor"]}}
    assert bound(floor, "floor") == (["Floor Kitchen"], [])
    assert bound(floor, "kitchens")[0] == []
    assert bound(["Table Stone", "Table Wood"], "tables")[0] == ["Table Stone", "Table Wood"]
    assert bound({"House 3 United Homes": {"category": "house"}}, "houses")[0] == ["House 3 United Homes"]


def test_a_tile_is_what_it_is_of_where_a_surface_is_asked_for():
    assert bound(["Road Tile"], "road", kind="surface")[0] == ["Road Tile"]
    assert bound(["Roof Tile"], "roof") == ([], ["Roof Tile"])


def test_an_or_list_is_whatever_its_members_are():
    both = [Entity("a", ("well",), "object", "actor", False), Entity("b", ("kiosk",), "object", "actor", False)]
    asked = asking(*both, Entity("ab", ("x",), "object", "actor", True, ("a", "b")))
    catalog = {name: {"name": name} for name in ("Well", "Kiosk")}
    assert bind(asked, catalog).entities["ab"].assets == ["Well", "Kiosk"]


def test_an_author_adds_names_and_strikes_and_it_is_part_of_the_binding():
    catalog = {name: {"name": name} for name in ("Hut", "Wall", "Trim Wall", "Odd Thing")}
    plain = bind(asking(named("walls")), catalog)
    review = ReviewedBindings(entities={"e": ReviewedEntity(names=["hut"], add=["Odd Thing"], strike=["Trim Wall"])})
    reviewed = bind(asking(named("walls")), catalog, review)
    assert plain.entities["e"].assets == ["Wall", "Trim Wall"]
    assert reviewed.entities["e"].assets == ["Hut", "Wall", "Odd Thing"]
    assert reviewed.reviewed_sha256 == review.sha256()
    assert plain.sha256() != reviewed.sha256()


@pytest.mark.parametrize("wrong", [{"x": ReviewedEntity()}, {"e": ReviewedEntity(add=["/Game/No.No"])}])
def test_a_review_of_what_is_not_there_is_refused(wrong):
    with pytest.raises(BadInput, match="reviewed bindings name"):
        bind(asking(named("walls")), {"Wall": {"name": "Wall"}}, ReviewedBindings(entities=wrong))


def test_a_frozen_binding_is_checked_against_its_bundle_and_its_catalog(tmp_path):
    catalog = {"Wall": {"name": "Wall"}}
    asked = asking(named("walls"))
    bind(asked, catalog).write(tmp_path / "binding.json")
    frozen = json.loads((tmp_path / "binding.json").read_text())
    assert binding_of(asked, catalog, frozen) == Binding.read(tmp_path / "binding.json") == binding_of(asked, catalog)
    with pytest.raises(BadInput, match="another catalog"):
        binding_of(asked, {"Wall": {"name": "Fence"}}, frozen)
    other = Requirements("", asked.entities, {}, (), {}, {"prompt": "another"})
    with pytest.raises(BadInput, match="another requirement bundle"):
        binding_of(other, catalog, frozen)
    frozen["entities"]["e"]["assets"] = []
    with pytest.raises(BadInput, match="changed since"):
        binding_of(asked, catalog, frozen)


@settings(deadline=None)
@given(st.lists(st.text(max_size=30), max_size=6, unique=True), st.text(max_size=60), st.text(max_size=60))
def test_any_names_are_bound(names, wanted, description):
    catalog = {name: {"name": name, "description": description, "tags": [wanted]} for name in names}
    found = bind(asking(named(wanted)), catalog).entities["e"]
    assert {*found.assets, *(row.asset for row in found.proposed)} <= set(names)
    assert len({*found.assets}) + len({row.asset for row in found.proposed}) == len(found.assets) + len(found.proposed)


def tally(rows: list[tuple[set[str], set[str]]]) -> tuple[float, float]:
    """Precision and recall of (bound, right) sets."""
    hits = sum(len(found & right) for found, right in rows)
    return hits / sum(len(found) for found, _ in rows), hits / sum(len(right) for _, right in rows)


def test_the_starter_texts_are_bound_as_a_person_would(tmp_path_factory):
    checked = yaml.safe_load((CHECKED / "starter.yaml").read_text())
    scenes = {scene.scene_id: scene.packs for scene in definition().scenes}
    rows, wrong = [], []
    for case in definition().cases:
        if case.case_id not in checked:
            assert case.setting != "text-to-scene"
            continue
        packs = [Pack.read(built_packs(tmp_path_factory, name) / name / MANIFEST) for name in scenes[case.scene_id]]
        ids = {asset.path: asset.id for pack in packs for asset in pack.assets}
        asked = read_requirements(bundle(case.case_id, case.description, case.description, case.requirements))
        found = bind(asked, catalog_facts(packs)).entities
        assert set(found) == set(checked[case.case_id])
        for entity, right in checked[case.case_id].items():
            row = {ids[path] for path in found[entity].assets}, set(right)
            rows.append(row)
            wrong += [(case.case_id, entity, *row)] if row[0] != row[1] else []
    assert len(rows) == 122
    assert wrong == []


def test_published_palettes_are_bound_as_a_person_would():
    if not PUBLISHED.is_dir():
        pytest.skip("the published tasks are not here")
    rows, wrong = [], []
    for case, asked in yaml.safe_load((CHECKED / "published.yaml").read_text()).items():
        entries = palette(read_task(PUBLISHED / case / "task.yaml"))
        catalog = {entry.id: {"name": entry.name, "category": entry.category} for entry in entries}
        if case == "bazaar":
            entities = read_requirements(
                json.loads((PUBLISHED / case / "requirements/bazaar.bundle.json").read_text())
            ).entities
        else:
            entities = {name: Entity(name, (name,), "object", "actor_collection", True) for name in asked}
        found = bind(asking(*entities.values()), catalog).entities
        for entity, patterns in asked.items():
            right = {name for name in catalog for pattern in patterns if fnmatchcase(name, pattern)}
            row = set(found[entity].assets), right
            rows.append(row)
            wrong += [(case, entity, sorted(row[0] - right), sorted(right - row[0]))] if row[0] != right else []
    precision, recall = tally(rows)
    print(precision, recall, *wrong, sep="\n")
    assert precision >= 0.95
    assert recall >= 0.9
