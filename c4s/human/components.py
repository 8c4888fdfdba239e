"""What a trial's score is made of, as a study saves it, and as statistics read it."""

from __future__ import annotations

from typing import Any

from c4s.errors import BadInput
from c4s.protocol.rules import FAMILY_WEIGHTS, OVERVIEW_WEIGHTS, PHYSICS_LEAF_WEIGHTS
from c4s.records.folder import TrialFolder
from c4s.records.human import SavedCandidate, WeightBlocks
from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.score import policies, rescore
from c4s.stats.human import ADOPTED, SavedOverview, SavedScene, SubscoreWeights, score_under
from c4s.verify.registry import weighed_of


def saved_candidate(candidate: str, trial: TrialFolder) -> SavedCandidate:
    """The components of a trial by its verdicts.

    Raises:
        BadInput: a verdict is missing, or the components do not give the stored score of the adopted weights again.
    """
    stored = TrialScore.read(trial.score)
    verdicts = rescore.read_verdicts(trial, stored)
    numbers: dict[str, float] = {}
    said: dict[str, Any] = {}
    for verifier in weighed_of(stored.setting):
        verdict = verdicts[verifier.name]
        if verdict.status == "measured":
            numbers |= verifier.parts(verdict)
            said |= verdict.measurements
    overview = {name: said["dimensions"][name]["score"] for name in OVERVIEW_WEIGHTS} if "dimensions" in said else None
    made = SavedCandidate(
        candidate=candidate,
        score=_adopted(stored, verdicts),
        families={name: numbers[key] for name in FAMILY_WEIGHTS if (key := f"families.{name}") in numbers},
        dimensions=overview,
        structure=said.get("structural_integrity_score", 0.0),
        capped=bool(said.get("severe_structural_cap_eligible", False)),
        leaves={name: numbers[name] for name in PHYSICS_LEAF_WEIGHTS if name in numbers},
    )
    again = score_under(scene_of(made), ADOPTED)
    if again != made.score:
        raise BadInput(
            f"its components give {again}, its verdicts {made.score}", where=str(trial.root), todo="verify it again"
        )
    return made


def scene_of(saved: SavedCandidate) -> SavedScene:
    """As statistics read it."""
    overview = None
    if saved.dimensions is not None:
        overview = SavedOverview(saved.dimensions, saved.structure, saved.capped)
    return SavedScene(saved.families, overview, saved.leaves)


def weights_of(blocks: WeightBlocks) -> SubscoreWeights:
    """Weights as statistics read them."""
    families = {str(name): weight for name, weight in blocks.families.items()}
    return SubscoreWeights(families, blocks.dimensions, blocks.leaves, blocks.final)


def _adopted(stored: TrialScore, verdicts: dict[str, Verdict]) -> float:
    """The score of a trial under the adopted weights, whatever policy it was scored by."""
    score = rescore.rescored(stored, verdicts, policies.PUBLISHED).score
    return 0.0 if score is None else score
