"""Weights, caps, tolerances and rule identifiers of verdicts and scores, as data. Ids are the published ones where they
exist.

Sources: paper, "Physical Safety", "Score Aggregation and Reporting" and the adopted weights table; scorer facts 3 to
7. The limits and ids of Actor Repair F1 are in ``c4s/protocol/repair.py``, the word lists of the physics roles and of
support beside their rules in ``c4s/verify/actors/roles.py``, ``c4s/verify/physics/support.py`` and
``c4s/verify/physics/edited_support.py``.
"""

from __future__ import annotations

from typing import Final, Literal, TypeAlias

from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, TEXT_TO_SCENE, Setting

GATE: Final = "integrity"
"""The verifier that decides whether a submission is measured at all."""
NO_SUBMISSION: Final = "no_submission"
"""Reason code of an attempt that saved no scene."""
T2S_POLICY: Final = "text-to-scene-human-aligned"
I2S_POLICY: Final = "i2s-actor-f1-0.8-physics-0.2-case-macro.v1"
MODEL_POLICY: Final = "t2s-0.5-i2s-0.5-pooled-case-macro.v2"
PHYSICS_POLICY: Final = "physics-all-leaves-zero.v2"
SEMANTIC_CASE_POLICY: Final = "case-family-clause-macro-missing-zero.v4"
SEMANTIC_FAMILY_POLICY: Final = "family-clause-macro-equal-atomic"
SEMANTIC_CASE_SCHEMA: Final = "scenebenchmark-semantic-case-score.v4"

CASE_POLICY: Final[dict[Setting, str]] = {
    TEXT_TO_SCENE: T2S_POLICY,
    INDOOR_REPAIR: I2S_POLICY,
    OUTDOOR_REPAIR: I2S_POLICY,
}

T2S_WEIGHTS: Final = {"detailed": 0.20, "physics": 0.20, "overview": 0.60}
"""Summed in this order; the case score is rounded to four decimals."""
T2S_DIGITS: Final = 4
I2S_WEIGHTS: Final = {"repair_f1": 0.80, "physics": 0.20}
I2S_DIGITS: Final = 6
MODEL_WEIGHTS: Final = {"t2s": 0.5, "i2s": 0.5}

Family: TypeAlias = Literal["identity_environment", "content_quantity", "attributes_materials", "spatial_composition"]
FAMILY_WEIGHTS: Final[dict[Family, float]] = {
    "identity_environment": 0.25,
    "content_quantity": 0.40,
    "attributes_materials": 0.15,
    "spatial_composition": 0.20,
}
"""In this fixed order."""
DETAILED_DIGITS: Final = 4

_TYPES_OF_FAMILY: Final[dict[Family, tuple[str, ...]]] = {
    "identity_environment": ("scene_identity", "atmosphere", "environment", "style_bundle"),
    "content_quantity": ("existence", "presence", "count", "quantity", "set"),
    "attributes_materials": ("attribute", "material"),
    "spatial_composition": ("spatial_relation", "distribution", "composition", "boundary"),
}
FAMILY_OF_TYPE: Final[dict[str, Family]] = {
    kind: family for family, kinds in _TYPES_OF_FAMILY.items() for kind in kinds
}
COMPOSITE_TYPES: Final = frozenset({"scene_identity", "set", "logic"})
"""Rows of these types give way to the rows inside their span."""
CONJUNCTIVE_TYPES: Final = frozenset(
    {"scene_identity", "spatial_relation", "distribution", "composition", "boundary", "set", "logic"}
)
"""Rows of these types are worth at most what the rows inside their span are worth."""

OVERVIEW_WEIGHTS: Final = {
    "global_prompt_alignment": 0.40,
    "composition_and_layout": 0.25,
    "style_atmosphere_coherence": 0.20,
    "completeness_and_polish": 0.15,
}
STRUCTURE_FLOOR: Final = 0.75
STRUCTURE_SHARE: Final = 0.25
SEVERE_CAP: Final = 0.40
SEVERE_CONFIDENCE: Final = 0.8
SEVERE_VIEWS: Final = 2
OVERVIEW_VIEWS: Final = 4

