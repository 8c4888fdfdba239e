"""Requirement bundles: from a compact authored list to the published bundle format (``schema_version`` 1.0).

An author names entities and predicates by the very words of the prompt; the spans are found here, and everything is
validated: a bundle whose words are not in its prompt, whose references do not resolve, or that the reader of bundles
refuses is never written.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, get_args

from c4s.errors import BadInput
from c4s.files import digest_bytes
from c4s.protocol.bundle import read_requirements
from c4s.protocol.rules import FAMILY_OF_TYPE, Family

PredicateType = Literal[
    "scene_identity",
    "environment",
    "existence",
    "quantity",
    "attribute",
    "material",
    "spatial_relation",
    "distribution",
    "composition",
]
FAMILIES: dict[str, Family] = {kind: FAMILY_OF_TYPE[kind] for kind in get_args(PredicateType)}
"""Family of each predicate type that can be authored."""
COMPILER = "c4s-authored-requirements"
COMPILER_VERSION = "1"


@dataclass(frozen=True)
class EntitySpec:
    """Something the prompt speaks of. ``text`` are its words in the prompt; ``aliases`` are other names for it."""

    key: str
    text: str
    aliases: tuple[str, ...] = ()
    entity_type: Literal["object", "region", "surface"] = "object"
    collection: bool = False
    occurrence: int = 0
    """Which occurrence of the words in the prompt (0 is the first)."""


@dataclass(frozen=True)
class Quantity:
    """How many: ``exact``, ``approximately``, ``at_least``, ``range`` or ``qualitative`` (several, few, dense)."""

    mode: Literal["exact", "approximately", "at_least", "range", "qualitative"]
    value: float | None = None
    lower: float | None = None
    upper: float | None = None
    qualitative: str | None = None


@dataclass(frozen=True)
class PredicateSpec:
    """One scored requirement about ``subject`` (an entity key), grounded in the prompt's words ``text``.

    ``relation`` and ``reference`` say what it stands in relation to; ``qualifiers`` are (kind, word) pairs such as
    ``("color", "red")`` whose words occur in ``text``.
    """

    type: PredicateType
    name: str
    text: str
    subject: str
    reference: str | None = None
    relation: str | None = None
    quantity: Quantity | None = None
    qualifiers: tuple[tuple[str, str], ...] = ()
    occurrence: int = 0


@dataclass(frozen=True)
class RequirementSpec:
    """The authored requirements of one prompt."""

    entities: Sequence[EntitySpec]
    predicates: Sequence[PredicateSpec]
    author: str = field(default="c4s starter suite")


def span_of(prompt: str, text: str, occurrence: int = 0, *, where: str = "") -> tuple[int, int]:
    """Character span (end exclusive) of the given occurrence of ``text``; ``BadInput`` when it is not there."""
    start = -1
    for _ in range(occurrence + 1):
        start = prompt.find(text, start + 1)
        if start < 0:
            raise BadInput(f"the prompt does not hold {text!r} (occurrence {occurrence})", where=where)
    return start, start + len(text)


def _slug(text: str) -> str:
    return re.sub(r"[^a-z0-9]+", "_", text.lower()).strip("_")


def _span(span: tuple[int, int]) -> dict[str, int]:
    return {"start": span[0], "end": span[1]}


def bundle(case_id: str, description: str, prompt: str, spec: RequirementSpec) -> dict[str, Any]:
    """The requirement bundle of a prompt that starts with ``description``. ``BadInput`` when the spec is wrong."""
    _validate(case_id, description, prompt, spec)
    entity_ids = {entity.key: f"entity_{_slug(entity.key)}" for entity in spec.entities}
    nodes = [_entity_node(entity, entity_ids[entity.key], description) for entity in spec.entities]
    edges: list[dict[str, Any]] = []
    requirements, evaluations, used = [], [], set[str]()
    for number, predicate in enumerate(spec.predicates, start=1):
        identity = base = "predicate_" + _slug(predicate.name)[:40]
        copies = 1
        while identity in used:
            copies += 1
            identity = f"{base}_{copies}"
        used.add(identity)
        span = span_of(description, predicate.text, predicate.occurrence)
        nodes.append(_predicate_node(predicate, identity, number, span))
        scope = {}
        for ordinal, (role, key) in enumerate((("subject", predicate.subject), ("reference", predicate.reference))):
            if key is not None:
                edges.append(
                    {
                        "edge_type": "argument",
                        "source_id": identity,
                        "target_id": entity_ids[key],
                        "ordinal": ordinal,
                        "role": role,
                    }
                )
                scope[entity_ids[key]] = "candidate_all"
        edges.append(
            {
                "edge_type": "requirement_member",
                "source_id": "requirement_scene",
                "target_id": identity,
                "role": "scored_facet",
                "weight_fraction": 1.0 / len(spec.predicates),
            }
        )
        requirements.append(_requirement(identity, span, predicate.text, scope))
        evaluations.append(_evaluation(identity, span, predicate.type, scope))
    edges += [
        {
            "edge_type": "requirement_member",
            "source_id": "requirement_scene",
            "target_id": entity_id,
            "role": "support_only",
            "weight_fraction": None,
        }
        for entity_id in entity_ids.values()
    ]
    nodes.append(
        {
            "node_type": "requirement",
            "id": "requirement_scene",
            "aggregation": "weighted_sum",
            "text": description,
            "source_span": _span((0, len(description))),
        }
    )
    sha256 = digest_bytes(prompt.encode())
    made = {
        "schema_version": "1.0",
        "task_mode": "generation",
        "bundle_id": f"semantic_{case_id}_{sha256[:12]}",
        "graph": {
            "schema_version": "2.0",
            "prompt": prompt,
            "nodes": nodes,
            "edges": edges,
            "roots": [{"requirement_id": "requirement_scene", "weight": 1.0}],
        },
        "requirements": requirements,
        "evaluations": evaluations,
        "provenance": {
            "prompt_sha256": sha256,
            "authoring_parser": "authored",
            "authoring_client": {"client": spec.author},
            "compiler_name": COMPILER,
            "compiler_version": COMPILER_VERSION,
            "semantic_prompt_view": {
                "kind": "prefix_before_asset_palette",
                "source_span": [0, len(description)],
                "excluded_suffix": [len(description), len(prompt)],
            },
        },
        "review": {
            "approved": True,
            "human_reviewed": False,
            "review_method": "automated_policy",
            "reviewer": f"{COMPILER}:{COMPILER_VERSION}",
            "policy_name": "authored-and-validated",
            "policy_version": "1",
            "basis": ["every_span_equals_the_prompt", "every_reference_resolves"],
        },
    }
    read_requirements(made, where=case_id)
    return made


def families(spec: RequirementSpec) -> set[Family]:
    """The families that a spec asks for."""
    return {FAMILIES[predicate.type] for predicate in spec.predicates}


def _validate(case_id: str, description: str, prompt: str, spec: RequirementSpec) -> None:
    if not prompt.startswith(description):
        raise BadInput("the prompt does not start with its description", where=case_id)
    if not spec.predicates:
        raise BadInput("a text case needs requirements", where=case_id)
    keys = [entity.key for entity in spec.entities]
    if len(set(map(_slug, keys))) != len(keys):
        raise BadInput("two entities have one key", where=case_id)
    for entity in spec.entities:
        span_of(description, entity.text, entity.occurrence, where=f"{case_id} entity {entity.key}")
    for predicate in spec.predicates:
        where = f"{case_id} predicate {predicate.name!r}"
        span_of(description, predicate.text, predicate.occurrence, where=where)
        for key in (predicate.subject, predicate.reference):
            if key is not None and key not in keys:
                raise BadInput(f"no entity {key!r}", where=where)
        if predicate.type == "quantity" and predicate.quantity is None:
            raise BadInput("a quantity predicate without a quantity", where=where)
        if predicate.type == "spatial_relation" and predicate.relation is None:
            raise BadInput("a spatial relation without a relation", where=where)
        for _, word in predicate.qualifiers:
            span_of(predicate.text, word, where=where)


def _entity_node(entity: EntitySpec, identity: str, description: str) -> dict[str, Any]:
    span = span_of(description, entity.text, entity.occurrence)
    grounding = {
        "object": "actor_collection" if entity.collection else "actor",
        "region": "derived_region",
        "surface": "actor_collection",
    }[entity.entity_type]
    return {
        "node_type": "entity",
        "id": identity,
        "name": entity.key,
        "text": entity.text,
        "source_span": _span(span),
        "aliases": list(entity.aliases),
        "entity_type": entity.entity_type,
        "grounding_mode": grounding,
        "referent_kind": "collection" if entity.collection else "individual",
        "evaluation_route": "stage2_visual",
    }


def _predicate_node(predicate: PredicateSpec, identity: str, number: int, span: tuple[int, int]) -> dict[str, Any]:
    qualifiers = []
    for kind, word in predicate.qualifiers:
        start = span[0] + predicate.text.find(word)
        qualifiers.append(
            {
                "kind": kind,
                "name": word,
                "source_text": word,
                "occurrence": 0,
                "source_span": _span((start, start + len(word))),
            }
        )
    quantity = predicate.quantity
    return {
        "node_type": "predicate",
        "id": identity,
        "name": predicate.name,
        "text": predicate.text,
        "source_span": _span(span),
        "polarity": "affirmative",
        "constraint": None,
        "predicate_type": predicate.type,
        "semantic_parameters": {
            "ir_key": f"r{number}",
            "stage0_ir_version": "2.0",
            "relation": predicate.relation,
            "logic": None,
            "scope": None,
            "requirement_type": "presence" if predicate.type == "existence" else predicate.type,
            "quantity": None
            if quantity is None
            else {
                "mode": quantity.mode,
                "value": quantity.value,
                "lower": quantity.lower,
                "upper": quantity.upper,
                "qualitative": quantity.qualitative,
                "unit": None,
            },
            "qualifiers": qualifiers,
        },
    }


def _requirement(identity: str, span: tuple[int, int], text: str, scope: dict[str, str]) -> dict[str, Any]:
    return {
        "requirement_id": f"atomic_{identity}",
        "node_id": identity,
        "source_span": list(span),
        "source_text": text,
        "entity_scopes": scope,
        "population_scope": "candidate_all",
        "evidence_class": "open_ended",
        "primary_owner": "requirement_graph",
        "deterministic_rule_id": None,
        "status": "supported",
    }


def _evaluation(identity: str, span: tuple[int, int], kind: str, scope: dict[str, str]) -> dict[str, Any]:
    return {
        "binding_id": f"evaluation_atomic_{identity}",
        "requirement_id": f"atomic_{identity}",
        "node_id": identity,
        "evaluator_id": "semantic_requirements.evidence_ladder",
        "evaluator_version": "1.0",
        "parameters": {"graph_node_kind": "predicate", "predicate_type": kind},
        "required_evidence": ["candidate_scene_graph", "requirement_graph", "evaluation_binding"],
        "entity_scopes": scope,
        "population_scope": "candidate_all",
        "source_provenance": {"kind": "text_span", "source_span": list(span)},
    }
