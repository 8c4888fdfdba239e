"""The JSON Schemas of a model's answers. What they cannot say is checked in ``contract``."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

from c4s.protocol.paired import PAIRED_WEIGHTS
from c4s.protocol.rules import OVERVIEW_WEIGHTS

Schema = dict[str, Any]
YES, NO, OPEN = "MATCH", "MISMATCH", "UNKNOWN"
PROMPT_ANCHORS: Final = {"absent": 0.0, "weak": 0.25, "partial": 0.5, "mostly": 0.75, "complete": 1.0}
STRUCTURE_ANCHORS: Final = {"unusable": 0.0, "widespread": 0.25, "clear": 0.5, "minor": 0.75, "none": 1.0}
DEFECTS: Final = ("stretching", "shearing", "tearing", "collapse", "fragmentation")
_TEXT: Schema = {"type": "string"}
_NUMBER: Schema = {"type": "number"}


def claims_schema(claims: Sequence[str], views: Sequence[str], *, binary: bool) -> Schema:
    """One answer a claim; ``binary`` leaves no third one."""
    fields: Schema = {
        "claim": {"type": "string", "enum": list(claims)},
        "saw": _TEXT,
        "visible": {"type": "boolean"},
        "views": _list({"type": "string", "enum": list(views)}),
        "answer": {"type": "string", "enum": [YES, NO] if binary else [YES, NO, OPEN]},
        "confidence": _NUMBER,
    }
    if binary:
        del fields["visible"]
    return _object({"answers": _list(_object(fields))})


def prompt_aware_schema() -> Schema:
    """A summary, and a score with its anchor a dimension."""
    rated = _object({"reason": _TEXT, "anchor": {"type": "string", "enum": list(PROMPT_ANCHORS)}, "score": _NUMBER})
    return _object({"summary": _TEXT, **dict.fromkeys(OVERVIEW_WEIGHTS, rated)})


def prompt_free_schema(views: Sequence[str]) -> Schema:
    """A score with its anchor, and a severe defect or none."""
    severe = _object(
        {
            "found": {"type": "boolean"},
            "confidence": _NUMBER,
            "views": _list({"type": "string", "enum": list(views)}),
            "categories": _list({"type": "string", "enum": list(DEFECTS)}),
            "issues": _list(_TEXT),
        }
    )
    return _object(
        {
            "reason": _TEXT,
            "anchor": {"type": "string", "enum": list(STRUCTURE_ANCHORS)},
            "score": _NUMBER,
            "severe": severe,
        }
    )


def paired_schema() -> Schema:
    """A sentence, and a score a dimension."""
    return _object({"difference": _TEXT, **dict.fromkeys(PAIRED_WEIGHTS, _NUMBER)})


def _object(fields: Schema) -> Schema:
    return {"type": "object", "properties": fields, "required": list(fields), "additionalProperties": False}


def _list(item: Schema) -> Schema:
    return {"type": "array", "items": item}
