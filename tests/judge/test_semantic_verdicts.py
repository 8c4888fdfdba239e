"""Detailed and Overview verdicts of the rule judge."""

from __future__ import annotations

import json
from typing import Any

import pytest

from c4s.errors import BadInput
from tests.judge.judged import verify_detailed, verify_overview
from tests.shared import SHARED

ALLEY = SHARED / "upstream/tests/fixtures/synthetic-alley.bundle.json"
BENCH, CART = "/Game/P/SM_Bench.SM_Bench", "/Game/P/SM_Cart.SM_Cart"
CATALOG = {
    BENCH: {"name": "Bench", "category": "seating", "tags": ["bench"], "description": "", "materials": []},
    CART: {"name": "Hand cart", "category": "vehicle", "tags": ["cart"], "description": "", "materials": []},
}
PROMPT = "Three benches stand in a row. A cart is near the benches."


def actor(name: str, asset: str, x: float, y: float = 0.0, scale: Any = (1, 1, 1)) -> dict[str, Any]:
    return {
        "name": name,
        "label": "Lighthouse",
        "class": "/Script/Engine.StaticMeshActor",
        "asset_path": asset,
        "component_asset_paths": [asset],
        "material_paths": [],
        "transform": {"location_cm": [x, y, 0], "rotation_deg": [0, 0, 0], "scale": list(scale)},
        "bounds": {"origin_cm": [x, y, 50], "extent_cm": [60, 30, 50]},
    }


def requirement(number: int, kind: str, text: str, *entities: str, **parameters: Any) -> tuple[dict, list[dict]]:
    start = PROMPT.index(text)
    node = {
        "node_type": "predicate",
        "id": f"p{number}",
        "predicate_type": kind,
        "text": text,
        "polarity": "affirmative",
        "source_span": {"start": start, "end": start + len(text)},
        "semantic_parameters": parameters,
    }
    return node, [
        {
            "edge_type": "argument",
            "source_id": f"p{number}",
            "target_id": entity,
            "ordinal": i,
            "role": "reference" if i else "subject",
        }
        for i, entity in enumerate(entities)
    ]


def bundle() -> dict[str, Any]:
    made = [
        requirement(0, "quantity", "Three benches", "benches", quantity={"mode": "exact", "value": 3}),
        requirement(
            1, "distribution", "benches stand in a row", "benches", qualifiers=[{"kind": "layout", "name": "row"}]
        ),
        requirement(2, "existence", "cart", "cart"),
        requirement(3, "spatial_relation", "near the benches", "cart", "benches", relation="near"),
    ]
    nodes: list[dict[str, Any]] = [
        {
            "node_type": "entity",
            "id": "benches",
            "name": "benches",
            "aliases": [],
            "grounding_mode": "actor_collection",
            "referent_kind": "collection",
        },
        {
            "node_type": "entity",
            "id": "cart",
            "name": "cart",
            "aliases": ["handcart"],
            "grounding_mode": "actor",
            "referent_kind": "individual",
        },
        *(node for node, _ in made),
    ]
    return {
        "graph": {"prompt": PROMPT, "nodes": nodes, "edges": [edge for _, edges in made for edge in edges]},
        "requirements": [{"node_id": node["id"], "entity_scopes": {}} for node, _ in made],
    }


GOOD = {"actors": [*(actor(f"bench{i}", BENCH, i * 200.0) for i in range(3)), actor("cart", CART, 200.0, 250.0)]}


def captures(snapshot: dict[str, Any], views: int = 4, pixels: int = 500) -> dict[str, Any]:
    visible = {a["name"]: pixels for a in snapshot["actors"]}
    return {
        "views": [{"name": f"v{i}", "visible": visible, "camera": {"width": 1280, "height": 720}} for i in range(views)]
    }


def test_a_scene_that_has_it_all_scores_one():
    verdict = verify_detailed(bundle(), GOOD, CATALOG, captures(GOOD))
    assert (verdict.status, verdict.score) == ("measured", 1.0)
    assert verdict.measurements["known_coverage"] == 1.0
    assert verdict.population == {"requirements": 4, "matched": 4, "mismatched": 0, "unresolved": 0, "active": 4}


def test_every_decision_shows_its_evidence():
    found = verify_detailed(bundle(), GOOD, CATALOG, captures(GOOD)).measurements["decisions"]
    assert found[0]["actors"] == ["bench0", "bench1", "bench2"]
    assert found[0]["measures"] == {"count": 3, "at_least": 3.0, "at_most": 3.0}
    assert found[0]["seen_actors"] == 3
    assert found[1]["measures"] == {"spread_share": 0.0}


def test_a_missing_object_costs_its_requirements_only():
    half = {"actors": GOOD["actors"][:3]}
    verdict = verify_detailed(bundle(), half, CATALOG, None)
    assert [d["status"] for d in verdict.measurements["decisions"]] == ["MATCH", "MATCH", "MISMATCH", "MISMATCH"]
    assert 0 < verdict.score < 1


