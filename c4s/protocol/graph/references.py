"""References: every id is there once, and every edge leads between nodes of the kinds that it joins."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from c4s.protocol.bundle import OBJECT_GROUNDINGS
from c4s.protocol.graph.report import GraphFinding
from c4s.protocol.graph.view import BundleView

ROLES = frozenset({"subject", "reference", "region", "collection", "member", "path", "scene", "scene_region"})
"""Roles of arguments that the published bundles use."""


def reference_faults(view: BundleView) -> Iterator[GraphFinding]:
    """Ids that are there twice or not at all, edges between the wrong kinds, predicates about nothing."""
    yield from _once(view)
    yield from _edges(view)
    yield from _arguments(view)
    yield from _unused(view)
    for root in view.roots:
        if root["requirement_id"] not in view.wholes:
            yield _fault("references.root", root["requirement_id"], "a root that is no requirement of the graph")
    for identity, entity in view.entities.items():
        for member in entity.get("member_ids") or ():
            if member not in view.entities:
                yield _fault("references.member", identity, f"it is made of {member!r}, which is no entity")
    for row in (*view.requirements, *view.evaluations):
        if row["node_id"] not in view.predicates:
            yield _fault(
                "references.row", row["requirement_id"], f"it scores {row['node_id']!r}, which is no predicate"
            )


def _once(view: BundleView) -> Iterator[GraphFinding]:
    for what, names in (
        ("node", [node["id"] for node in view.all_nodes]),
        ("requirement", [row["requirement_id"] for row in view.requirements]),
        ("evaluation", [row["binding_id"] for row in view.evaluations]),
    ):
        for name, times in Counter(names).items():
            if times > 1:
                yield _fault("references.id", name, f"{times} {what}s have this id")
    edges = Counter((e["edge_type"], e["source_id"], e["target_id"], e.get("role")) for e in view.edges)
    for (kind, source, target, _), times in edges.items():
        if times > 1:
            yield _fault("references.edge", source, f"{times} {kind} edges lead to {target!r}")


def _edges(view: BundleView) -> Iterator[GraphFinding]:
    joins = {
        "argument": (view.predicates, "predicate", view.entities, "entity"),
        "scope": (view.predicates, "predicate", view.predicates, "predicate"),
        "requirement_member": (
            view.wholes,
            "requirement",
            view.predicates.keys() | view.entities.keys(),
            "predicate or entity",
        ),
    }
    for edge in view.edges:
        sources, source_kind, targets, target_kind = joins[edge["edge_type"]]
        if edge["source_id"] not in sources:
            yield _fault("references.edge", edge["source_id"], f"a {edge['edge_type']} edge from no {source_kind}")
        if edge["target_id"] not in targets:
            yield _fault(
                "references.edge",
                edge["source_id"],
                f"its {edge['edge_type']} edge leads to {edge['target_id']!r}, which is no {target_kind}",
            )


def _arguments(view: BundleView) -> Iterator[GraphFinding]:
    for identity, predicate in view.predicates.items():
        rows = view.arguments.get(identity, [])
        if predicate["predicate_type"] == "logic":
            if rows:
                yield _fault("references.argument", identity, "a logic predicate has no arguments of its own")
            continue
        if not rows and not view.operands(identity):
            yield _fault("references.argument", identity, "it is about nothing: no argument edge leads from it")
        if len({row["ordinal"] for row in rows}) < len(rows):
            yield _fault("references.argument", identity, "two of its arguments have one ordinal")
        if predicate["predicate_type"] == "spatial_relation" and len(rows) < 2:
            yield _fault("references.argument", identity, "a spatial relation needs two arguments")
        for role in sorted({row["role"] for row in rows} - ROLES):
            yield GraphFinding("references.role", "warning", identity, f"nobody knows the role {role!r}")


def _unused(view: BundleView) -> Iterator[GraphFinding]:
    """Objects that no predicate asks about, alone, as a list or as its member: nothing would look for them."""
    near: dict[str, list[str]] = {}
    for identity, entity in view.entities.items():
        for member in entity.get("member_ids") or ():
            near.setdefault(identity, []).append(member)
            near.setdefault(member, []).append(identity)
    known: set[str] = set()
    stack = [edge["target_id"] for edge in view.edges_of("argument")]
    while stack:
        identity = stack.pop()
        if identity not in known:
            known.add(identity)
            stack += near.get(identity, [])
    for identity, entity in view.entities.items():
        if identity not in known and entity["grounding_mode"] in OBJECT_GROUNDINGS:
            yield _fault("references.unused", identity, "no predicate asks about this object")
        elif identity not in known:
            yield GraphFinding("references.unused", "warning", identity, "no predicate asks about this region")


def _fault(rule: str, place: str, message: str) -> GraphFinding:
    return GraphFinding(rule, "error", place, message)
