"""Claims as a model is told them: the requirement's own words and its bundle's names, nothing else."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any, Final

from c4s.errors import BadInput
from c4s.judge.model.requests import told
from c4s.protocol.bundle import Predicate, Requirements

_HEAD: Final = "Claims:\n"
_AGAIN: Final = (
    "An earlier answer to these claims could not be used ({kinds}). Answer each of them exactly once, with the fields "
    "and the names that are given here.\n\n"
)
Sheet = dict[str, Any]


def claims_text(sheets: Sequence[Sheet], broken: Mapping[str, str]) -> str:
    """The claims of a request as its text tells them; ``broken`` says how an earlier answer broke its contract."""
    again = _AGAIN.format(kinds=", ".join(sorted(set(broken.values())))) if broken else ""
    return f"{again}{_HEAD}{told(sheets)}"


def sheets_in(text: str) -> list[Sheet]:
    """The claims that a text tells. ``BadInput`` where it tells none."""
    _, found, sheets = text.partition(_HEAD)
    try:
        value = json.loads(sheets) if found else None
    except ValueError:
        value = None
    if not isinstance(value, list) or not all(isinstance(sheet, dict) for sheet in value):
        raise BadInput("this request tells no claims")
    return value


def claim_sheet(requirements: Requirements, node: str, name: str, views: Sequence[str]) -> Sheet:
    """One claim.

    Args:
        requirements: of the case.
        node: id of the claim's predicate.
        name: what the claim is called in the request.
        views: the views that were taken for it, as the request names them.
    """
    predicate = requirements.predicates[node]
    sheet: Sheet = {
        "claim": name,
        "requirement": predicate.text,
        "kind": predicate.type.replace("_", " "),
        "about": [_entity(requirements, entity) for entity in predicate.subjects],
    }
    if predicate.references:
        sheet["in relation to"] = [_entity(requirements, entity) for entity in predicate.references]
    if predicate.relation:
        sheet["relation"] = predicate.relation.replace("_", " ")
    if predicate.quantity:
        sheet["amount"] = _amount(predicate)
    if predicate.qualifiers:
        sheet["qualities"] = [f"{kind}: {words}" for kind, words in predicate.qualifiers]
    if predicate.negative:
        sheet["denied"] = True
    sheet["views"] = list(views)
    return sheet


def _entity(requirements: Requirements, entity_id: str) -> dict[str, Any]:
    found = requirements.entities.get(entity_id)
    if found is None:
        return {"name": entity_id.replace("_", " ")}
    told: dict[str, Any] = {"name": found.names[0], "is": found.kind}
    if len(found.names) > 1:
        told["other names"] = list(found.names[1:])
    if found.collection:
        told["several"] = True
    return told


def _amount(predicate: Predicate) -> dict[str, Any]:
    given = predicate.quantity or {}
    kept = ("mode", "value", "lower", "upper", "qualitative", "unit")
    return {name: given[name] for name in kept if given.get(name) is not None}
