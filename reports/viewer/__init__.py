"""Scenes in three dimensions: the files that a page loads, and what it tells without them."""

from __future__ import annotations

from reports.viewer.difference import Difference, differences
from reports.viewer.part import ScenePart, TrialScene, scene_part
from reports.viewer.three import three_script

__all__ = ["Difference", "ScenePart", "TrialScene", "differences", "scene_part", "three_script"]
