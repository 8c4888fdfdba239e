"""The optional deterministic planner: validate a scene graph, solve it, draw it, order it, and lay the ground."""

from c4s.planner.ground import ground_tiles
from c4s.planner.picture import render_plan
from c4s.planner.solve import solve, tiers, validate

__all__ = ["ground_tiles", "render_plan", "solve", "tiers", "validate"]
