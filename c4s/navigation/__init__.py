"""Whether a body can use a scene: walkable space, targets, routes, the walker."""

from c4s.navigation.measuring import (
    NavigationEngine,
    NotBuilt,
    agree,
    approachable,
    has_arrived,
    measure,
    measure_snapshot,
)
from c4s.navigation.mesh import NavigationMesh, SpaceMesh
from c4s.navigation.published import published_output, read_published
from c4s.navigation.settings import NavigationSettings, settings_told
from c4s.navigation.space import SpaceTooLarge, WalkableSpace, build_space, warm
from c4s.navigation.walker import judge_walk

__all__ = [
    "NavigationEngine",
    "NavigationMesh",
    "NavigationSettings",
    "NotBuilt",
    "SpaceMesh",
    "SpaceTooLarge",
    "WalkableSpace",
    "agree",
    "approachable",
    "build_space",
    "compiled",
    "has_arrived",
    "judge_walk",
    "measure",
    "measure_snapshot",
    "published_output",
    "read_published",
    "rectangles",
    "selection",
    "settings_told",
    "solids",
    "space",
    "walker",
    "warm",
]
