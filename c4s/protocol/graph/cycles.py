"""Cycles: no logic is made of itself, and no list of entities holds itself."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from c4s.protocol.graph.report import GraphFinding
from c4s.protocol.graph.view import BundleView


def cycle_faults(view: BundleView) -> Iterator[GraphFinding]:
    """Logic predicates and or-lists that lead back to themselves."""
    for identity in _in_cycles(view.predicates, lambda node: view.operands(node) if node in view.predicates else ()):
        yield GraphFinding("cycles.logic", "error", identity, "its logic leads back to itself")
    members = {identity: entity.get("member_ids") or () for identity, entity in view.entities.items()}
    for identity in _in_cycles(members, lambda node: members.get(node, ())):
        yield GraphFinding("cycles.member", "error", identity, "it is a member of itself")


def _in_cycles(nodes: Iterable[str], after: Callable[[str], Iterable[str]]) -> list[str]:
    """One node of each way that leads back to itself; depth-first without recursion."""
    done: set[str] = set()
    found: list[str] = []
    for root in nodes:
        path: set[str] = set()
        stack: list[tuple[str, Iterator[str]]] = []
        if root not in done:
            path.add(root)
            stack.append((root, iter(after(root))))
        while stack:
            node, rest = stack[-1]
            child = next(rest, None)
            if child is None:
                stack.pop()
                path.discard(node)
                done.add(node)
            elif child in path:
                found.append(child)
            elif child not in done:
                path.add(child)
                stack.append((child, iter(after(child))))
    return found
