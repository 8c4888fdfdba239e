"""What annotators of the human study are asked (paper, ``sec:human-alignment``): one primary question, six diagnostic
ones, and which part of a score each is compared with."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal, TypeAlias

from c4s.protocol.rules import Family

CriterionName: TypeAlias = Literal[
    "overall-task-success",
    "identity-and-environment",
    "content-and-quantity",
    "spatial-composition",
    "attributes-and-materials",
    "holistic-overview-alignment",
    "physical-plausibility",
]


@dataclass(frozen=True)
class HumanCriterion:
    """One question."""

    title: str
    question: str
    part: Family | Literal["case", "overview", "physics"]
    """The part of a score that it is compared with; ``case`` is the whole."""


SPLIT_SEED: Final = 20_260_915
"""Of the split into development and holdout, and of the fits."""
PRIMARY: Final[CriterionName] = "overall-task-success"
"""Asked for itself: no diagnostic ranking goes into it."""
CRITERIA: Final[dict[CriterionName, HumanCriterion]] = {
    PRIMARY: HumanCriterion(
        "Overall Task Success", "Which scene, all in all, does best what the description asks for?", "case"
    ),
    "identity-and-environment": HumanCriterion(
        "Identity and Environment",
        "Which scene is most clearly the place, and has most clearly the surroundings, that the description names?",
        "identity_environment",
    ),
    "content-and-quantity": HumanCriterion(
        "Content and Quantity",
        "Which scene holds best the things that the description names, in the numbers that it names?",
        "content_quantity",
    ),
    "spatial-composition": HumanCriterion(
        "Spatial Composition",
        "In which scene do things stand best where, and to each other as, the description says?",
        "spatial_composition",
    ),
    "attributes-and-materials": HumanCriterion(
        "Attributes and Materials",
        "In which scene do things look best as the description says: colours, materials, sizes, states?",
        "attributes_materials",
    ),
    "holistic-overview-alignment": HumanCriterion(
        "Holistic Overview Alignment",
        "Which scene as a whole, seen from all four sides, fits the description best and looks most finished?",
        "overview",
    ),
    "physical-plausibility": HumanCriterion(
        "Physical Plausibility",
        "In which scene is least to be seen that floats without support or is stuck in something else?",
        "physics",
    ),
}