Direction: TypeAlias = Literal["lower_is_better", "higher_is_better"]
PHYSICS_LEAVES: Final[dict[str, Direction]] = {"floating": "lower_is_better", "solid_penetration": "higher_is_better"}
"""The two leaves, with the direction of a raw score where the report does not tell it."""
T2S_FLOATING_METRIC: Final = "t2s-aabb-floating-contact-5cm.v2"
"""Id of the support rule that replaces the recorded floating leaf in text-to-scene."""
I2S_FLOATING_METRIC: Final = "ground_or_lateral_v1"
"""Id of the support model of edited actors."""
NEAR_BODIES_METRIC: Final = "i2s-edited-support-5cm"
"""Id of the diagnostic beside it: collision bodies within 5 cm below or at the side. It has no weight."""
PENETRATION_METRIC: Final = "eligible_actor_collision_free_rate_v3"
ADAPTIVE_TOLERANCE: Final = "actor_shortest_full_aabb_span_clamped_v1"
FIXED_TOLERANCE: Final = "fixed_declared_tolerance"
"""Ids of the two penetration tolerances: by size in text-to-scene, the same for all in image-to-scene."""
WHOLE_SCENE_PROFILE: Final = "absolute-physical-safety-candidate-all-v3"
EDITED_ACTORS_PROFILE: Final = "image-to-scene-edited-actors-physical-safety"
"""Ids of the two populations of the physics leaves: all actors, and those that a repair edited."""
ROLE_POLICY: Final = "deterministic_scene_relative_physics_roles_v1"
PHYSICS_LEAF_WEIGHTS: Final = {"floating": 0.5, "solid_penetration": 0.5}
PHYSICS_DIGITS: Final = 4
GAP_CM: Final = 5.0
"""Support tolerance of both settings, inclusive."""
PROBE_ABOVE_CM: Final = 2.0
PROBE_BELOW_CM: Final = 5000.0
"""Support of edited actors: lines start this far above an actor's box and end this far below it."""
PROBE_VERTICES: Final = 4096
"""At most about this many vertices of an actor are looked at, evenly picked."""
PROBE_GROUP: Final = 4
PROBE_CROWD: Final = 1000
"""Edited actors are measured in groups of this size in their order, from ``PROBE_CROWD`` on one by one; those of one
group do not support each other."""
PANEL_THINNESS: Final = 4.0
"""A panel is at least this many times as wide and as high as it is thick."""
PANEL_NORMAL_Z: Final = 0.5
PANEL_UPRIGHT_Z: Final = 0.75
"""It stands: its normal rises by at most this, one of its long sides by at least that."""
PANEL_GRID: Final = 5
PANEL_REACH: Final = 0.8
"""Lines a side of each face, spread over this share of it."""
PANEL_START_CM: Final = 0.5
"""They start this far inside the face and end this far beyond the gap."""
PANEL_FACING: Final = 0.8
"""Cosine between a line and the surface that it meets."""
PANEL_SHARE: Final = 0.05
"""Share of the lines of one face that must meet a support."""
PANEL_RATIO: Final = 4.0
"""What holds a panel has a face at least this many times as large."""
TINY_CM: Final = 1.0
"""Actors whose three half extents are all below this are degenerate helpers; plan half extents are at least this."""
FIXED_TOLERANCE_CM: Final = 5.0
"""Penetration: the tolerance in image-to-scene, and the least one in text-to-scene."""
MAXIMUM_TOLERANCE_CM: Final = 50.0
TOLERANCE_SHARE: Final = 0.05
"""Of an actor's shortest box side, which counts as at least ``SHORTEST_SPAN_CM``."""
SHORTEST_SPAN_CM: Final = 10.0

GROUND_SPAN_CM: Final = 200.0
"""Roles: a ground surface spans at least this much both ways and is at most this high."""
PROXY_SPAN_CM: Final = 3000.0
"""Roles: an environment proxy is longer than this, and huge, or many times as long as the median solid."""
PROXY_HUGE_CM: Final = 30_000.0
PROXY_RATIO: Final = 10.0
PROXY_ORIGINS: Final = 3
PROXY_SHARE: Final = 0.05
"""It holds the origins of at least ``PROXY_ORIGINS`` other solids, and of this share of them."""

INTEGRITY_POLICY: Final = "c4s.integrity.v1"
OVERVIEW_RULE_POLICY: Final = "overview-rule-judge.v1"
OVERVIEW_MODEL_POLICY: Final = "overview-two-calls.v1"
"""Ids of how the parts of an overview came about: by rules, or by the two calls of a model."""

UNUSABLE_STATUSES: Final = frozenset({"blocked", "error", "invalid", "not_evaluated", "refused", "unavailable"})
"""A semantic report with such a status (any case) has no score; all other statuses are used."""

DEFAULT_POLICY = "code4scene-published"
"""The published protocol: the weights, tolerances and rules of every verifier's and score's published policy."""

PHYSICS_RATE: Final = "physics"
REPAIR_RATES: Final = {"f1": "repair_f1", "precision": "precision", "recall": "recall", "physics": PHYSICS_RATE}
"""Published short names of what is averaged over repairs, and the fields of a case row that hold it."""
