"""The parts of a published bundle that follow from an id, a quote and a type: ids, edges, rows."""

from __future__ import annotations

import re
from typing import Any

from cases.graphs.ir import IRRequirement
from cases.graphs.quotes import Quoted, places

POPULATION = "candidate_all"
"""The one population of the published bundles: all actors of a submission."""
SCENE = "requirement_scene"
"""Id of the requirement that is the whole scene."""


def predicate_type(row: IRRequirement) -> str:
    """The graph's word for a requirement type."""
    return "existence" if row.requirement_type == "presence" else row.requirement_type


def _slug(text: str) -> str:
    return re.sub(r"[^a-z0-9]+", "_", text.lower()).strip("_") or "x"


def free_name(name: str, taken: set[str]) -> str:
    """The name, or the first of ``name_2``, ``name_3`` that is free; it is taken then."""
    found, copies = name, 1
    while found in taken:
        copies += 1
        found = f"{name}_{copies}"
    taken.add(found)
    return found


def ids_of(prefix: str, named: list[tuple[str, str]], longest: int | None) -> dict[str, str]:
    """Ids by key: the prefix and the slug of the name, cut off at ``longest`` characters; repeats are numbered."""
    taken: set[str] = set()
    return {key: free_name(prefix + _slug(name)[:longest], taken) for key, name in named}


def occurrence_of(description: str, quote: Quoted) -> int:
    """Which occurrence of its words a quote is; 0 is the first."""
    starts = [place.start for place in places(description, quote.text)]
    return starts.index(quote.start) if quote.start in starts else description.count(quote.text, 0, quote.start)


def member_edge(identity: str, weight: float | None) -> dict[str, Any]:
    """The edge from the scene to a node: a scored facet with its weight, or mere support."""
    return {
        "edge_type": "requirement_member",
        "source_id": SCENE,
        "target_id": identity,
        "role": "support_only" if weight is None else "scored_facet",
        "weight_fraction": weight,
    }


def requirement_row(identity: str, quote: Quoted, about: dict[str, str]) -> dict[str, Any]:
    """A row of ``requirements``; ``about`` are its entity scopes."""
    return {
        "requirement_id": f"atomic_{identity}",
        "node_id": identity,
        "source_span": [quote.start, quote.end],
        "source_text": quote.text,
        "entity_scopes": about,
        "population_scope": POPULATION,
        "evidence_class": "open_ended",
        "primary_owner": "requirement_graph",
        "deterministic_rule_id": None,
        "status": "supported",
    }


def evaluation_row(identity: str, quote: Quoted, kind: str, about: dict[str, str]) -> dict[str, Any]:
    """A row of ``evaluations``."""
    return {
        "binding_id": f"evaluation_atomic_{identity}",
        "requirement_id": f"atomic_{identity}",
        "node_id": identity,
        "evaluator_id": "semantic_requirements.evidence_ladder",
        "evaluator_version": "1.0",
        "parameters": {"graph_node_kind": "predicate", "predicate_type": kind},
        "required_evidence": ["candidate_scene_graph", "requirement_graph", "evaluation_binding"],
        "entity_scopes": about,
        "population_scope": POPULATION,
        "source_provenance": {"kind": "text_span", "source_span": [quote.start, quote.end]},
    }
