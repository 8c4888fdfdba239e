"""From the intermediate representation to the published bundle: offsets, ids, edges, scopes, weights."""

from __future__ import annotations

import copy
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import Any, TypeVar

from c4s.errors import BadInput
from c4s.files import digest_bytes
from c4s.protocol.graph.prompt import prompt_view
from c4s.protocol.graph.report import GraphFinding
from cases.graphs.ir import MOST_ROWS, IREntity, IRRequirement, SemanticIR
from cases.graphs.quotes import find_inside, find_quote
from cases.graphs.rows import (
    POPULATION,
    SCENE,
    evaluation_row,
    free_name,
    ids_of,
    member_edge,
    occurrence_of,
    predicate_type,
    requirement_row,
)

COMPILER, COMPILER_VERSION = "c4s-requirement-graph", "2"
IR_VERSION = "2.0"
WEIGHTS = "equal_atomic_top_level_requirements_v4"
"""As published: every requirement that is no part of another weighs the same."""
_Found = TypeVar("_Found")


class IRFaults(BadInput):
    """An intermediate representation that no graph can be made of. ``findings`` are all that is wrong with it."""

    def __init__(self, findings: list[GraphFinding]) -> None:
        first = findings[0]
        super().__init__(f"{first.place}: {first.message}")
        self.findings = findings


