"""Whether a built repair can be solved by looking and scores what it should, measured on what the engine exported."""

from cases.admissible.checks import TargetSighting, sight_refusals, sightings
from cases.admissible.looked import Looked, looked_at
from cases.admissible.refusal import Refusal, Refused, summed
from cases.admissible.scores import score_refusals

__all__ = [
    "Looked",
    "Refusal",
    "Refused",
    "TargetSighting",
    "looked_at",
    "score_refusals",
    "sight_refusals",
    "sightings",
    "summed",
]
