"""Relation words of bundles to the tests of geometry. A word that is not listed here is not decidable by geometry."""

from __future__ import annotations

from typing import Final

INVERSE: Final = "_inverse"
"""Behind a test's name: it holds of the references to the subjects."""
BETWEEN_REFERENCES: Final = "between_references"
SYNONYMS: Final[dict[str, str]] = {
    "on": "on",
    "on_top_of": "on",
    "atop": "on",
    "resting_on": "on",
    "standing_on": "on",
    "placed_on": "on",
    "sits_on": "on",
    "above": "above",
    "over": "above",
    "hanging_over": "above",
    "below": "below",
    "under": "below",
    "beneath": "below",
    "underneath": "below",
    "in": "inside",
    "inside": "inside",
    "within": "inside",
    "near": "near",
    "next_to": "near",
    "beside": "near",
    "by": "near",
    "close_to": "near",
    "adjacent_to": "near",
    "alongside": "near",
    "at": "near",
    "against": "against",
    "leaning_against": "against",
    "apart_from": "apart",
    "away_from": "apart",
    "far_from": "apart",
    "along": "along",
    "lining": "along",
    "lines": "along",
    "between": "between",
    "around": "around",
    "surrounds": "around",
    "surround": "around",
    "surrounding": "around",
    "encloses": "around",
    "encircles": "around",
    "rings": "around",
    "clustered_around": "around",
    "surrounded_by": "around_inverse",
    "enclosed_by": "around_inverse",
    "supports": "on_inverse",
    "contains": "inside_inverse",
    "flanked_by": "between_references",
    "leans_against": "against",
    "touching": "against",
    "crosses": "across",
    "crossing": "across",
    "across": "across",
    "spans": "across",
    "spanning": "across",
    "crossed_by": "across_inverse",
    "spanned_by": "across_inverse",
    "hangs_on": "on",
    "mounted_on": "on",
    "hung_on": "on",
    "parked_on": "on",
    "float_on": "on",
    "floats_on": "on",
    "inside_of": "inside",
    "along_side": "near",
    "in_between": "between",
    "in_a_ring_around": "around",
}
COMPASS: Final[dict[str, tuple[int, int]]] = {"north": (0, 1), "south": (0, -1), "east": (1, 0), "west": (-1, 0)}
"""Sides of a map, before it is turned onto a scene."""


def relation_of(words: str | None) -> str | None:
    """The test that decides a relation of a bundle, by its words; None where none does."""
    return SYNONYMS.get(_joined(words))


def side_of(words: str | None) -> str | None:
    """The side of the compass that a relation names: ``north_of``, ``on_the_north_side_of``; None for another."""
    found = {part for part in _joined(words).split("_") if part in COMPASS}
    return found.pop() if len(found) == 1 else None


def is_measured(words: str | None) -> bool:
    """Whether geometry decides the relation of these words."""
    return relation_of(words) is not None or side_of(words) is not None


def _joined(words: str | None) -> str:
    return "_".join(str(words or "").lower().replace("-", "_").split())
