"""Scope: what is scored, what only supports it, and over which actors each claim is decided."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from c4s.protocol.graph.report import GraphFinding
from c4s.protocol.graph.view import BundleView, Row

POPULATION = "candidate_all"
"""The one population of the published bundles: all actors of the submission."""
TOLERANCE = 1e-6
"""Of the sum of weights."""


def scope_faults(view: BundleView) -> Iterator[GraphFinding]:
    """Predicates that are scored twice or never, operands that are no support, scopes that are not the arguments."""
    yield from _members(view)
    yield from _operands(view)
    for row in (*view.requirements, *view.evaluations):
        yield from _population(view, row)


def _members(view: BundleView) -> Iterator[GraphFinding]:
    edges = [edge for edge in view.edges_of("requirement_member") if edge["target_id"] in view.predicates]
    facets = {edge["target_id"] for edge in edges if edge["role"] == "scored_facet"}
    for target, times in Counter(edge["target_id"] for edge in edges).items():
        if times > 1:
            yield _fault("scope.member", target, "the scene holds it twice")
    for identity in view.predicates:
        if (identity in facets) != (identity in view.scored):
            what = (
                "it is a scored facet without a requirement" if identity in facets else "it is scored, and is no facet"
            )
            yield _fault("scope.scored", identity, what)
    used = {operand for identity in view.predicates for operand in view.operands(identity)}
    for identity in view.predicates.keys() - facets - used:
        yield _fault("scope.member", identity, "nothing scores it: it is no facet and no part of one")
    yield from _weights([edge for edge in view.edges_of("requirement_member") if edge["role"] == "scored_facet"])
    for edge in view.edges_of("requirement_member"):
        if edge["role"] == "support_only" and edge.get("weight_fraction") is not None:
            yield _fault("scope.weight", edge["target_id"], "it only supports, and has a weight")
    total = sum(float(root["weight"]) for root in view.roots)
    if abs(total - 1) > TOLERANCE:
        yield _fault("scope.weight", "roots", f"their weights sum to {total:g}, not to 1")


def _weights(edges: list[Row]) -> Iterator[GraphFinding]:
    weights = {edge["target_id"]: edge.get("weight_fraction") for edge in edges}
    for target, weight in weights.items():
        if weight is None or weight <= 0:
            yield _fault("scope.weight", target, "it is scored without a weight above 0")
    total = sum(weight or 0.0 for weight in weights.values())
    if not weights:
        yield _fault("scope.weight", "graph", "nothing is scored")
    elif abs(total - 1) > TOLERANCE:
        yield _fault("scope.weight", "graph", f"the weights of its facets sum to {total:g}, not to 1")


def _operands(view: BundleView) -> Iterator[GraphFinding]:
    scoped: dict[str, list[str]] = {}
    for edge in view.edges_of("scope"):
        scoped.setdefault(edge["source_id"], []).append(edge["target_id"])
    for identity in view.predicates:
        operands = view.operands(identity)
        if sorted(operands) != sorted(scoped.get(identity, [])):
            yield _fault("scope.operands", identity, "its scope edges are not the parts that its logic names")
        for operand in operands:
            if operand not in view.predicates:
                yield _fault("scope.operands", identity, f"its logic names {operand!r}, which is no predicate")
            elif operand in view.scored:
                yield _fault("scope.operands", operand, f"it is scored, and again as a part of {identity!r}")


def _population(view: BundleView, row: Row) -> Iterator[GraphFinding]:
    if row["node_id"] not in view.predicates:
        return
    about = {entity for _, entity in view.named(row["node_id"])}
    if set(row["entity_scopes"]) != about:
        yield _fault("scope.entities", row["requirement_id"], "its entity scopes are not its predicate's arguments")
    populations = {*row["entity_scopes"].values(), row.get("population_scope")}
    for other in sorted(str(value) for value in populations - {None, POPULATION}):
        yield GraphFinding(
            "scope.population", "warning", row["requirement_id"], f"nobody knows the population {other!r}"
        )


def _fault(rule: str, place: str, message: str) -> GraphFinding:
    return GraphFinding(rule, "error", place, message)
