"""Studies of the paper and our own over the warehouse: one file a study. See DESIGN.md."""

from __future__ import annotations

from typing import Final

from c4s.errors import unknown
from warehouse.analyses.agent_behaviour import EXECUTION_ERRORS, PYTHON_OPERATIONS, TOOL_USAGE
from warehouse.analyses.answers import answer, folder_of, replay, result_of, results_of
from warehouse.analyses.case_difficulty import CASE_DIFFICULTY
from warehouse.analyses.case_ranks import CASE_RANKS
from warehouse.analyses.cohorts import COHORTS
from warehouse.analyses.conditional_spatial import CONDITIONAL_SPATIAL
from warehouse.analyses.costs import COSTS
from warehouse.analyses.difficulty import DIFFICULTY
from warehouse.analyses.drift import DRIFT
from warehouse.analyses.embodied_utility import EMBODIED_UTILITY
from warehouse.analyses.judge_agreement import JUDGE_AGREEMENT
from warehouse.analyses.main_results import MAIN_RESULTS
from warehouse.analyses.paired import PAIRED
from warehouse.analyses.power import POWER_STUDY
from warehouse.analyses.profiles import PROFILES
from warehouse.analyses.public_private import PUBLIC_PRIVATE
from warehouse.analyses.reliability import RELIABILITY
from warehouse.analyses.repair_rates import REPAIR_RATES
from warehouse.analyses.repeats import REPEATS
from warehouse.analyses.scope import StudyScope, WantedScope
from warehouse.analyses.selective_repair import SELECTIVE_REPAIR
from warehouse.analyses.set_selection import SET_SELECTION
from warehouse.analyses.stability import STABILITY
from warehouse.analyses.study import StudyDefinition, StudyOptions
from warehouse.analyses.weight_sensitivity import WEIGHT_SENSITIVITY
from warehouse.analyses.zero_reasons import ZERO_REASONS

__all__ = [
    "STUDIES",
    "StudyDefinition",
    "StudyOptions",
    "StudyScope",
    "WantedScope",
    "answer",
    "folder_of",
    "replay",
    "result_of",
    "results_of",
    "study_named",
]

STUDIES: Final[dict[str, StudyDefinition]] = {
    study.name: study
    for study in (
        MAIN_RESULTS,
        REPAIR_RATES,
        DIFFICULTY,
        PUBLIC_PRIVATE,
        SET_SELECTION,
        WEIGHT_SENSITIVITY,
        CASE_RANKS,
        COSTS,
        ZERO_REASONS,
        COHORTS,
        PROFILES,
        SELECTIVE_REPAIR,
        CONDITIONAL_SPATIAL,
        TOOL_USAGE,
        PYTHON_OPERATIONS,
        EXECUTION_ERRORS,
        PAIRED,
        REPEATS,
        POWER_STUDY,
        STABILITY,
        CASE_DIFFICULTY,
        RELIABILITY,
        EMBODIED_UTILITY,
        JUDGE_AGREEMENT,
        DRIFT,
    )
}
"""By name, in the order in which they are listed."""


def study_named(name: str) -> StudyDefinition:
    """A study; ``BadInput`` for a name that is none."""
    if name not in STUDIES:
        raise unknown("study", name, STUDIES)
    return STUDIES[name]
