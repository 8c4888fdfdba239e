"""Reading a requirement bundle (published format, schema 1.0) into what the rule judge decides."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from c4s.errors import BadInput
from c4s.protocol.words import phrases_of


@dataclass(frozen=True)
class Entity:
    """A named object, region or surface of the prompt."""

    id: str
    phrases: tuple[tuple[str, ...], ...]
    kind: str
    grounding: str
    collection: bool

    @property
    def is_object(self) -> bool:
        """Whether it is grounded in placed actors, not in a region that has to be seen."""
        return self.grounding in ("actor", "actor_collection")


@dataclass(frozen=True)
class Predicate:
    """One predicate with its arguments by role."""

    id: str
    text: str
    span: tuple[int, int]
    type: str
    negative: bool
    relation: str | None
    quantity: Mapping[str, Any] | None
    qualifiers: tuple[tuple[str, str], ...]
    """(kind, words) pairs."""
    operator: str | None
    operands: tuple[str, ...]
    arguments: tuple[tuple[str, str], ...]
    """(role, entity id) pairs in order."""

    def argument(self, *roles: str) -> list[str]:
        """Entity ids in these roles."""
        return [entity for role, entity in self.arguments if role in roles]

    @property
    def subjects(self) -> list[str]:
        """What the predicate speaks of: its subjects, else its first argument."""
        return self.argument("subject", "collection", "member") or [e for _, e in self.arguments[:1]]

    @property
    def references(self) -> list[str]:
        """What the subjects stand in relation to."""
        subjects = self.subjects
        return [entity for _, entity in self.arguments if entity not in subjects]


@dataclass(frozen=True)
class Requirements:
    """A bundle's content."""

    prompt: str
    entities: Mapping[str, Entity]
    predicates: Mapping[str, Predicate]
    scored: tuple[str, ...]
    """Predicate ids that are requirements, in the bundle's order."""
    graph: Mapping[str, Any]


def read_requirements(bundle: Mapping[str, Any]) -> Requirements:
    """Parse a bundle; ``BadInput`` when it is not one."""
    try:
        graph = bundle["graph"]
        entities = {node["id"]: _entity(node) for node in graph["nodes"] if node["node_type"] == "entity"}
        arguments: dict[str, list[tuple[int, str, str]]] = {}
        for edge in graph["edges"]:
            if edge["edge_type"] == "argument":
                arguments.setdefault(edge["source_id"], []).append(
                    (int(edge.get("ordinal") or 0), str(edge.get("role") or ""), edge["target_id"])
                )
        predicates = {
            node["id"]: _predicate(node, sorted(arguments.get(node["id"], []), key=lambda a: a[0]))
            for node in graph["nodes"]
            if node["node_type"] == "predicate"
        }
        scored = tuple(requirement["node_id"] for requirement in bundle["requirements"])
        unknown = [node for node in scored if node not in predicates]
        prompt = str(graph["prompt"])
    except (KeyError, TypeError, AttributeError, ValueError) as error:
        raise BadInput(f"this requirement bundle cannot be read: {type(error).__name__} {error}") from None
    if unknown:
        raise BadInput(f"this requirement bundle scores unknown predicates: {', '.join(map(str, unknown[:3]))}")
    return Requirements(prompt, entities, predicates, scored, graph)


def _entity(node: Mapping[str, Any]) -> Entity:
    names = [str(node["name"]), *map(str, node.get("aliases") or [])]
    return Entity(
        node["id"],
        tuple(phrases_of(names)),
        str(node.get("entity_type") or "object"),
        str(node.get("grounding_mode") or "actor"),
        node.get("referent_kind") == "collection",
    )


def _predicate(node: Mapping[str, Any], arguments: list[tuple[int, str, str]]) -> Predicate:
    parameters = node.get("semantic_parameters") or {}
    logic = parameters.get("logic") or {}
    span = node["source_span"]
    return Predicate(
        id=node["id"],
        text=str(node.get("text") or ""),
        span=(int(span["start"]), int(span["end"])),
        type=str(node["predicate_type"]),
        negative=node.get("polarity") == "negative",
        relation=parameters.get("relation"),
        quantity=parameters.get("quantity"),
        qualifiers=tuple((str(q["kind"]), str(q["name"])) for q in parameters.get("qualifiers") or []),
        operator=logic.get("operator"),
        operands=tuple(logic.get("requirement_ids") or ()),
        arguments=tuple((role, entity) for _, role, entity in arguments),
    )
