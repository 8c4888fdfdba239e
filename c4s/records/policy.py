"""A score policy: what may differ between two scorings of the same evidence, under one id.

What a policy cannot change is what a verdict does not store for every value: which actors are targets, the support and
contact rules, a judge's decisions.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, Literal

from pydantic import Field, field_validator

from c4s.protocol.repair import NOMINAL, ProfileName
from c4s.protocol.rules import FAMILY_WEIGHTS, I2S_WEIGHTS, OVERVIEW_WEIGHTS, PHYSICS_LEAF_WEIGHTS, T2S_WEIGHTS, Family
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
