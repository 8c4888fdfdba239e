"""Grounding: every text is the prompt's own, at the place that is told, in the part that describes the scene."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from c4s.protocol.graph.report import GraphFinding
from c4s.protocol.graph.view import BundleView, ends


def grounding_faults(view: BundleView) -> Iterator[GraphFinding]:
    """Texts that are not the prompt's at their span, spans outside the description, rows that tell another span."""
    for node in view.all_nodes:
        yield from _grounded(view, node["id"], node["source_span"], node["text"])
    for identity in view.predicates:
        for qualifier in view.parameters(identity)["qualifiers"]:
            yield from _qualifier(view, identity, qualifier)
    for row in (*view.requirements, *view.evaluations):
        if row["node_id"] not in view.predicates:
            continue
        node = view.predicates[row["node_id"]]
        span = row["source_span"] if "source_span" in row else row["source_provenance"].get("source_span")
        if not isinstance(span, list) or tuple(span) != ends(node["source_span"]):
            yield _fault("grounding.row", row["requirement_id"], "its span is not that of its predicate")
        if row.get("source_text", node["text"]) != node["text"]:
            yield _fault("grounding.row", row["requirement_id"], "its text is not that of its predicate")


def _grounded(view: BundleView, place: str, span: Any, text: str) -> Iterator[GraphFinding]:
    start, end = ends(span)
    if view.prompt[start:end] != text or end > len(view.prompt):
        there = f"where it says {_short(view.prompt[start:end])!r}" if end <= len(view.prompt) else "past its end"
        yield _fault("grounding.text", place, f"the prompt does not say {_short(text)!r} at {start} to {end}, {there}")
    elif not view.view[0] <= start < end <= view.view[1]:
        yield _fault("grounding.view", place, f"{_short(text)!r} lies outside the description of the scene")


def _qualifier(view: BundleView, place: str, qualifier: Any) -> Iterator[GraphFinding]:
    text, (start, end) = qualifier["source_text"], ends(qualifier["source_span"])
    faults = list(_grounded(view, place, qualifier["source_span"], text))
    yield from faults
    if faults:
        return
    if qualifier["occurrence"] not in occurrences(view.prompt, text, start):
        yield GraphFinding(
            "grounding.occurrence",
            "warning",
            place,
            f"{_short(text)!r} at {start} is not occurrence {qualifier['occurrence']} of it in the prompt",
        )
    first, last = ends(view.nodes[place]["source_span"])
    if not first <= start < end <= last:
        yield GraphFinding(
            "grounding.qualifier", "warning", place, f"its qualifier {_short(text)!r} stands outside its own words"
        )


def occurrences(prompt: str, text: str, start: int) -> set[int]:
    """Which occurrence of a text stands at ``start`` (0 is the first): counted as letters, and as whole words."""
    letters = prompt.count(text, 0, start)
    if not letters:
        return {0}
    words = re.compile(rf"(?<!\w){re.escape(text)}(?!\w)")
    return {letters, sum(1 for _ in words.finditer(prompt, 0, start))}


def _short(text: str) -> str:
    return text if len(text) <= 80 else text[:77] + "..."


def _fault(rule: str, place: str, message: str) -> GraphFinding:
    return GraphFinding(rule, "error", place, message)
