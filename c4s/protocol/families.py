"""Which family a requirement belongs to: by what is attached to it, by its type, by the requirement graph (scorer
fact 5)."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Any

from c4s.errors import BadInput
from c4s.protocol.bundle import node_types, scope_edges, word
from c4s.protocol.numbers import records
from c4s.protocol.rules import FAMILY_OF_TYPE, FAMILY_WEIGHTS, Family


def predicate_type(requirement: Mapping[str, Any]) -> str:
    """The requirement's type in lower case; ``presence`` is ``existence``, none is ``unknown``."""
    kind = requirement.get("predicate_type")
    if kind is None:
        kind = section(section(requirement, "evaluation_binding"), "parameters").get("predicate_type")
    text = word(kind or "unknown")
    return "existence" if text == "presence" else text


def section(value: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    """A part of a record, empty when it is no object."""
    found = value.get(name)
    return found if isinstance(found, Mapping) else {}


def family_of(requirement: Mapping[str, Any]) -> Family | None:
    """Family of a requirement: the one attached to it, else by its type; None when the type has none.

    Raises ``BadInput`` when an unknown family is attached.
    """
    attached = requirement.get("semantic_family")
    if attached is None:
        return FAMILY_OF_TYPE.get(predicate_type(requirement))
    for family in FAMILY_WEIGHTS:
        if word(attached) == family:
            return family
    raise BadInput(f"unknown semantic family {attached!r}", todo=f"one of {', '.join(FAMILY_WEIGHTS)}")


def node_name(requirement: Mapping[str, Any], number: int) -> str:
    """Name of a requirement: its node, else its own id, else its place in the list."""
    return str(
        requirement.get("node_id")
        or requirement.get("requirement_id")
        or requirement.get("id")
        or f"requirement_{number}"
    )


def families_from_graph(graph: Mapping[str, Any]) -> dict[str, Family]:
    """Family of each predicate node. A logic node has one only if all families in its scope are one.

    The scope is followed through logic nodes only; nodes of a type without a family say nothing, nor does a node that
    is met again below itself.
    """
    types = node_types(graph)
    scoped: dict[str, list[str]] = defaultdict(list)
    for parent, child in scope_edges(graph):
        if child is not None:
            scoped[parent].append(str(child))
    known: dict[str, frozenset[Family]] = {}
    for root in types:
        entered: set[str] = set()
        stack = [root]
        while stack:
            node = stack[-1]
            inner = scoped[node] if types.get(node) == "logic" else []
            if node not in known and node not in entered:
                entered.add(node)
                stack += [child for child in reversed(inner) if child not in known and child not in entered]
                continue
            if node not in known:
                own = FAMILY_OF_TYPE.get(types.get(node, "")) if types.get(node) != "presence" else None
                known[node] = frozenset({own} if own else ()).union(*(known.get(child, ()) for child in inner))
            stack.pop()
    return {node: next(iter(known[node])) for node in types if len(known[node]) == 1}


def attach_families(graph: Mapping[str, Any], requirements: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """Requirements with their node's family, and a mark on those whose scoped children replace them."""
    families = families_from_graph(graph)
    parents = {parent for parent, _ in scope_edges(graph)}
    attached = []
    for number, requirement in enumerate(records(requirements, "requirements")):
        row, node = dict(requirement), node_name(requirement, number)
        if node in families:
            row["semantic_family"] = families[node]
        if node in parents:
            row["semantic_replaced_by_children"] = True
        attached.append(row)
    return attached
