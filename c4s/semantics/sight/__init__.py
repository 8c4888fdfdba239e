"""Where to look: the overview views of a scene, the views of the actors that single claims need, and those of repairs.

Pure: what a camera would see is told by a probe that the caller gives. See ``DESIGN.md``.
"""

from c4s.semantics.sight.overviews import overview_plan
from c4s.semantics.sight.pairs import Target, target_cameras
from c4s.semantics.sight.plan import sight_plan

__all__ = [
    "Target",
    "candidates",
    "clearance",
    "looks",
    "needs",
    "overview_plan",
    "overviews",
    "pairs",
    "plan",
    "scene",
    "sight_plan",
    "target_cameras",
]
