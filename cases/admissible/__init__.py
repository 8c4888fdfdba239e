"""Whether a built repair can be solved by looking and scores what it should, measured on what the engine exported."""

from cases.admissible.checks import Refusal, Refused, TargetSighting, refusals, sightings
from cases.admissible.looked import Looked, looked_at

__all__ = ["Looked", "Refusal", "Refused", "TargetSighting", "looked_at", "refusals", "sightings"]
