"""The text-to-scene support rule over many scenes at a time (for comparison with another scorer's rows)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from c4s.verify.physics.support import text_to_scene_support


def support_row(row: Any) -> dict[str, Any]:
    """``{"name", actor_count, floating_count, floating_labels, rate, per_actor}`` of ``{"name", "scene"}``.

    A scene that cannot be measured gives ``{"name", "error"}`` with one line.
    """
    if not isinstance(row, Mapping):
        return {"name": None, "error": "a row must be a JSON object"}
    name, scene = row.get("name"), row.get("scene")
    if not isinstance(scene, Mapping):
        return {"name": name, "error": "a row needs an object 'scene'"}
    try:
        support = text_to_scene_support(scene)
    except ValueError as error:
        return {"name": name, "error": " ".join(str(error).split())}
    return {
        "name": name,
        "actor_count": support.evaluated,
        "floating_count": support.floating,
        "floating_labels": support.floating_labels,
        "rate": support.rate,
        "per_actor": support.per_actor,
    }


def support_rows(rows: Iterable[Any]) -> Iterator[dict[str, Any]]:
    """One result row for each row, in order. A bad row is answered with its error and stops nothing."""
    return map(support_row, rows)
