"""The text-to-scene support rule over many scenes at a time (for comparison with another scorer's rows)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from c4s.verify.support import text_to_scene_support


def support_rows(rows: Iterable[Mapping[str, Any]]) -> Iterator[dict[str, Any]]:
    """For each ``{"name", "scene"}``: ``{"name", actor_count, floating_count, floating_labels, rate, per_actor}``.

    A scene that cannot be measured gives ``{"name", "error"}``.
    """
    for row in rows:
        try:
            support = text_to_scene_support(row["scene"])
        except (ValueError, TypeError, KeyError, AttributeError) as error:
            yield {"name": row.get("name"), "error": f"{type(error).__name__}: {error}"}
            continue
        yield {"name": row.get("name"), "actor_count": support.evaluated, "floating_count": support.floating,
               "floating_labels": support.floating_labels, "rate": support.rate, "per_actor": support.per_actor}
