"""The requirements of a text as one trial's judge answered them, with the pictures that it was shown."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from reports.frame import SitePicture
from reports.frame.board import Row

DECIDED_BY: Final = {
    "state": "by rule on the scene's state",
    "sight": "by the model from its views",
    "alternate": "by the model after other views",
    "arbitration": "by arbitration between yes and no",
    "combined": "from the claims that it is made of",
}
MOST_PICTURES: Final = 6


@dataclass(frozen=True)
class Requirement:
    """One requirement with its answer."""

    claim: str
    text: str
    kind: str
    family: str
    scored: bool
    answer: str
    value: float | None
    """What it counts after those that hold it back; null where it does not count."""
    held_back: bool
    confidence: float | None
    reason: str
    decided: str
    """How, in words."""
    asked: str
    seen: int | None
    targets: int | None
    pictures: Sequence[tuple[SitePicture, str]]
    """What was shown or taken for it; the second is ``cited``, ``shown``, ``alternate`` or ``taken``."""


def requirement_rows(
    document: Mapping[str, Any], claims: Sequence[Row], pictures: Sequence[SitePicture]
) -> list[Requirement]:
    """Scored requirements in the bundle's order, then those that they are made of; none without a verdict.

    Args:
        document: the verdict of Detailed Alignment.
        claims: what the judge said; a warehouse may lack it.
        pictures: of the claims and of the whole scene.
    """
    measured = document.get("measurements", {})
    weighed = {row["node_id"]: row for row in measured.get("semantic_requirement_aggregation", [])}
    said = {row["claim"]: row for row in claims}
    named = {picture.view: picture for picture in pictures}
    rows = [
        _scored(row, weighed.get(row["node_id"], {}), said.get(row["node_id"], {}), named)
        for row in measured.get("decisions", [])
    ]
    return rows + [_beneath(row, named) for row in claims if not row["scored"]]


def _scored(row: Row, weight: Row, said: Row, named: Mapping[str, SitePicture]) -> Requirement:
    included = weight.get("included", True)
    return Requirement(
        row["node_id"],
        str(row.get("text", row["node_id"])),
        str(row.get("predicate_type", "")).replace("_", " "),
        str(weight.get("semantic_family") or "").replace("_", " "),
        True,
        row["status"],
        weight.get("effective_score") if included else None,
        bool(weight.get("parent_constrained")),
        row.get("confidence"),
        str(row.get("reason") or "") + ("" if included else f" ({_excluded(weight)})"),
        _decided(row.get("stage") or "state", bool(row.get("fallback"))),
        str(said.get("asked", "")),
        row.get("seen_actors"),
        said.get("targets"),
        _pictures(said, named),
    )


def _beneath(said: Row, named: Mapping[str, SitePicture]) -> Requirement:
    return Requirement(
        said["claim"],
        said["text"],
        said["kind"].replace("_", " "),
        "",
        False,
        said["answer"],
        None,
        False,
        said["confidence"],
        said["reason"],
        _decided(said["stage"], said["fallback"]),
        said["asked"],
        said["seen"],
        said["targets"],
        _pictures(said, named),
    )


def _decided(stage: str, fallback: bool) -> str:
    return "unknown: the model broke its answer's contract twice" if fallback else DECIDED_BY.get(stage, stage)


def _excluded(weight: Row) -> str:
    return f"does not count: {str(weight.get('exclusion_reason') or 'excluded').replace('_', ' ')}"


def _pictures(said: Row, named: Mapping[str, SitePicture]) -> list[tuple[SitePicture, str]]:
    shown = dict.fromkeys(str(said.get("shown", "")).split(), "shown")
    found = {
        **{view: "alternate" for view in str(said.get("alternate", "")).split() if view in shown},
        **dict.fromkeys(str(said.get("primary", "")).split(), "taken"),
        **shown,
        **dict.fromkeys(str(said.get("cited", "")).split(), "cited"),
    }
    order = sorted(found, key=lambda view: (("cited", "shown", "taken", "alternate").index(found[view]), view))
    return [(named[view], found[view]) for view in order if view in named][:MOST_PICTURES]
