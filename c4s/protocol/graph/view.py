"""A bundle whose fields are sound, as the rules look at it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeAlias

from c4s.protocol.graph.prompt import viewed_span

Row: TypeAlias = Mapping[str, Any]


def ends(span: Any) -> tuple[int, int]:
    """A span in either of its written forms."""
    return (span["start"], span["end"]) if isinstance(span, Mapping) else (span[0], span[1])


class BundleView:
    """Nodes, edges and rows of a bundle by what they are."""

    def __init__(self, bundle: Row) -> None:
        graph = bundle["graph"]
        self.bundle: Row = bundle
        self.prompt: str = graph["prompt"]
        self.roots: list[Row] = graph["roots"]
        self.all_nodes: list[Row] = graph["nodes"]
        self.nodes: dict[str, Row] = {node["id"]: node for node in self.all_nodes}
        self.entities = self._of_type("entity")
        self.predicates = self._of_type("predicate")
        self.wholes = self._of_type("requirement")
        self.edges: list[Row] = graph["edges"]
        self.requirements: list[Row] = bundle["requirements"]
        self.evaluations: list[Row] = bundle["evaluations"]
        self.provenance: Row = bundle["provenance"]
        self.review: Row = bundle["review"]
        self.view = viewed_span(self.prompt, self.provenance)
        self.arguments: dict[str, list[Row]] = {}
        for edge in self.edges_of("argument"):
            self.arguments.setdefault(edge["source_id"], []).append(edge)
        self.scored = {row["node_id"] for row in self.requirements}

    def _of_type(self, node_type: str) -> dict[str, Row]:
        return {node["id"]: node for node in self.all_nodes if node["node_type"] == node_type}

    def edges_of(self, edge_type: str) -> list[Row]:
        """Edges of a type, in order."""
        return [edge for edge in self.edges if edge["edge_type"] == edge_type]

    def parameters(self, predicate: str) -> Row:
        """A predicate's semantic parameters."""
        found: Row = self.predicates[predicate]["semantic_parameters"]
        return found

    def operands(self, predicate: str) -> list[str]:
        """What a logic predicate is made of; empty for any other."""
        logic = self.parameters(predicate)["logic"]
        return list(logic["requirement_ids"]) if logic else []

    def named(self, predicate: str) -> tuple[tuple[str, str], ...]:
        """(role, entity id) of a predicate's arguments, in order."""
        rows = sorted(self.arguments.get(predicate, []), key=lambda edge: int(edge["ordinal"]))
        return tuple((edge["role"], edge["target_id"]) for edge in rows)
