"""Scoring rows in bulk: each row of the form ``{"kind", "name", "input"}`` gives one result row."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from c4s.errors import BadInput
from c4s.protocol.case import i2s_case, t2s_case
from c4s.protocol.detailed import detailed_from_report, detailed_score
from c4s.protocol.families import attach_families, families_from_graph
from c4s.protocol.numbers import record
from c4s.protocol.overview import overview_from_report, overview_score
from c4s.protocol.physics import physics_from_report
from c4s.protocol.requirements import protocol_detailed, semantic_case
from c4s.score.aggregate import aggregate

Answer = dict[str, Any] | list[dict[str, Any]]


def _t2s_case(row: Mapping[str, Any]) -> Answer:
    return t2s_case(
        valid=bool(row.get("valid")),
        detailed=row.get("detailed"),
        overview=row.get("overview"),
        physics=row.get("physics"),
    )


def _i2s_case(row: Mapping[str, Any]) -> Answer:
    return i2s_case(valid=bool(row.get("valid")), repair_f1=row.get("repair_f1"), physics=row.get("physics_score"))


def _overview(row: Mapping[str, Any]) -> Answer:
    dimensions = row.get("dimension_scores")
    if not isinstance(dimensions, Mapping):
        raise BadInput("overview judgement needs 'dimension_scores'")
    return overview_score(dimensions, row.get("structural_score"), bool(row.get("severe_cap_eligible")))


def _semantic(row: Mapping[str, Any]) -> Answer:
    case = semantic_case(str(row.get("prompt") or ""), row.get("requirements") or [], row.get("family_weights"))
    return {"semantic_case": case, "protocol_detailed": protocol_detailed(case)}


def _graph(row: Mapping[str, Any]) -> Answer:
    graph = record(row.get("graph"), "graph")
    return {"family_map": families_from_graph(graph), "attached": attach_families(graph, row.get("requirements") or [])}


KINDS: dict[str, Callable[[Mapping[str, Any]], Answer]] = {
    "t2s_case": _t2s_case,
    "i2s_case": _i2s_case,
    "physics_report": lambda row: physics_from_report(row.get("report")),
    "overview_judgement": _overview,
    "overview_report": lambda row: overview_from_report(row.get("report")),
    "detailed_decisions": lambda row: detailed_score(row.get("decisions") or []),
    "detailed_report": lambda row: detailed_from_report(row.get("report")),
    "semantic_case": _semantic,
    "semantic_graph": _graph,
    "model": lambda row: aggregate(row.get("rows") or [], row.get("schedule"), bool(row.get("missing_as_zero", True))),
}
"""What each kind of row asks for."""


def score_row(row: Any) -> dict[str, Any]:
    """``{"name", ...result}``, ``{"name", "models": [...]}`` for kind ``model``, or ``{"name", "error"}``."""
    if not isinstance(row, Mapping):
        return {"name": None, "error": "a row must be a JSON object"}
    name, kind, given = row.get("name"), row.get("kind"), row.get("input")
    if kind not in KINDS:
        return {"name": name, "error": f"unknown kind {kind!r} (one of {', '.join(KINDS)})"}
    if not isinstance(given, Mapping):
        return {"name": name, "error": "a row needs an object 'input'"}
    try:
        answer = KINDS[kind](given)
    except BadInput as error:
        return {"name": name, "error": error.line()}
    except RecursionError:
        return {"name": name, "error": "requirements are nested too deep"}
    return {"name": name, "models": answer} if isinstance(answer, list) else {"name": name, **answer}


def score_batch(rows: Iterable[Any]) -> Iterator[dict[str, Any]]:
    """One result row for each row, in order. A bad row is answered with its error and stops nothing."""
    return map(score_row, rows)
