"""The part of a prompt that its requirements speak of: the description, without the asset palette behind it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

_HEADING = re.compile(r"^[ \t]*=== (?:GROUND|ASSET PALETTE|THE TASK) ===", re.MULTILINE)
PREFIX, FULL = "prefix_before_asset_palette", "full_task_prompt"
"""Kinds of a semantic prompt view, as published."""
SUFFIX_ROLE = "agent_asset_library_not_scene_requirements"


def description_end(prompt: str) -> int:
    """Where the description ends: before the task's first heading, blanks dropped; at the prompt's end without one."""
    heading = _HEADING.search(prompt)
    return len(prompt[: heading.start()].rstrip()) if heading else len(prompt)


def prompt_view(prompt: str) -> dict[str, Any]:
    """The published ``semantic_prompt_view`` of a prompt."""
    end = description_end(prompt)
    if end == len(prompt):
        return {"kind": FULL, "source_span": [0, end]}
    return {
        "kind": PREFIX,
        "source_span": [0, end],
        "excluded_suffix_span": [end, len(prompt)],
        "excluded_suffix_role": SUFFIX_ROLE,
    }


def viewed_span(prompt: str, provenance: Any) -> tuple[int, int]:
    """The span that requirements may point to: as the bundle's provenance says, else as its prompt shows."""
    view = provenance.get("semantic_prompt_view") if isinstance(provenance, Mapping) else None
    span = view.get("source_span") if isinstance(view, Mapping) else None
    if isinstance(span, list) and len(span) == 2 and all(isinstance(v, int) for v in span):
        start, end = span
        if 0 <= start < end <= len(prompt):
            return start, end
    return 0, description_end(prompt)