class Compiled:
    """A graph in the making: every quote found, every or-list expanded."""

    def __init__(self, prompt: str, ir: SemanticIR) -> None:
        self.prompt = prompt
        view = prompt_view(prompt)
        self.view: dict[str, Any] = view
        self.description = prompt[: view["source_span"][1]]
        self.faults: list[GraphFinding] = []
        self.actions: list[dict[str, Any]] = []
        self.entities = ir.entities
        self.entity_ids = ids_of("entity_", [(entity.key, entity.name) for entity in ir.entities], longest=None)
        self._unique("entity", [entity.key for entity in ir.entities])
        self._unique("requirement", [row.key for row in ir.requirements])
        self.entity_quotes = {
            entity.key: quote
            for entity in ir.entities
            if (
                quote := self._try(
                    entity.key, partial(find_quote, self.description, entity.source_text, entity.occurrence)
                )
            )
        }
        self._members()
        self.requirements = self._expanded(ir.requirements)
        if len(self.requirements) > MOST_ROWS:
            told = f"with every A or B spelled out it is {len(self.requirements)} long, at most {MOST_ROWS} are read"
            raise IRFaults([GraphFinding("ir.list", "error", "requirements", told)])
        self.ids = ids_of("predicate_", [(row.key, row.name) for row in self.requirements], longest=40)
        self.quotes = {
            row.key: quote
            for row in self.requirements
            if (quote := self._try(row.key, partial(find_quote, self.description, row.source_text, row.occurrence)))
        }
        self._references()
        self.qualifiers = {row.key: self._qualified(row) for row in self.requirements if row.key in self.quotes}
        if self.faults:
            raise IRFaults(self.faults)
        operands = {key for row in self.requirements if row.logic for key in row.logic.requirement_keys}
        self.scored = [row for row in self.requirements if row.key not in operands]

    def _try(self, place: str, find: Callable[[], _Found]) -> _Found | None:
        try:
            return find()
        except BadInput as error:
            self._fault("ir.quote", place, error.what)
            return None

    def _fault(self, rule: str, place: str, message: str) -> None:
        self.faults.append(GraphFinding(rule, "error", place, message))

    def _unique(self, what: str, keys: list[str]) -> None:
        for key, times in Counter(keys).items():
            if times > 1:
                self._fault("ir.key", key, f"{times} of the {what} keys are the same")

    def _members(self) -> None:
        for entity in self.entities:
            for member in entity.member_keys:
                if member not in self.entity_ids:
                    self._fault("ir.key", entity.key, f"its member {member!r} is no entity")
            if (entity.list_mode == "or") != (len(entity.member_keys) > 1):
                self._fault("ir.list", entity.key, "an or-list, and nothing else, has two or more members")

    def _references(self) -> None:
        keys = {row.key for row in self.requirements}
        for row in self.requirements:
            for argument in row.arguments:
                if argument.entity_key not in self.entity_ids:
                    self._fault("ir.key", row.key, f"its argument {argument.entity_key!r} is no entity")
            for key in row.logic.requirement_keys if row.logic else ():
                if key not in keys:
                    self._fault("ir.key", row.key, f"its logic names {key!r}, which is no requirement")

    def _expanded(self, rows: Iterable[IRRequirement]) -> list[IRRequirement]:
        """A requirement whose own words hold the or-list that it is about becomes any of one a member."""
        lists = {entity.key: entity for entity in self.entities if entity.list_mode == "or"}
        taken = {row.key for row in rows}
        made: list[IRRequirement] = []
        for row in rows:
            about = next((lists[a.entity_key] for a in row.arguments if a.entity_key in lists), None)
            if about is None or row.requirement_type == "logic" or about.source_text not in row.source_text:
                made.append(row)
                continue
            parts = []
            for member in about.member_keys:
                key = free_name(f"{row.key}_{member}", taken)
                arguments = [
                    argument.model_copy(update={"entity_key": member}) if argument.entity_key == about.key else argument
                    for argument in row.arguments
                ]
                parts.append(row.model_copy(update={"key": key, "arguments": arguments, "polarity": "affirmative"}))
            logic = {"operator": "any_of", "requirement_keys": [part.key for part in parts]}
            whole: dict[str, Any] = {
                "requirement_type": "logic",
                "arguments": [],
                "qualifiers": [],
                "quantity": None,
                "relation": None,
            }
            made.append(IRRequirement.model_validate({**row.plain(), **whole, "logic": logic}))
            made += parts
            self.actions.append(
                {"action": "disjunction_expanded", "requirement_key": row.key, "operand_count": len(parts)}
            )
        return made

    def _qualified(self, row: IRRequirement) -> list[dict[str, Any]]:
        made = []
        for qualifier in row.qualifiers:
            quote = self._try(
                row.key, partial(find_inside, self.description, qualifier.source_text, self.quotes[row.key])
            )
            if quote is not None:
                made.append(
                    {
                        "kind": qualifier.kind,
                        "name": quote.text,
                        "source_text": quote.text,
                        "source_span": quote.span,
                        "occurrence": occurrence_of(self.description, quote),
                    }
                )
        return made

    def entity_node(self, entity: IREntity) -> dict[str, Any]:
        """An entity's node."""
        quote = self.entity_quotes[entity.key]
        node = {
            "node_type": "entity",
            "id": self.entity_ids[entity.key],
            "name": entity.name,
            "text": quote.text,
            "source_span": quote.span,
            "aliases": list(entity.aliases),
            "entity_type": entity.entity_type,
            "grounding_mode": entity.grounding_mode,
            "referent_kind": entity.referent_kind,
            "evaluation_route": "stage2_visual",
        }
        members = [self.entity_ids[member] for member in entity.member_keys]
        return {**node, "member_ids": members} if members else node

    def predicate_node(self, row: IRRequirement, number: int) -> dict[str, Any]:
        """A requirement's node; ``number`` counts from 1."""
        quote = self.quotes[row.key]
        logic = row.logic and {
            "operator": row.logic.operator,
            "requirement_ids": [self.ids[key] for key in row.logic.requirement_keys],
        }
        return {
            "node_type": "predicate",
            "id": self.ids[row.key],
            "name": row.name,
            "text": quote.text,
            "source_span": quote.span,
            "polarity": row.polarity,
            "constraint": None,
            "predicate_type": predicate_type(row),
            "semantic_parameters": {
                "ir_key": f"r{number}",
                "stage0_ir_version": IR_VERSION,
                "requirement_type": row.requirement_type,
                "relation": row.relation,
                "quantity": None if row.quantity is None else {**row.quantity.plain(), "unit": None},
                "qualifiers": self.qualifiers[row.key],
                "logic": logic,
                "scope": None,
            },
        }

    def edges(self) -> list[dict[str, Any]]:
        """Arguments, logic scopes, and what the scene is made of."""
        made: list[dict[str, Any]] = []
        for row in self.requirements:
            made += [
                {
                    "edge_type": "argument",
                    "source_id": self.ids[row.key],
                    "target_id": self.entity_ids[argument.entity_key],
                    "ordinal": ordinal,
                    "role": argument.role,
                }
                for ordinal, argument in enumerate(row.arguments)
            ]
        for row in self.requirements:
            made += [
                {"edge_type": "scope", "source_id": self.ids[row.key], "target_id": self.ids[key]}
                for key in (row.logic.requirement_keys if row.logic else ())
            ]
        scored = {row.key for row in self.scored}
        for row in self.requirements:
            made.append(member_edge(self.ids[row.key], 1.0 / len(scored) if row.key in scored else None))
        return [*made, *(member_edge(self.entity_ids[entity.key], None) for entity in self.entities)]

    def route(self, parser: str) -> dict[str, Any]:
        """The published account of what kinds of requirement there are, and by which way they came."""
        kinds = Counter(row.requirement_type for row in self.scored)
        return {
            "clause_id": "full_prompt",
            "route": "llm_semantic_draft_full_prompt" if parser.startswith("llm") else parser,
            "capability_audit": {
                "by_semantic_type": {kind: {"supported": n, "unplanned": 0} for kind, n in sorted(kinds.items())},
                "requirement_count": len(self.scored),
                "supported_count": len(self.scored),
                "unplanned_count": 0,
            },
        }

    def plain_ir(self) -> dict[str, Any]:
        """The intermediate representation as it was compiled, with the spans that were found."""
        keys = {entity.key: f"e{number}" for number, entity in enumerate(self.entities, 1)}
        rows = {row.key: f"r{number}" for number, row in enumerate(self.requirements, 1)}
        requirements = []
        for row in self.requirements:
            plain, quote = row.plain(), self.quotes[row.key]
            requirements.append(
                plain
                | {"key": rows[row.key], "source_text": quote.text, "source_span": quote.span, "scope": None}
                | {"qualifiers": self.qualifiers[row.key]}
                | {
                    "arguments": [
                        {"entity_key": keys[argument.entity_key], "ordinal": ordinal, "role": argument.role}
                        for ordinal, argument in enumerate(row.arguments)
                    ],
                    "logic": row.logic
                    and {
                        "operator": row.logic.operator,
                        "requirement_keys": [rows[key] for key in row.logic.requirement_keys],
                    },
                }
            )
        return {
            "draft_version": IR_VERSION,
            "entities": [
                entity.plain()
                | {
                    "key": keys[entity.key],
                    "source_text": self.entity_quotes[entity.key].text,
                    "source_span": self.entity_quotes[entity.key].span,
                    "member_keys": [keys[member] for member in entity.member_keys],
                }
                for entity in self.entities
            ],
            "requirements": requirements,
            "normalization_actions": self.actions,
            "weight_policy": WEIGHTS,
        }

    def rows(self) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
        """The requirements and their evaluations, one each a scored requirement."""
        requirements, evaluations = [], []
        for row in self.scored:
            identity, quote = self.ids[row.key], self.quotes[row.key]
            about = {self.entity_ids[argument.entity_key]: POPULATION for argument in row.arguments}
            requirements.append(requirement_row(identity, quote, about))
            evaluations.append(evaluation_row(identity, quote, predicate_type(row), about))
        return requirements, evaluations


