"""The human study in numbers: its blocks, consensus, agreement, and weights fitted to preferences. See
docs/human-study.md."""

from c4s.stats.human.agreement import (
    ALPHA_DRAWS,
    DRAWS,
    MacroMean,
    Progress,
    between_annotators,
    between_groups,
    krippendorff_alpha,
    left_out,
    macro_mean,
    rho_by_prompt,
    tau_by_prompt,
    with_scores,
)
from c4s.stats.human.blocks import BLOCK_SIZE, POINTS, RankedBlock, blocks, fano_plane, split
from c4s.stats.human.consensus import L2, TIE, consensus, log_worths
from c4s.stats.human.fitting import PROPOSALS, SEED, Objective, PolicyStanding, WeightFit, fit, proposals
from c4s.stats.human.preferences import HumanOrder, PairVotes, Preferences
from c4s.stats.human.scoring import SavedOverview, SavedScene, SceneTable, policy_scores, score_under
from c4s.stats.human.weights import ADOPTED, SubscoreWeights, feasible

__all__ = [
    "ADOPTED",
    "ALPHA_DRAWS",
    "BLOCK_SIZE",
    "DRAWS",
    "L2",
    "POINTS",
    "PROPOSALS",
    "SEED",
    "TIE",
    "HumanOrder",
    "MacroMean",
    "Objective",
    "PairVotes",
    "PolicyStanding",
    "Preferences",
    "Progress",
    "RankedBlock",
    "SavedOverview",
    "SavedScene",
    "SceneTable",
    "SubscoreWeights",
    "WeightFit",
    "between_annotators",
    "between_groups",
    "blocks",
    "consensus",
    "fano_plane",
    "feasible",
    "fit",
    "krippendorff_alpha",
    "left_out",
    "log_worths",
    "macro_mean",
    "policy_scores",
    "proposals",
    "rho_by_prompt",
    "score_under",
    "split",
    "tau_by_prompt",
    "with_scores",
]
