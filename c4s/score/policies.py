"""The score policies that ship, and those of a file.

A run is scored under the published policy. The others re-score its stored verdicts (``c4s score RUN --policy ID``) and
never replace a published number.
"""

from __future__ import annotations

from pathlib import Path

from c4s.errors import BadInput, unknown
from c4s.files import read_yaml
from c4s.protocol.rules import DEFAULT_POLICY, FAMILY_WEIGHTS, I2S_WEIGHTS, OVERVIEW_WEIGHTS, T2S_WEIGHTS
from c4s.records.policy import ScorePolicy


def _fitted(
    policy_id: str, labels: str, families: tuple[float, ...], overview: tuple[float, ...], detailed: float
) -> ScorePolicy:
    """Weights that the paper's human study fits; for comparison, and for constructions only."""
    return ScorePolicy(
        policy_id=policy_id,
        description=f"Text-to-scene weights fitted to {labels} (paper, human alignment).",
        text_to_scene=dict(zip(T2S_WEIGHTS, (detailed, 0.20, 0.80 - detailed), strict=True)),
        families=dict(zip(FAMILY_WEIGHTS, families, strict=True)),
        overview=dict(zip(OVERVIEW_WEIGHTS, overview, strict=True)),
        text_physics_leaves={"floating": 0.0, "solid_penetration": 1.0},
    )


PUBLISHED = ScorePolicy(policy_id=DEFAULT_POLICY, description="The benchmark's published protocol.")
POLICIES: dict[str, ScorePolicy] = {
    policy.policy_id: policy
    for policy in (
        PUBLISHED,
        ScorePolicy(
            policy_id="strict-tolerance",
            repair_tolerances="strict",
            description="Published weights; repairs accepted within 2.5 cm, 2.5 degrees and 2.5 %.",
        ),
        ScorePolicy(
            policy_id="relaxed-tolerance",
            repair_tolerances="relaxed",
            description="Published weights; repairs accepted within 10 cm, 10 degrees and 10 %.",
        ),
        ScorePolicy(
            policy_id="repair-only",
            image_to_scene=dict(zip(I2S_WEIGHTS, (1.0, 0.0), strict=True)),
            description="A repair is Repair F1 alone; a construction as published.",
        ),
        ScorePolicy(
            policy_id="equal-families",
            families=dict.fromkeys(FAMILY_WEIGHTS, 0.25),
            description="Published weights; the four requirement families count the same.",
        ),
        _fitted("human-fit-individual", "individual preferences", (0.18, 0.30, 0.13, 0.39), (0.0, 0.0, 1.0, 0.0), 0.25),
        _fitted(
            "human-fit-consensus", "the Plackett-Luce consensus", (0.08, 0.20, 0.17, 0.55), (0.10, 0.0, 0.90, 0.0), 0.30
        ),
    )
}
"""Policies that ship, by id."""


def policy_named(name: str) -> ScorePolicy:
    """A shipped policy by its id, or one from a ``.yaml`` or ``.json`` file. ``BadInput`` for anything else."""
    if name in POLICIES:
        return POLICIES[name]
    path = Path(name)
    if path.suffix not in (".yaml", ".yml", ".json"):
        raise unknown("policy", name, POLICIES, todo="or give a policy file")
    policy = ScorePolicy.parse(read_yaml(path), where=str(path))
    if policy.policy_id in POLICIES:
        raise BadInput(f"policy id {policy.policy_id!r} is a shipped one", where=str(path), todo="choose another id")
    return policy
