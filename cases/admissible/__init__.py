"""Whether a built repair can be solved by looking and scores what it should, measured on what the engine exported."""

from cases.admissible.checks import LEAST_PIXELS, TargetSighting, sight_refusals, sightings, unfit
from cases.admissible.looked import FULL, Glanced, Looked, Seen, looked_at, seen_by
from cases.admissible.refusal import Refusal, Refused, summed
from cases.admissible.scores import score_refusals

__all__ = [
    "FULL",
    "LEAST_PIXELS",
    "Glanced",
    "Looked",
    "Refusal",
    "Refused",
    "Seen",
    "TargetSighting",
    "looked_at",
    "score_refusals",
    "seen_by",
    "sight_refusals",
    "sightings",
    "summed",
    "unfit",
]