def compile_bundle(
    case_id: str, prompt: str, ir: SemanticIR, provenance: Mapping[str, Any], review: Mapping[str, Any]
) -> dict[str, Any]:
    """The bundle of a prompt; ``IRFaults`` tells all that keeps it from being one. It is not validated here.

    ``provenance`` and ``review`` are laid over what the compiler itself says.
    """
    made = Compiled(prompt, ir)
    requirements, evaluations = made.rows()
    end = len(made.description)
    sha256 = digest_bytes(prompt.encode())
    return {
        "schema_version": "1.0",
        "task_mode": "generation",
        "bundle_id": f"semantic_{case_id}_{sha256[:12]}",
        "graph": {
            "schema_version": "2.0",
            "prompt": prompt,
            "nodes": [
                *(made.entity_node(entity) for entity in made.entities),
                *(made.predicate_node(row, number) for number, row in enumerate(made.requirements, 1)),
                {
                    "node_type": "requirement",
                    "id": SCENE,
                    "aggregation": "weighted_sum",
                    "text": made.description,
                    "source_span": {"start": 0, "end": end},
                },
            ],
            "edges": made.edges(),
            "roots": [{"requirement_id": SCENE, "weight": 1.0}],
        },
        "requirements": requirements,
        "evaluations": evaluations,
        "provenance": {
            "prompt_sha256": sha256,
            "semantic_prompt_view": made.view,
            "compiler_name": COMPILER,
            "compiler_version": COMPILER_VERSION,
            "clause_routes": [made.route(str(provenance.get("authoring_parser")))],
            "stage0_semantic_ir": made.plain_ir(),
            **provenance,
        },
        "review": copy.deepcopy(dict(review)),
    }
