"""The requirement bundle (published format, schema 1.0): its one reader, and what everybody may rely on after it.

Case authoring writes through it, the importer copies through it, the judge decides what it returns. The requirement
graph alone (nodes and scope edges), which the published scorer reads without a bundle, is read here too.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from c4s.errors import BadInput

MAXIMUM_NODES = 10_000
MAXIMUM_EDGES = 100_000
MAXIMUM_PROMPT = 1_000_000
MAXIMUM_TEXT = 10_000
"""Characters of the prompt, and of any one text of a node."""
OBJECT_GROUNDINGS = ("actor", "actor_collection")
LOGIC_TYPES = ("logic", "set")


@dataclass(frozen=True)
class Entity:
    """A named object, region or surface of the prompt."""

    id: str
    names: tuple[str, ...]
    """Its name and its aliases."""
    kind: str
    grounding: str
    collection: bool
    members: tuple[str, ...] = ()
    """Entity ids that an or-list is made of; empty for anything else."""

    @property
    def is_object(self) -> bool:
        """Whether it is grounded in placed actors, not in a region that has to be seen."""
        return self.grounding in OBJECT_GROUNDINGS


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
        subjects = set(self.subjects)
        return [entity for _, entity in self.arguments if entity not in subjects]


@dataclass(frozen=True)
class Requirements:
    """A bundle's content."""

    prompt: str
    entities: Mapping[str, Entity]
    predicates: Mapping[str, Predicate]
    scored: tuple[str, ...]
    """Predicate ids that are requirements, in the bundle's order."""
    scopes: Mapping[str, Any]
    """Entity scopes of the requirements, by predicate id."""
    graph: Mapping[str, Any]


def read_requirements(bundle: Any, *, where: str = "") -> Requirements:
    """Read and check a bundle; ``BadInput`` when it is not one, or when it is too large to be one."""
    try:
        graph, rows = bundle["graph"], bundle["requirements"]
        nodes, edges, prompt = _list(graph["nodes"]), _list(graph["edges"]), str(graph["prompt"])
        _bounded("nodes", len(nodes), MAXIMUM_NODES)
        _bounded("requirements", len(_list(rows)), MAXIMUM_NODES)
        _bounded("edges", len(edges), MAXIMUM_EDGES)
        _bounded("characters of the prompt", len(prompt), MAXIMUM_PROMPT)
        entities = {_id(node["id"]): _entity(node) for node in nodes if node["node_type"] == "entity"}
        arguments: dict[str, list[tuple[int, str, str]]] = {}
        for edge in edges:
            if edge["edge_type"] == "argument":
                row = int(edge.get("ordinal") or 0), str(edge.get("role") or ""), _id(edge["target_id"])
                arguments.setdefault(_id(edge["source_id"]), []).append(row)
        predicates = {
            _id(node["id"]): _predicate(node, sorted(arguments.get(node["id"], []), key=lambda a: a[0]))
            for node in nodes
            if node["node_type"] == "predicate"
        }
        scored = tuple(_id(row["node_id"]) for row in rows)
        scopes = {row["node_id"]: row.get("entity_scopes") for row in rows}
    except (KeyError, TypeError, AttributeError, ValueError, OverflowError) as error:
        raise BadInput(
            f"this requirement bundle cannot be read: {type(error).__name__} {_short(str(error))}", where=where
        ) from None
    unknown = [_short(node) for node in scored if node not in predicates]
    if unknown:
        raise BadInput(f"this requirement bundle scores unknown predicates: {', '.join(unknown[:3])}", where=where)
    return Requirements(prompt, entities, predicates, scored, scopes, graph)


def _short(text: str) -> str:
    return text if len(text) <= 80 else text[:77] + "..."


def _bounded(what: str, found: int, most: int) -> None:
    if found > most:
        raise ValueError(f"it has {found} {what}, at most {most} are read")


def _list(value: Any) -> Sequence[Any]:
    if not isinstance(value, list | tuple):
        raise TypeError("a list is expected")
    return value


def _id(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError("an id must be a text")
    return value


def _text(value: Any) -> str:
    text = str(value)
    _bounded("characters in one text", len(text), MAXIMUM_TEXT)
    return text


def _entity(node: Mapping[str, Any]) -> Entity:
    return Entity(
        id=node["id"],
        names=tuple(_text(name) for name in (node["name"], *(_list(node.get("aliases") or ())))),
        kind=str(node.get("entity_type") or "object"),
        grounding=str(node.get("grounding_mode") or "actor"),
        collection=node.get("referent_kind") == "collection",
        members=tuple(_id(member) for member in _list(node.get("member_ids") or ())),
    )


def _predicate(node: Mapping[str, Any], arguments: list[tuple[int, str, str]]) -> Predicate:
    parameters = node.get("semantic_parameters") or {}
    logic = parameters.get("logic") or {}
    span, relation = node["source_span"], parameters.get("relation")
    return Predicate(
        id=node["id"],
        text=_text(node.get("text") or ""),
        span=(int(span["start"]), int(span["end"])),
        type=str(node["predicate_type"]),
        negative=node.get("polarity") == "negative",
        relation=None if relation is None else _text(relation),
        quantity=_quantity(parameters.get("quantity")),
        qualifiers=tuple((str(q["kind"]), _text(q["name"])) for q in parameters.get("qualifiers") or []),
        operator=logic.get("operator"),
        operands=tuple(_id(operand) for operand in logic.get("requirement_ids") or ()),
        arguments=tuple((role, entity) for _, role, entity in arguments),
    )


def _quantity(value: Any) -> Mapping[str, Any] | None:
    if not value:
        return None
    for name in ("value", "lower", "upper"):
        number = value.get(name)
        if number is not None and not math.isfinite(float(number)):
            raise ValueError(f"the {name} of a quantity must be a number")
    return dict(value)


def word(value: Any) -> str:
    """A name as it is compared: trimmed, case-folded."""
    return str(value).strip().casefold()


def graph_list(graph: Mapping[str, Any], name: str) -> Sequence[Any]:
    """A list of a requirement graph, empty when absent."""
    found = graph.get(name) or ()
    if not isinstance(found, (list, tuple)):
        raise BadInput(f"the graph's {name} must be a list")
    return found


def node_types(graph: Mapping[str, Any]) -> dict[str, str]:
    """Predicate type of each node that has one; other nodes are passed over."""
    return {
        str(node["id"]): word(node["predicate_type"])
        for node in graph_list(graph, "nodes")
        if isinstance(node, Mapping) and node.get("id") is not None and node.get("predicate_type") is not None
    }


def scope_edges(graph: Mapping[str, Any]) -> list[tuple[str, Any]]:
    """Scope edges as (parent, child); without those that name no parent."""
    edges = (edge for edge in graph_list(graph, "edges") if isinstance(edge, Mapping))
    return [
        (str(edge["source_id"]), edge.get("target_id"))
        for edge in edges
        if word(edge.get("edge_type", "")) == "scope" and edge.get("source_id") is not None
    ]
