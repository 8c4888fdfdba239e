"""Search by meaning: labelled queries over the starter packs and the shared packs, with a floor."""

from __future__ import annotations

import fnmatch
import re
from pathlib import Path
from typing import Any

import pytest
import yaml

from c4s.records.pack import Asset, Pack
from c4s.toolbox.catalog import CaseCatalog, CatalogEntry
from catalog.build import starter_pack
from catalog.ingest.vocabulary import kind_of, readable, search_words
from catalog.shapes.spec import asset_id
from catalog.starter import STARTER
from tests.shared import SHARED
from tests.work import calls_in

QUERIES = yaml.safe_load((Path(__file__).parent / "meaning_queries.yaml").read_text())
FLOOR = {"starter": 0.85, "shared": 0.80}
AT = 5


def asset(name: str, title: str, category: str, description: str, tags: list[str]) -> Asset:
    return Asset(
        id=re.sub(r"\W", "_", asset_id(name)),
        name=title,
        category=category,
        tags=tags,
        path=f"/Game/T/SM_{name}.SM_{name}",
        description=description,
        bounds_min_cm=(0, 0, 0),
        bounds_max_cm=(1, 1, 1),
    )


def catalog_of(assets: list[Asset]) -> CaseCatalog:
    pack = Pack(pack_id="t", content_folder="T", title="T", license="-", assets=[])
    return CaseCatalog([CatalogEntry(one, pack, Path()) for one in assets])


def starter() -> CaseCatalog:
    return catalog_of(
        [
            asset(spec.name, readable(spec.name), spec.category, spec.description, list(spec.tags))
            for name in STARTER
            for spec in starter_pack(name).assets
        ]
    )


def shared() -> CaseCatalog:
    folder = SHARED / "assets/packs"
    if not folder.is_dir():
        pytest.skip("the shared packs are not on this machine")
    names = sorted({path.stem for path in folder.rglob("*") if path.suffix in (".gltf", ".glb", ".obj")})
    return catalog_of([asset(name, readable(name), kind_of(name) or "other", "", search_words(name)) for name in names])


def recall(catalog: CaseCatalog, queries: list[dict[str, Any]]) -> float:
    """Mean share of the answers (of five at most) that are among the first five results."""
    total = 0.0
    for query in queries:
        wanted = {
            one.id for one in catalog.assets if any(fnmatch.fnmatch(one.id, answer) for answer in query["answers"])
        }
        assert wanted, query["query"]
        found = {row["id"] for row in catalog.search(query["query"], limit=AT)}
        total += len(found & wanted) / min(AT, len(wanted))
    return total / len(queries)


@pytest.mark.parametrize("name", ["starter", "shared"])
def test_assets_are_found_by_meaning(name: str) -> None:
    queries = [query for query in QUERIES if query["catalog"] == name]
    assert len(queries) >= 25
    assert recall(starter() if name == "starter" else shared(), queries) >= FLOOR[name]


def test_plain_names_still_come_first() -> None:
    catalog = starter()
    firsts = {
        query: catalog.search(query)[0]["id"]
        for query in (
            "red chair",
            "oak tree",
            "street lamps",
            "Filing Cabinet",
            "OfficeSofa",
            "market stalls",
            "coffee machine",
        )
    }
    assert firsts == {
        "red chair": "child_chair",
        "oak tree": "oak_tree",
        "street lamps": "street_lamp",
        "Filing Cabinet": "filing_cabinet",
        "OfficeSofa": "office_sofa",
        "market stalls": firsts["market stalls"],
        "coffee machine": "coffee_machine",
    }
    assert firsts["market stalls"].startswith("market_stall")
    assert catalog.search("qqqq zzzz") == [] == catalog.search("the of it")


def test_a_search_among_five_thousand_assets_looks_only_at_what_fits() -> None:
    base = starter().assets
    catalog = catalog_of(
        [
            one.model_copy(
                update={"id": f"{one.id}_{n}", "name": f"{one.name} {n}", "path": f"/Game/T{n}/{one.id}.{one.id}"}
            )
            for n in range(25)
            for one in base
        ][:5000]
    )
    assert catalog.search("lamp")
    for query in (query["query"] for query in QUERIES):
        calls = calls_in(lambda query=query: catalog.search(query)).total()
        assert calls < 2 * len(catalog.ranked(query)) + 1000, query