def test_an_empty_scene_scores_zero_in_both():
    empty: dict[str, Any] = {"actors": []}
    assert verify_detailed(bundle(), empty, CATALOG, captures(empty)).score == 0.0
    overview = verify_overview(bundle(), empty, CATALOG, captures(empty))
    assert (overview.status, overview.score) == ("measured", 0.0)


def test_clutter_scores_low_and_names_do_not_help():
    junk = {"actors": [actor(f"a{i}", "/Engine/BasicShapes/Cube.Cube", i * 300.0) for i in range(9)]}
    detailed = verify_detailed(bundle(), junk, CATALOG, captures(junk))
    assert detailed.score == 0.0
    assert detailed.measurements["known_coverage"] == 0.0
    overview = verify_overview(bundle(), junk, CATALOG, captures(junk))
    assert overview.score < 0.3
    assert overview.measurements["dimensions"]["global_prompt_alignment"]["score"] == 0.0


def test_overview_parts_and_what_it_cannot_know():
    verdict = verify_overview(bundle(), GOOD, CATALOG, captures(GOOD))
    scores = {name: d["score"] for name, d in verdict.measurements["dimensions"].items()}
    assert scores["global_prompt_alignment"] == scores["composition_and_layout"] == 1.0
    assert scores["style_atmosphere_coherence"] == 0.5, "looks are unknown, the row is a row"
    assert "style_atmosphere_coherence.looks_as_asked" in verdict.measurements["unknown"]
    assert scores["completeness_and_polish"] == pytest.approx(2 / 3), "everything stands on a bare plate"
    assert verdict.measurements["structural_integrity_score"] == 1.0


def test_a_floor_or_a_landscape_carries_what_stands_on_it():
    floor = actor("floor", "/Engine/BasicShapes/Plane.Plane", 200.0, 200.0)
    floor["bounds"] = {"origin_cm": [200.0, 200.0, 0.0], "extent_cm": [5000.0, 5000.0, 1.0]}
    land = {**floor, "class": "/Script/Landscape.Landscape", "component_asset_paths": [], "asset_path": None}
    for ground in (floor, land):
        scene = {"actors": [*GOOD["actors"], ground]}
        parts = verify_overview(bundle(), scene, CATALOG, captures(scene)).measurements["dimensions"]
        told = {part["name"]: part["value"] for part in parts["completeness_and_polish"]["parts"]}
        assert told == {"object_counts": 1.0, "visible_things": 1.0, "on_a_floor": 1.0}


def test_unseen_objects_do_not_count_in_the_overview():
    verdict = verify_overview(bundle(), GOOD, CATALOG, captures(GOOD, pixels=3))
    assert verdict.score == 0.0


def test_stretched_things_lower_structural_integrity():
    bent = {"actors": [*GOOD["actors"][:3], actor("cart", CART, 200.0, 250.0, (1, 9, 1))]}
    verdict = verify_overview(bundle(), bent, CATALOG, captures(bent))
    assert verdict.measurements["structural_integrity_score"] == 0.75


@pytest.mark.parametrize("shown", [None, {}, {"views": []}, captures(GOOD, 3), {"views": [{"name": "a"}] * 4}])
def test_without_four_masked_views_the_overview_is_not_evaluated(shown):
    assert verify_overview(bundle(), GOOD, CATALOG, shown).status == "not_evaluated"


def test_a_bare_prompt_is_mostly_unknown():
    verdict = verify_overview(PROMPT, GOOD, CATALOG, captures(GOOD))
    assert verdict.score < 0.4
    assert "global_prompt_alignment.realised_objects" in verdict.measurements["unknown"]


@pytest.mark.parametrize("verify", [verify_detailed, verify_overview])
def test_it_is_deterministic_plain_json(verify):
    assert (
        verify(bundle(), GOOD, CATALOG, captures(GOOD)).sha256()
        == verify(bundle(), GOOD, CATALOG, captures(GOOD)).sha256()
    )


@pytest.mark.skipif(not ALLEY.exists(), reason="the published bundle is not on this machine")
def test_a_published_bundle():
    verdict = verify_detailed(json.loads(ALLEY.read_text()), GOOD, CATALOG, None)
    statuses = {d["text"]: d["status"] for d in verdict.measurements["decisions"]}
    assert (statuses["benches"], statuses["carts"], statuses["trash bins"]) == ("MATCH", "MATCH", "UNKNOWN")
    assert verdict.status == "measured"


def test_a_bundle_without_requirements_is_not_evaluated():
    empty = {"graph": {"prompt": "", "nodes": [], "edges": []}, "requirements": []}
    assert verify_detailed(empty, GOOD, CATALOG, None).status == "not_evaluated"
    with pytest.raises(BadInput):
        verify_detailed({"graph": 3}, GOOD, CATALOG, None)
