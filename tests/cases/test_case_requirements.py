"""Requirement bundles: the published shape, grounded in the prompt to the character."""

from __future__ import annotations

from dataclasses import replace

import pytest

from c4s.errors import BadInput
from cases.model import TextCase
from cases.requirements import FAMILIES, PredicateSpec, bundle, families
from cases.starter.outdoor_texts import farm_text, harbour_text

TEXTS = [farm_text(), harbour_text()]


@pytest.mark.parametrize("case", TEXTS, ids=lambda case: case.case_id)
def test_every_span_equals_the_prompt_and_every_reference_resolves(case: TextCase) -> None:
    prompt = case.description + "\n\n=== ASSET PALETTE ===\nx"
    made = bundle(case.case_id, case.description, prompt, case.requirements)
    nodes = {node["id"]: node for node in made["graph"]["nodes"]}
    assert len(nodes) == len(made["graph"]["nodes"])
    for node in nodes.values():
        assert prompt[node["source_span"]["start"] : node["source_span"]["end"]] == node["text"]
        for qualifier in node.get("semantic_parameters", {}).get("qualifiers", []):
            span = qualifier["source_span"]
            assert prompt[span["start"] : span["end"]] == qualifier["source_text"]
    assert all(edge["source_id"] in nodes and edge["target_id"] in nodes for edge in made["graph"]["edges"])
    scored = [edge for edge in made["graph"]["edges"] if edge.get("role") == "scored_facet"]
    assert sum(edge["weight_fraction"] for edge in scored) == pytest.approx(1)
    assert [r["node_id"] for r in made["requirements"]] == [e["node_id"] for e in made["evaluations"]]
    assert {r["node_id"] for r in made["requirements"]} == {edge["target_id"] for edge in scored}


@pytest.mark.parametrize("case", TEXTS, ids=lambda case: case.case_id)
def test_starter_texts_ask_for_all_families_and_for_enough(case: TextCase) -> None:
    assert families(case.requirements) == set(FAMILIES.values())
    assert 40 <= len(case.requirements.predicates) <= 92


@pytest.mark.parametrize(
    ("wrong", "what"),
    [
        (PredicateSpec("existence", "x", "a purple submarine", "farm"), "does not hold"),
        (PredicateSpec("existence", "x", "poplars", "nobody"), "no entity"),
        (PredicateSpec("existence", "x", "poplars", "farm", reference="nobody"), "no entity"),
        (PredicateSpec("quantity", "x", "four cows", "cows"), "without a quantity"),
        (PredicateSpec("spatial_relation", "x", "poplars", "farm", "barn"), "without a relation"),
        (PredicateSpec("attribute", "x", "four cows", "cows", qualifiers=(("color", "blue"),)), "does not hold"),
    ],
)
def test_an_ungrounded_requirement_is_refused(wrong: PredicateSpec, what: str) -> None:
    case = farm_text()
    spec = replace(case.requirements, predicates=[*case.requirements.predicates, wrong])
    with pytest.raises(BadInput, match=what):
        bundle(case.case_id, case.description, case.description, spec)
