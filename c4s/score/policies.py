"""Score policies as records: what may differ between two scorings of the same evidence, under one id.

A run is scored under the published policy. The others re-score its stored verdicts (``c4s score RUN --policy ID``) and
never replace a published number. What a policy cannot change is what a verdict does not store for every value: which
actors are targets, the support and contact rules, a judge's decisions.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal

import yaml
from pydantic import Field, field_validator

from c4s.errors import BadInput
from c4s.protocol.repair import NOMINAL, ProfileName
from c4s.protocol.rules import (
    DEFAULT_POLICY,
    FAMILY_WEIGHTS,
    I2S_WEIGHTS,
    OVERVIEW_WEIGHTS,
    PHYSICS_LEAF_WEIGHTS,
    T2S_WEIGHTS,
    Family,
)
from c4s.protocol.settings import Setting, is_construction
from c4s.records.base import Record

_NAMES: dict[str, Mapping[str, float]] = {
    "text_to_scene": T2S_WEIGHTS,
    "image_to_scene": I2S_WEIGHTS,
    "overview": OVERVIEW_WEIGHTS,
    "physics_leaves": PHYSICS_LEAF_WEIGHTS,
    "text_physics_leaves": PHYSICS_LEAF_WEIGHTS,
}
_SUM_GUARD = 1e-9


class ScorePolicy(Record):
    """Weights and tolerances of a scoring. What is left out is as published."""

    schema_version: Literal["c4s.policy.v1"] = "c4s.policy.v1"
    policy_id: str = Field(pattern=r"^[a-z0-9][a-z0-9.-]*$")
    description: str = ""
    text_to_scene: dict[str, float] = Field(default_factory=lambda: dict(T2S_WEIGHTS))
    """Weights of ``detailed``, ``physics`` and ``overview``; they sum to 1."""
    image_to_scene: dict[str, float] = Field(default_factory=lambda: dict(I2S_WEIGHTS))
    """Weights of ``repair_f1`` and ``physics``; they sum to 1."""
    families: dict[Family, float] = Field(default_factory=lambda: dict(FAMILY_WEIGHTS))
    """Weights of the requirement families; renormalised over those that a prompt asks for, so all are positive."""
    overview: dict[str, float] = Field(default_factory=lambda: dict(OVERVIEW_WEIGHTS))
    """Weights of the four prompt dimensions; they sum to 1."""
    physics_leaves: dict[str, float] = Field(default_factory=lambda: dict(PHYSICS_LEAF_WEIGHTS))
    """Weights of ``floating`` and ``solid_penetration``; they sum to 1."""
    text_physics_leaves: dict[str, float] | None = None
    """The same for text-to-scene, where they differ there."""
    repair_tolerances: ProfileName = NOMINAL.name
    """Acceptance limits of Repair F1 (``c4s/protocol/repair.py``)."""

    @field_validator("text_to_scene", "image_to_scene", "overview", "physics_leaves", "text_physics_leaves")
    @classmethod
    def _complete(cls, value: dict[str, float] | None, info: Any) -> dict[str, float] | None:
        if value is None:
            return None
        names = _NAMES[info.field_name]
        if set(value) != set(names):
            raise ValueError(f"needs exactly the weights {', '.join(names)}")
        if not min(value.values()) >= 0 or not math.isclose(math.fsum(value.values()), 1.0, abs_tol=_SUM_GUARD):
            raise ValueError("weights must not be negative and must sum to 1")
        return {name: value[name] for name in names}

    @field_validator("families")
    @classmethod
    def _all_families(cls, value: dict[Family, float]) -> dict[Family, float]:
        if set(value) != set(FAMILY_WEIGHTS):
            raise ValueError(f"needs exactly the weights {', '.join(FAMILY_WEIGHTS)}")
        if not all(weight > 0 and math.isfinite(weight) for weight in value.values()):
            raise ValueError("weights must be positive")
        return {name: value[name] for name in FAMILY_WEIGHTS}

    def weights(self, setting: Setting) -> dict[str, float]:
        """Component weights of a setting's case score."""
        return self.text_to_scene if is_construction(setting) else self.image_to_scene

    def leaves(self, setting: Setting) -> dict[str, float]:
        """Weights of the physics leaves in a setting."""
        own = self.text_physics_leaves if is_construction(setting) else None
        return own or self.physics_leaves


def _fitted(
    policy_id: str, labels: str, families: tuple[float, ...], overview: tuple[float, ...], detailed: float
) -> ScorePolicy:
    """Weights that the paper's human study fits; for comparison, and for text-to-scene only."""
    return ScorePolicy(
        policy_id=policy_id,
        description=f"Text-to-scene weights fitted to {labels} (paper, human alignment).",
        text_to_scene={"detailed": detailed, "physics": 0.20, "overview": 0.80 - detailed},
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
            image_to_scene={"repair_f1": 1.0, "physics": 0.0},
            description="Image-to-scene is Repair F1 alone; text-to-scene as published.",
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
    if path.suffix not in (".yaml", ".yml", ".json") or not path.is_file():
        raise BadInput(f"unknown policy {name!r}", todo=f"use one of {', '.join(POLICIES)}, or a policy file")
    try:
        value = yaml.safe_load(path.read_text(encoding="utf-8"))
    except (yaml.YAMLError, OSError, UnicodeDecodeError) as error:
        raise BadInput(f"this policy is not valid YAML: {' '.join(str(error).split())}", where=str(path)) from None
    policy = ScorePolicy.parse(value, where=str(path))
    if policy.policy_id in POLICIES:
        raise BadInput(f"policy id {policy.policy_id!r} is a shipped one", where=str(path), todo="choose another id")
    return policy
