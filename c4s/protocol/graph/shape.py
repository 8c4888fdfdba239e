"""The fields of a requirement bundle: which there must be, and of what kind. Further fields are left alone."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, TypeAlias

from c4s.files import canonical_json
from c4s.protocol.bundle import MAXIMUM_EDGES, MAXIMUM_NODES, MAXIMUM_PROMPT, MAXIMUM_TEXT
from c4s.protocol.graph.report import GraphFinding
from c4s.protocol.rules import FAMILY_OF_TYPE

Check: TypeAlias = Callable[[Any], str]
"""What is wrong with a value; empty where nothing is."""
OPERATORS = ("any_of", "all_of", "none_of", "or", "and", "not")
TYPES = (*FAMILY_OF_TYPE, "logic")


def _text(value: Any) -> str:
    if not isinstance(value, str) or not value.strip():
        return "is no text"
    return f"has more than {MAXIMUM_TEXT} characters" if len(value) > MAXIMUM_TEXT else ""


def _number(value: Any) -> str:
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        return "is no number"
    return ""


def _whole(value: Any) -> str:
    return "" if isinstance(value, int) and not isinstance(value, bool) and value >= 0 else "is no whole number"


def _span(value: Any) -> str:
    ends = [value.get("start"), value.get("end")] if isinstance(value, Mapping) else value
    if not isinstance(ends, list) or len(ends) != 2 or any(_whole(end) for end in ends) or ends[0] >= ends[1]:
        return "is no span of two places, the first before the second"
    return ""


def _one_of(*values: str) -> Check:
    return lambda value: "" if value in values else f"is {_shown(value)}, not one of {', '.join(values)}"


def _or_null(check: Check) -> Check:
    return lambda value: "" if value is None else check(value)


def _list_of(check: Check, most: int = MAXIMUM_NODES) -> Check:
    def checked(value: Any) -> str:
        if not isinstance(value, list):
            return "is no list"
        if len(value) > most:
            return f"has {len(value)} entries, at most {most} are read"
        wrong = next((fault for fault in map(check, value) if fault), "")
        return f"holds an entry that {wrong}" if wrong else ""

    return checked


def _record(fields: Mapping[str, Check]) -> Check:
    def checked(value: Any) -> str:
        if not isinstance(value, Mapping):
            return "is no record"
        for name, check in fields.items():
            if fault := check(value.get(name)):
                return f"has a field {name!r} that {fault}" if name in value else f"has no field {name!r}"
        return ""

    return checked


def _shown(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


_TEXTS = _list_of(_text)
_SCOPES: Check = lambda value: (  # noqa: E731
    "is no record of texts" if not isinstance(value, Mapping) or any(map(_text, value.values())) else ""
)
_MAPPING: Check = lambda value: "" if isinstance(value, Mapping) else "is no record"  # noqa: E731
QUANTITY = _record(
    {
        "mode": _text,
        "value": _or_null(_number),
        "lower": _or_null(_number),
        "upper": _or_null(_number),
        "qualitative": _or_null(_text),
    }
)
QUALIFIER = _record({"kind": _text, "name": _text, "source_text": _text, "source_span": _span, "occurrence": _whole})
LOGIC = _record({"operator": _one_of(*OPERATORS), "requirement_ids": _TEXTS})
PARAMETERS = _record(
    {
        "requirement_type": _text,
        "relation": _or_null(_text),
        "quantity": _or_null(QUANTITY),
        "qualifiers": _list_of(QUALIFIER),
        "logic": _or_null(LOGIC),
    }
)
NODES: dict[str, dict[str, Check]] = {
    "entity": {
        "id": _text,
        "name": _text,
        "text": _text,
        "source_span": _span,
        "aliases": _TEXTS,
        "entity_type": _text,
        "grounding_mode": _text,
        "referent_kind": _text,
        "member_ids": _or_null(_TEXTS),
    },
    "predicate": {
        "id": _text,
        "name": _text,
        "text": _text,
        "source_span": _span,
        "polarity": _one_of("affirmative", "negative"),
        "predicate_type": _one_of(*TYPES),
        "semantic_parameters": PARAMETERS,
    },
    "requirement": {
        "id": _text,
        "text": lambda value: "" if isinstance(value, str) else "is no text",
        "source_span": _span,
    },
}
EDGES: dict[str, dict[str, Check]] = {
    "argument": {"source_id": _text, "target_id": _text, "role": _text, "ordinal": _whole},
    "scope": {"source_id": _text, "target_id": _text},
    "requirement_member": {
        "source_id": _text,
        "target_id": _text,
        "role": _one_of("scored_facet", "support_only"),
        "weight_fraction": _or_null(_number),
    },
}
REQUIREMENT: dict[str, Check] = {
    "requirement_id": _text,
    "node_id": _text,
    "source_span": _span,
    "source_text": _text,
    "population_scope": _or_null(_text),
    "entity_scopes": _SCOPES,
    "status": _text,
}
EVALUATION: dict[str, Check] = {
    "binding_id": _text,
    "requirement_id": _text,
    "node_id": _text,
    "parameters": _MAPPING,
    "population_scope": _or_null(_text),
    "entity_scopes": _SCOPES,
    "source_provenance": _MAPPING,
}
TOP: dict[str, Check] = {
    "bundle_id": _text,
    "schema_version": _one_of("1.0"),
    "task_mode": _one_of("generation"),
    "provenance": _MAPPING,
    "review": _MAPPING,
}


def shape_faults(bundle: Any) -> Iterator[GraphFinding]:
    """Fields that are missing or of the wrong kind; the other rules need a bundle without."""
    if not isinstance(bundle, Mapping):
        yield _fault("bundle", "it is no record")
        return
    try:
        canonical_json(bundle).encode()
    except (ValueError, RecursionError):
        yield _fault(
            "bundle", "it holds what no file of JSON can: half a surrogate pair, or a number that is not finite"
        )
        return
    yield from _fields(bundle, TOP, "bundle")
    graph = bundle.get("graph")
    if not isinstance(graph, Mapping):
        yield _fault("graph", "it is missing, or no record")
        return
    if graph.get("schema_version") != "2.0":
        yield _fault("graph", f"its schema_version is {_shown(graph.get('schema_version'))}, not 2.0")
    prompt = graph.get("prompt")
    if not isinstance(prompt, str) or not prompt.strip():
        yield _fault("graph", "its prompt is no text")
    elif len(prompt) > MAXIMUM_PROMPT:
        yield _fault("graph", f"its prompt has {len(prompt)} characters, at most {MAXIMUM_PROMPT} are read")
    yield from _rows(graph, "roots", MAXIMUM_NODES, lambda _: {"requirement_id": _text, "weight": _number})
    yield from _rows(graph, "nodes", MAXIMUM_NODES, lambda row: NODES.get(str(row.get("node_type"))))
    yield from _rows(graph, "edges", MAXIMUM_EDGES, lambda row: EDGES.get(str(row.get("edge_type"))))
    yield from _rows(bundle, "requirements", MAXIMUM_NODES, lambda _: REQUIREMENT)
    yield from _rows(bundle, "evaluations", MAXIMUM_NODES, lambda _: EVALUATION)


def _rows(
    owner: Mapping[str, Any], name: str, most: int, fields_of: Callable[[Mapping[str, Any]], dict[str, Check] | None]
) -> Iterator[GraphFinding]:
    rows = owner.get(name)
    if not isinstance(rows, list):
        yield _fault(name, "it is missing, or no list")
        return
    if len(rows) > most:
        yield _fault(name, f"it has {len(rows)} entries, at most {most} are read")
        return
    for number, row in enumerate(rows):
        place = f"{name}[{number}]"
        if not isinstance(row, Mapping):
            yield _fault(place, "it is no record")
            continue
        fields = fields_of(row)
        if fields is None:
            yield _fault(place, "its type is unknown")
            continue
        yield from _fields(row, fields, str(row.get("id") or row.get("requirement_id") or place))


def _fields(row: Mapping[str, Any], fields: Mapping[str, Check], place: str) -> Iterator[GraphFinding]:
    for name, check in fields.items():
        if fault := check(row.get(name)):
            yield _fault(place, f"its {name} {fault}" if name in row else f"it has no {name}")


def _fault(place: str, message: str) -> GraphFinding:
    return GraphFinding("shape", "error", place if len(place) <= 120 else place[:117] + "...", message)
